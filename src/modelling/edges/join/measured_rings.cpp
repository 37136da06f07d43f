// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/join/measured_rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/polygon2.h"
#include "modelling/edges/adjust/arc_tangency.h"
#include "modelling/edges/adjust/edge_adjust.h"
#include "modelling/edges/adjust/edge_alignment.h"
#include "modelling/edges/adjust/edge_blocks.h"
#include "modelling/edges/find/chain_parts.h"
#include "modelling/edges/find/guided_steps.h"
#include "modelling/edges/find/ransac_parts.h"
#include "modelling/edges/find/straighten.h"
#include "modelling/edges/join/form_sides.h"
#include "modelling/edges/join/ring_nodes.h"

namespace jalon {

namespace {

// Points within 3 sigma lie on the plane; those beyond 4 sigma belong to what meets it there.
constexpr double kOnPlane = 3, kOffPlane = 4, kLeastSigma_m = 0.001;
// A corner cut by the triangulation is a run of at most a gap between two edges; a little more for noise.
constexpr double kChamfer = 1.3;
constexpr double kBridge = 2;  // the gap grows with the local spacing: contour_band.cpp
constexpr double kAgainst = -0.95, kLeastEnd = 1.5;  // cosine; spacings
constexpr double kWeak = 12;       // spacings: shorter edges may lie on a line of others
constexpr double kArcSigma = 0.5;  // spacings
constexpr double kShadowLength = 24, kShadowShare = 0.4;  // spacings; of the shorter edge beside it
constexpr int kPasses = 2;             // the second counts from where the first put the edge
constexpr int kArcPasses = 6;          // more, of arcs only, until they move by less than
constexpr double kSettled = 0.05;      // spacings
constexpr double kPolylineStep = 0.3;  // rad
constexpr size_t kClasses = 4;

struct Draft {
  const Chain* chain;
  bool is_opening;
  std::vector<MeasuredEdge> edges;
  std::vector<EdgeInformation> information;
  const VectorRing* form = nullptr;      ///< what it is to be drawn as; else by its edges
  std::vector<MeasuredEdge> sides = {};  ///< of that
  bool is_settled() const { return form != nullptr; }
};

// A short part between two longer ones that would meet beside it is a cut corner.
void drop_chamfers(std::vector<EdgeShape>& shapes, double reach_m) {
  for (size_t i = 0; i < shapes.size() && shapes.size() > 3;) {
    const size_t n = shapes.size();
    const EdgeShape &a = shapes[(i + n - 1) % n], &b = shapes[i], &c = shapes[(i + 1) % n];
    const auto corner = intersect(a.line, c.line, 0.3);
    const bool is_short =
        b.length_m <= reach_m && a.length_m > b.length_m && c.length_m > b.length_m;
    const bool is_cut = !a.is_arc && !b.is_arc && !b.is_guided && !c.is_arc && is_short && corner &&
                        norm(*corner - b.first) <= reach_m && norm(*corner - b.last) <= reach_m &&
                        dot(a.line.direction, *corner - a.first) > 0 &&
                        dot(c.line.direction, c.last - *corner) > 0;
    if (is_cut) shapes.erase(shapes.begin() + static_cast<ptrdiff_t>(i));
    else ++i;
  }
}

// Shadows beside an opening's corner (of a sill's ends, say) take solid away: up to three short parts that leave two
// upright edges and come back to them, none of them inside both, give way to the corner of those edges.
bool is_shadowed_corner(const EdgeShape& a, std::span<const EdgeShape> between, const EdgeShape& c,
                        double spacing_m) {
  if (a.is_arc || c.is_arc || a.direction == c.direction ||
      a.direction == EdgeDirection::kInclined || c.direction == EdgeDirection::kInclined)
    return false;
  double length = 0;
  for (const EdgeShape& b : between) {
    length += b.length_m;
    for (const Vec2& p : {b.first, b.last})
      if (b.is_arc || std::max(a.line.distance(p), c.line.distance(p)) < -spacing_m) return false;
  }
  return length <=
         std::min(kShadowLength * spacing_m, kShadowShare * std::min(a.length_m, c.length_m));
}

void close_shadowed_corners(std::vector<EdgeShape>& shapes, double spacing_m) {
  for (size_t i = 0; i < shapes.size(); ++i)
    for (size_t count = std::min<size_t>(3, shapes.size() - std::min<size_t>(shapes.size(), 3));
         count > 0; --count) {
      const size_t n = shapes.size();
      std::vector<EdgeShape> between;
      for (size_t k = 1; k <= count; ++k) between.push_back(shapes[(i + k) % n]);
      if (!is_shadowed_corner(shapes[i], between, shapes[(i + count + 1) % n], spacing_m)) continue;
      std::rotate(shapes.begin(), shapes.begin() + static_cast<ptrdiff_t>(i), shapes.end());
      shapes.erase(shapes.begin() + 1, shapes.begin() + 1 + static_cast<ptrdiff_t>(count));
      i = 0;
      break;
    }
}

// A post ends between its sides: two lines that run against each other get the edge across that joins them.
void insert_ends(std::vector<EdgeShape>& shapes, double spacing_m, const GuideLines* guides) {
  for (size_t i = 0; i < shapes.size() && shapes.size() > 2; ++i) {
    const EdgeShape &a = shapes[i], &b = shapes[(i + 1) % shapes.size()];
    if (a.is_arc || b.is_arc || dot(a.line.direction, b.line.direction) > kAgainst) continue;
    const Vec2 along = a.line.direction;
    const double end = std::max(dot(along, a.last - a.first), dot(along, b.first - a.first)) +
                       kSetBack * spacing_m;
    const Vec2 from = a.at(end, 0);
    Vec2 to = b.line.foot(from);
    if (along.u == 0) to.v = from.v;  // to the last bit
    if (along.v == 0) to.u = from.u;
    if (norm(to - from) < kLeastEnd * spacing_m) continue;
    EdgeShape end_shape = straight_shape(from, to);
    if (guides != nullptr) follow_guide(*guides, spacing_m, a, b, end_shape);
    shapes.insert(shapes.begin() + static_cast<ptrdiff_t>(i + 1), end_shape);
  }
}

// Four sides for an opening whose ragged contour fills an upright rectangle.
std::vector<EdgeShape> rectangle_shapes(const Chain& chain, double max_edge_m, double spacing_m) {
  StraightenSetting s;
  s.max_edge_m = max_edge_m;
  s.tolerance_m = max_edge_m / 2;
  s.set_back_m = kSetBack * spacing_m;
  const Polygon corners = fitted_rectangle(chain, s);
  std::vector<EdgeShape> out;
  for (size_t i = 0; i < corners.size(); ++i)
    out.push_back(straight_shape(corners[i], corners[(i + 1) % corners.size()]));
  return out;
}

// Step 1.
Draft make_draft(const Chain& chain, bool is_opening, bool arcs, const Contour& contour,
                 const VectoriseSetting& setting, const GuideLines* guides) {
  const double p = contour.spacing_m;
  const auto parts =
      setting.lines == LineMethod::kRansac
          ? ransac_parts(chain, {.spacing_m = p,
                                 .arcs = arcs,
                                 .tolerance_m = setting.line_tolerance_m,
                                 .gap_m = setting.line_gap_m,
                                 .min_points = setting.line_min_points,
                                 .seed = setting.line_seed})
          : split_chain(chain, {p, arcs, guides, kSetBack * p, kBridge * contour.max_edge_m});
  std::vector<EdgeShape> shapes;
  bool has_arc = false;
  for (const ChainPart& part : parts) {
    shapes.push_back(shape_of(chain, part, p, setting.direction_angle_rad, setting.snap_angle_rad));
    has_arc = has_arc || part.is_arc;
  }
  drop_chamfers(shapes, kChamfer * contour.max_edge_m);
  if (is_opening) close_shadowed_corners(shapes, p);
  insert_ends(shapes, p, guides);
  if (guides != nullptr) guide_steps(*guides, p, shapes);
  if (is_opening && setting.rectangles && !has_arc && shapes.size() != 4)
    if (auto sides = rectangle_shapes(chain, contour.max_edge_m, p); !sides.empty())
      shapes = std::move(sides);
  const size_t n = shapes.size();
  Draft draft{&chain, is_opening, std::vector<MeasuredEdge>(n), std::vector<EdgeInformation>(n)};
  for (size_t i = 0; i < n; ++i) draft.edges[i].shape = shapes[i];
  return draft;
}

// Short edges lie on the lines of others where that explains their points (guide_lines.h).
void follow_guides(std::vector<Draft>& drafts, std::span<const Chain> chains,
                   const RingSource& source, const VectoriseSetting& setting) {
  const Contour& contour = source.contour;
  std::vector<EdgeShape> shapes;
  for (const Draft& draft : drafts)
    for (const MeasuredEdge& edge : draft.edges) shapes.push_back(edge.shape);
  const GuideLines guides(shapes, source.joints(), chains, contour.spacing_m);
  if (guides.empty()) return;
  for (Draft& draft : drafts) {
    const bool is_weak =
        std::any_of(draft.edges.begin(), draft.edges.end(), [&](const MeasuredEdge& edge) {
          return !edge.shape.is_arc && (edge.shape.length_m < kWeak * contour.spacing_m ||
                                        edge.shape.upright_angle() > 0);
        });
    if (is_weak && !draft.is_settled())
      draft = make_draft(*draft.chain, draft.is_opening, setting.arcs, contour, setting, &guides);
  }
}

// Step 2: where to look.
std::vector<Vec2> polyline(const Draft& draft) {
  std::vector<Vec2> out;
  for (const MeasuredEdge& edge : draft.edges) {
    const EdgeShape& s = edge.shape;
    const double pieces = s.is_arc ? std::ceil(s.length_m / (s.circle.radius * kPolylineStep)) : 1;
    for (double k = 0; k < pieces; ++k) out.push_back(s.at(s.length_m * k / pieces, 0));
  }
  return out;
}

// Largest distance of the edge's ends and middle from where it was before.
double distance_m(const EdgeShape& before, const EdgeShape& now) {
  double worst = 0;
  for (const double share : {0.0, 0.5, 1.0})
    worst = std::max(worst, std::fabs(now.local(before.at(share * before.length_m, 0)).v));
  return worst;
}

// The reveal of an arc drawn too flat or too round is seen only in part: it shows more of itself from each better
// place.
template <class F>
void settle_arcs(std::vector<Draft>& drafts, double spacing_m, F&& adjust) {
  for (Draft& draft : drafts)
    for (size_t i = 0; i < draft.edges.size() && !draft.is_settled(); ++i)
      for (int pass = 0; pass < kArcPasses && draft.edges[i].shape.is_arc; ++pass) {
        const EdgeShape before = draft.edges[i].shape;
        draft.information[i] = adjust(draft.edges[i]);
        if (distance_m(before, draft.edges[i].shape) <= kSettled * spacing_m) break;
      }
}

// Step 3.
void measure(std::vector<Draft>& drafts, const NearPoints& near, const PointRows& contours,
             double min_height_m, const EdgeSetting& adjust, Task& task) {
  std::array<CountingVariance, kClasses> variance;
  const auto collect = [&](MeasuredEdge& edge) {
    task.checkpoint(0);
    collect_blocks(near, contours, adjust.spacing_m, min_height_m, edge);
  };
  // Without points about them edges keep their place, with the sigma of contours.
  const auto adjusted = [&](MeasuredEdge& edge) {
    return adjust_edge(adjust, variance[static_cast<size_t>(edge.shape.direction)], edge);
  };
  for (int pass = 0; pass < kPasses; ++pass) {
    std::array<std::vector<const MeasuredEdge*>, kClasses> classes;
    for (Draft& draft : drafts)
      for (MeasuredEdge& edge : draft.edges) {
        if (draft.is_settled()) continue;
        collect(edge);
        classes[static_cast<size_t>(edge.shape.direction)].push_back(&edge);
      }
    for (size_t c = 0; c < kClasses; ++c)
      variance[c] = counting_variance(classes[c], adjust.spacing_m, adjust.sigma_m);
    for (Draft& draft : drafts)
      for (size_t i = 0; i < draft.edges.size(); ++i)
        draft.information[i] = adjusted(draft.edges[i]);
    for (Draft& draft : drafts)
      for (MeasuredEdge& side : draft.sides) {
        collect(side);
        move_to_reveal(adjust, side);
      }
  }
  settle_arcs(drafts, adjust.spacing_m, [&](MeasuredEdge& edge) {
    collect(edge);
    return adjusted(edge);
  });
}

// An arc that nothing but a ragged contour speaks for.
bool has_doubtful_arc(const Draft& draft, double spacing_m) {
  return !draft.is_settled() &&
         std::any_of(draft.edges.begin(), draft.edges.end(), [&](const MeasuredEdge& edge) {
           const EdgeShape& s = edge.shape;
           return s.is_arc &&
                  (s.source == EdgeSource::kContour || !(s.sigma_m <= kArcSigma * spacing_m));
         });
}

// Steps 4 and 5.
VectorRing draw(const Draft& draft, const Contour& contour) {
  if (draft.form != nullptr) {
    VectorRing ring = with_sides(*draft.form, draft.sides);
    ring.contour = *draft.chain;
    return ring;
  }
  const size_t n = draft.edges.size();
  std::vector<EdgeShape> shapes;
  for (const MeasuredEdge& edge : draft.edges) shapes.push_back(edge.shape);
  for (size_t i = 0; i < n && n > 2; ++i)
    touch_jambs(draft.information[i], contour.spacing_m, shapes[(i + n - 1) % n], shapes[i],
                shapes[(i + 1) % n]);
  const double reach = std::max(kChamfer * contour.max_edge_m, kShadowLength * contour.spacing_m);
  std::optional<VectorRing> ring = join_edges(shapes, contour.spacing_m, reach);
  if (!ring) return {};
  // The area that the contour encloses, give or take its distance from the true edge.
  const double area = signed_area(*ring), wanted = signed_area(*draft.chain);
  if ((area > 0) != (wanted > 0)) return {};
  if (std::fabs(area - wanted) > contour.max_edge_m * perimeter(ring->corners)) return {};
  ring->contour = *draft.chain;
  return std::move(*ring);
}

}  // namespace

std::vector<VectorRing> measured_rings(const RingSource& source, const VectoriseSetting& setting,
                                       Task& task) {
  const Contour& contour = source.contour;
  std::vector<Draft> drafts;
  std::vector<std::vector<Vec2>> chains, rings;
  for (const ContourPiece& piece : contour.pieces)
    for (size_t k = 0; k <= piece.openings.size(); ++k) {
      task.checkpoint(0);
      const Chain& chain = k == 0 ? piece.outline : piece.openings[k - 1];
      drafts.push_back(make_draft(chain, k > 0, setting.arcs, contour, setting, nullptr));
      if (k > 0 && !piece.forms.empty() && !piece.forms[k - 1].corners.empty())
        drafts.back().form = &piece.forms[k - 1],
        drafts.back().sides = sides_of(piece.forms[k - 1]);
      chains.push_back(chain);
    }
  if (setting.lines == LineMethod::kBestCuts) follow_guides(drafts, chains, source, setting);
  for (const Draft& draft : drafts) rings.push_back(polyline(draft));
  const double sigma = std::max(source.sigma_m, kLeastSigma_m);
  const NearSetting about{(kStripInward + 1) * contour.spacing_m,
                          std::max(setting.reveal_depth_m, kOnPlane * sigma), kOnPlane * sigma};
  const NearPoints near = source.near(rings, about);
  task.checkpoint(0);
  const PointRows others = contour_points(chains, contour.spacing_m, task);
  const EdgeSetting edges{contour.spacing_m, sigma, about.window_m, setting.reveal_depth_m > 0,
                          setting.snap_angle_rad};
  measure(drafts, near, others, kOffPlane * sigma, edges, task);
  std::vector<Draft> again;
  for (Draft& draft : drafts) {
    if (!has_doubtful_arc(draft, contour.spacing_m)) continue;
    draft = make_draft(*draft.chain, draft.is_opening, false, contour, setting, nullptr);
    again.clear();
    again.push_back(std::move(draft));
    measure(again, near, others, kOffPlane * sigma, edges, task);
    draft = std::move(again[0]);
  }
  std::vector<MeasuredEdge*> all;
  for (Draft& draft : drafts)
    for (MeasuredEdge& edge : draft.is_settled() ? draft.sides : draft.edges) all.push_back(&edge);
  align_edges(all, contour.spacing_m);
  std::vector<VectorRing> out;
  for (const Draft& draft : drafts) out.push_back(draw(draft, contour));
  return out;
}

}  // namespace jalon
