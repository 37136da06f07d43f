// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/measured_rings.h"

#include <array>
#include <cmath>

#include "geometry/polygon2.h"
#include "modelling/arc_tangency.h"
#include "modelling/chain_parts.h"
#include "modelling/edge_adjust.h"
#include "modelling/edge_blocks.h"
#include "modelling/ring_nodes.h"

namespace jalon {

namespace {

// Points within 3 sigma lie on the plane; those beyond 4 sigma belong to what meets it there.
constexpr double kOnPlane = 3, kOffPlane = 4, kLeastSigma_m = 0.001;
// A corner cut by the triangulation is a run of at most a gap between two edges; a little more for noise.
constexpr double kChamfer = 1.3;
constexpr int kPasses = 2;  // the second counts from where the first put the edge
constexpr double kPolylineStep = 0.3;  // rad
constexpr size_t kClasses = 4;

struct Draft {
  const Chain* chain;
  std::vector<MeasuredEdge> edges;
  std::vector<EdgeInformation> information;
};

// A short part between two longer ones that would meet beside it is a cut corner.
void drop_chamfers(std::vector<EdgeShape>& shapes, double reach_m) {
  for (size_t i = 0; i < shapes.size() && shapes.size() > 3;) {
    const size_t n = shapes.size();
    const EdgeShape &a = shapes[(i + n - 1) % n], &b = shapes[i], &c = shapes[(i + 1) % n];
    Vec2 corner;
    const bool is_cut = !a.is_arc && !b.is_arc && !c.is_arc && b.length_m <= reach_m && a.length_m > b.length_m &&
                        c.length_m > b.length_m && intersect(a.line, c.line, 0.3, corner) &&
                        norm(corner - b.first) <= reach_m && norm(corner - b.last) <= reach_m;
    if (is_cut)
      shapes.erase(shapes.begin() + static_cast<ptrdiff_t>(i));
    else
      ++i;
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
Draft make_draft(const Chain& chain, bool is_opening, const Contour& contour, const VectoriseSetting& setting) {
  const double p = contour.spacing_m;
  const auto parts = split_chain(chain, {p, setting.arcs});
  std::vector<EdgeShape> shapes;
  bool has_arc = false;
  for (const ChainPart& part : parts) {
    shapes.push_back(shape_of(chain, part, p, setting.direction_angle_rad, setting.straight.snap_angle_rad));
    has_arc = has_arc || part.is_arc;
  }
  drop_chamfers(shapes, kChamfer * contour.max_edge_m);
  if (is_opening && setting.straight.rectangles && !has_arc && shapes.size() != 4)
    if (auto sides = rectangle_shapes(chain, contour.max_edge_m, p); !sides.empty()) shapes = std::move(sides);
  Draft draft{&chain, std::vector<MeasuredEdge>(shapes.size()), std::vector<EdgeInformation>(shapes.size())};
  for (size_t i = 0; i < shapes.size(); ++i) draft.edges[i].shape = shapes[i];
  return draft;
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

// Step 3.
void measure(std::vector<Draft>& drafts, const NearPoints& near, const PointRows& contours, double min_height_m,
             const EdgeSetting& adjust, Task& task) {
  for (int pass = 0; pass < kPasses; ++pass) {
    std::array<std::vector<const MeasuredEdge*>, kClasses> classes;
    for (Draft& draft : drafts)
      for (MeasuredEdge& edge : draft.edges) {
        task.checkpoint(0);
        collect_blocks(near, contours, adjust.spacing_m, min_height_m, edge);
        classes[static_cast<size_t>(edge.shape.direction)].push_back(&edge);
      }
    std::array<CountingVariance, kClasses> variance;
    for (size_t c = 0; c < kClasses; ++c) variance[c] = counting_variance(classes[c], adjust.spacing_m, adjust.sigma_m);
    for (Draft& draft : drafts)
      for (size_t i = 0; i < draft.edges.size(); ++i) {
        MeasuredEdge& edge = draft.edges[i];
        draft.information[i] = adjust_edge(adjust, variance[static_cast<size_t>(edge.shape.direction)], edge);
      }
  }
}

// Steps 4 and 5.
VectorRing draw(const Draft& draft, const Contour& contour) {
  const size_t n = draft.edges.size();
  std::vector<EdgeShape> shapes;
  for (const MeasuredEdge& edge : draft.edges) shapes.push_back(edge.shape);
  for (size_t i = 0; i < n && n > 2; ++i)
    touch_jambs(draft.information[i], contour.spacing_m, shapes[(i + n - 1) % n], shapes[i], shapes[(i + 1) % n]);
  VectorRing ring;
  const double reach = kChamfer * contour.max_edge_m + 2 * contour.spacing_m;
  if (!join_edges(shapes, contour.spacing_m, reach, ring)) return {};
  // The area that the contour encloses, give or take its distance from the true edge.
  const double area = signed_area(ring), wanted = signed_area(*draft.chain);
  if ((area > 0) != (wanted > 0)) return {};
  if (std::fabs(area - wanted) > contour.max_edge_m * perimeter(ring.corners)) return {};
  ring.contour = *draft.chain;
  return ring;
}

}  // namespace

std::vector<VectorRing> measured_rings(const RingSource& source, const VectoriseSetting& setting, Task& task) {
  const Contour& contour = source.contour;
  std::vector<Draft> drafts;
  std::vector<std::vector<Vec2>> chains, rings;
  for (const ContourPiece& piece : contour.pieces)
    for (size_t k = 0; k <= piece.openings.size(); ++k) {
      task.checkpoint(0);
      const Chain& chain = k == 0 ? piece.outline : piece.openings[k - 1];
      drafts.push_back(make_draft(chain, k > 0, contour, setting));
      rings.push_back(polyline(drafts.back()));
      chains.push_back(chain);
    }
  const double sigma = std::max(source.sigma_m, kLeastSigma_m);
  const NearSetting about{(kStripInward + 1) * contour.spacing_m, std::max(setting.reveal_depth_m, kOnPlane * sigma),
                          kOnPlane * sigma};
  const NearPoints near = source.near(rings, about);
  task.checkpoint(0);
  const PointRows others = contour_points(chains, contour.spacing_m);
  measure(drafts, near, others, kOffPlane * sigma,
          {contour.spacing_m, sigma, about.window_m, setting.reveal_depth_m > 0, setting.straight.snap_angle_rad},
          task);
  std::vector<VectorRing> out;
  for (const Draft& draft : drafts) out.push_back(draw(draft, contour));
  return out;
}

}  // namespace jalon
