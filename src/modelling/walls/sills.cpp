// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/sills.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers.h"
#include "modelling/edges/adjust/bar_edge.h"
#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

constexpr double kSillsParallel = 0.985;  // 10 degrees, as walls of one facade
constexpr double kLeastSpan = 0.8;        // of the hole's width
constexpr double kLowestShare = 0.3;      // of the hole's height, where its upper edge may be
constexpr double kFlare_spacings =
    4;  // above it, where the hole narrows from the sill's width to its own
constexpr double kSillsSteep = 3;        // |dv| / |du| of a jamb
constexpr double kFront_spacings = 0.5;  // nearer to the wall's plane a surface is the wall's own

constexpr double kEdgeSigma = 0.3;   // spacings, of an edge drawn from its last row of points
constexpr size_t kLeastPoints = 10;  // of a front without a plane of its own
constexpr double kStrays = 0.02;     // share of them that may lie beyond either edge
constexpr double kColumns =
    0.6;  // share of the hole's width, in columns of two spacings, where they lie
constexpr double kReach_spacings = 1.5;  // of an edge, from where it was taken to be
constexpr double kEdgeNoise = 0.05;  // spacings: of the edge itself and of points along the wall
constexpr double kSetBack_spacings =
    0.35;  // of the last row of points from the edge: 0.5 on grids, 0.2 at random

/// The front of a sill in the wall's coordinates.
struct Sill {
  RingBox box;
  double sigma_m;  ///< of its upper edge
};

std::vector<Sill> sills_before(const std::vector<VectorPlane>& planes, size_t wall,
                               double front_m) {
  const PlaneFrame& frame = planes[wall].frame;
  std::vector<Sill> out;
  for (size_t p = 0; p < planes.size(); ++p) {
    if (p == wall || planes[p].faces.empty() ||
        dot(planes[p].frame.normal, frame.normal) < kSillsParallel)
      continue;
    for (const VectorFace& face : planes[p].faces) {
      Sill sill{{}, kNaN};
      double in_front = 0;
      for (const Vec2& corner : face.outline.corners) {
        const Vec3 at = planes[p].frame.lift(corner);
        sill.box.add(frame.project(at));
        in_front += dot(at - frame.origin, frame.normal) - frame.height;
      }
      in_front /= static_cast<double>(face.outline.corners.size());
      if (in_front < kFront_spacings * planes[wall].spacing_m || in_front > front_m) continue;
      if (sill.box.height() > kMostSillHeight_m) continue;
      for (const VectorEdge& edge : face.outline.edges)
        if (edge.direction == EdgeDirection::kHorizontal) sill.sigma_m = edge.sigma_m;
      out.push_back(sill);
    }
  }
  return out;
}

/// The highest sill at the hole's foot.
std::optional<Sill> sill_of(const RingBox& hole, const std::vector<Sill>& sills) {
  const Sill* best = nullptr;
  for (const Sill& sill : sills) {
    const double common =
        std::min(hole.high.u, sill.box.high.u) - std::max(hole.low.u, sill.box.low.u);
    const double top = sill.box.high.v;
    if (common < kLeastSpan * hole.width() || top <= hole.low.v) continue;
    if (top > hole.low.v + kLowestShare * hole.height()) continue;
    if (best == nullptr || top > best->box.high.v) best = &sill;
  }
  return best != nullptr ? std::optional(*best) : std::nullopt;
}

/// The points before the hole's foot where they make a level bar.
std::optional<Sill> sill_of_points(const RingBox& hole, const HoleSurvey& survey,
                                   double tolerance_m, double front_m, double spacing_m) {
  std::vector<double> levels;
  std::vector<int64_t> columns;
  std::vector<double> behind;
  for (const HolePoint& p : survey.points) {
    if (p.w < -tolerance_m) behind.push_back(p.v);
    if (p.w <= tolerance_m || p.w > front_m || p.v > hole.low.v + kLowestShare * hole.height())
      continue;
    levels.push_back(p.v);
    if (p.u > hole.low.u && p.u < hole.high.u)
      columns.push_back(static_cast<int64_t>((p.u - hole.low.u) / (2 * spacing_m)));
  }
  if (levels.size() < kLeastPoints) return {};
  std::sort(levels.begin(), levels.end());
  const auto last = static_cast<double>(levels.size() - 1);
  const auto at = [&](double share) { return levels[static_cast<size_t>(share * last)]; };
  const double foot = at(kStrays), top = at(1 - kStrays);
  if (top - foot > kMostSillHeight_m) return {};
  // A rail or a flower box with the opening going on below it is no sill.
  const auto below =
      std::count_if(behind.begin(), behind.end(), [&](double v) { return v < foot - spacing_m; });
  if (static_cast<double>(below) > kStrays * static_cast<double>(behind.size())) return {};
  std::sort(columns.begin(), columns.end());
  const auto filled =
      static_cast<double>(std::unique(columns.begin(), columns.end()) - columns.begin());
  if (filled * 2 * spacing_m < kColumns * hole.width()) return {};
  return Sill{{{hole.low.u, foot}, {hole.high.u, top + kSetBack_spacings * spacing_m}},
              kEdgeSigma * spacing_m};
}

/// Points of the sill's front before the hole: those at the middle one's distance from the wall.
std::vector<Vec2> front_points(const RingBox& hole, const HoleSurvey& survey, double tolerance_m,
                               double front_m, double spacing_m, const Sill& sill) {
  std::vector<float> heights;
  std::vector<const HolePoint*> near;
  for (const HolePoint& p : survey.points)
    if (p.w > tolerance_m && p.w <= front_m && p.v > sill.box.low.v - spacing_m &&
        p.v < sill.box.high.v + kReach_spacings * spacing_m && p.u > hole.low.u &&
        p.u < hole.high.u) {
      near.push_back(&p);
      heights.push_back(p.w);
    }
  if (near.size() < kLeastPoints) return {};
  const auto middle = heights.begin() + static_cast<ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  std::vector<Vec2> front;
  for (const HolePoint* p : near)
    if (std::fabs(p->w - *middle) <= tolerance_m / 2) front.push_back({p->u, p->v});
  return front;
}

/// The upper edge from the points of the front, where they tell it better.
void refine(std::span<const Vec2> front, double spacing_m, Sill& sill) {
  const auto edge = upper_edge(front, spacing_m, kEdgeNoise * spacing_m);
  if (!edge || edge->sigma_m >= sill.sigma_m) return;
  sill.box.high.v = edge->at_m;
  sill.sigma_m = edge->sigma_m;
}

/// Where a jamb that goes up from a to b, prolonged, crosses the level.
double foot_of(const Vec2& a, const Vec2& b, double level) {
  const Vec2 d = b - a;
  return std::fabs(d.v) > kSillsSteep * std::fabs(d.u) ? a.u + d.u * (level - a.v) / d.v : b.u;
}

/// The ring (anticlockwise) from this level on: what lies above the flare, and the jambs down to the level. Nothing
/// when it comes in more than one piece.
std::optional<VectorRing> ended_at(const VectorRing& ring, double level, double flare_m,
                                   double sigma_m) {
  const size_t n = ring.corners.size();
  const auto above = [&](size_t i) { return ring.corners[i % n].v > level + flare_m; };
  size_t first = n, runs = 0;  // the first corner above, after one below
  for (size_t i = 0; i < n; ++i)
    if (!above(i) && above(i + 1)) first = (i + 1) % n, ++runs;
  if (runs != 1) return {};
  size_t count = 1;
  while (above(first + count)) ++count;
  const size_t right = (first + n - 1) % n, last = (first + count - 1) % n;
  if (ring.edges[right].sagitta_m != 0 || ring.edges[last].sagitta_m != 0) return {};
  const double u1 = foot_of(ring.corners[right], ring.corners[first], level);
  const double u0 = foot_of(ring.corners[(last + 1) % n], ring.corners[last], level);
  if (!(u1 > u0)) return {};
  VectorRing out;
  VectorEdge foot;
  foot.direction = EdgeDirection::kHorizontal;
  foot.sigma_m = sigma_m;
  out.corners = {{u0, level}, {u1, level}};
  out.edges = {foot, ring.edges[right]};
  for (size_t k = 0; k < count; ++k) {
    out.corners.push_back(ring.corners[(first + k) % n]);
    out.edges.push_back(ring.edges[(first + k) % n]);
  }
  out.contour = ring.contour;
  return out;
}

}  // namespace

void end_at_sills(std::vector<VectorPlane>& planes, size_t wall, const WallSurvey& survey,
                  double front_m, std::vector<WallHole>& holes) {
  const std::vector<Sill> sills = sills_before(planes, wall, front_m);
  const double spacing_m = planes[wall].spacing_m;
  for (size_t h = 0; h < holes.size(); ++h) {
    WallHole& hole = holes[h];
    if (hole.is_notch) continue;
    const RingBox box = ring_box(hole.outline);
    auto sill = sill_of(box, sills);
    if (!sill) sill = sill_of_points(box, survey.holes[h], survey.tolerance_m, front_m, spacing_m);
    if (!sill) continue;
    refine(front_points(box, survey.holes[h], survey.tolerance_m, front_m, spacing_m, *sill),
           spacing_m, *sill);
    const auto ended =
        ended_at(hole.outline, sill->box.high.v, kFlare_spacings * spacing_m, sill->sigma_m);
    if (!ended || !is_simple(*ended, spacing_m)) continue;
    const VectorRing before = reversed(hole.outline);
    for (VectorRing& ring : planes[wall].faces[hole.piece].openings)
      if (ring.corners == before.corners) ring = reversed(*ended);
    hole.outline = *ended;
    hole.ends_at_sill = true;
  }
}

}  // namespace jalon
