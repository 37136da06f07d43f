// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/surface_pair.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "solid/fcl_distance.h"
#include "solid/nearest_point.h"
#include "solid/surface_depth.h"

namespace jalon {

namespace {

using SurfacePairCorners = std::array<Vec3, 3>;

constexpr double kSurfacePairRounding_m = 1e-9;

// Where the sides of one triangle pierce the other, added up (Moeller & Trumbore 1997).
void add_piercings(const SurfacePairCorners& sides, const SurfacePairCorners& t, Vec3& sum,
                   int& count) {
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0];
  for (size_t k = 0; k < 3; ++k) {
    const Vec3 from = sides[k], along = sides[(k + 1) % 3] - from, h = cross(along, e2);
    const double det = dot(e1, h);
    if (det == 0) continue;
    const Vec3 s = from - t[0], q = cross(s, e1);
    const double u = dot(s, h) / det, v = dot(along, q) / det, w = dot(e2, q) / det;
    if (u < 0 || v < 0 || u + v > 1 || w < 0 || w > 1) continue;
    sum += from + along * w;
    ++count;
  }
}

// The middle of the line in which two triangles meet; of two in one plane any point of both.
Vec3 meeting_point(const SurfacePairCorners& a, const SurfacePairCorners& b,
                   const Vec3& otherwise) {
  const Vec3 origin = a[0];
  SurfacePairCorners p = a, q = b;
  for (size_t k = 0; k < 3; ++k) p[k] -= origin, q[k] -= origin;
  Vec3 sum;
  int count = 0;
  add_piercings(p, q, sum, count);
  add_piercings(q, p, sum, count);
  return count > 0 ? origin + sum / count : otherwise;
}

NearTriangle measured(uint32_t i, const SurfacePairCorners& a, uint32_t j,
                      const SurfacePairCorners& b) {
  NearTriangle pair{i, j, 0, {}, {}};
  pair.distance_m = triangle_distance(a, b, pair.first_point, pair.second_point);
  return pair;
}

// The triangle of the other surface nearest to one, if it is within the limit; ties by index.
std::optional<NearTriangle> nearest_to(uint32_t i, const SurfacePairCorners& a,
                                       const TriangleBoxes& other, double limit) {
  std::optional<NearTriangle> best;
  other.walk(
      [&](const BoundingBall& ball, double& key) {
        key =
            norm(ball.centre - nearest_on_triangle(ball.centre, a[0], a[1], a[2])) - ball.radius_m;
        return key <= limit;
      },
      [&](uint32_t j) {
        const NearTriangle pair = measured(i, a, j, other.corners(j));
        if (pair.distance_m > limit || (best && pair.distance_m == limit && j > best->second))
          return;
        best = pair;
        limit = pair.distance_m;
      });
  if (best && best->distance_m == 0)
    best->first_point = best->second_point =
        meeting_point(a, other.corners(best->second), best->first_point);
  return best;
}

void take_depth(const PartSurface& surface, const PartSurface& closed, double tolerance_m,
                Task& task, PairClearance& result) {
  if (!closed.is_closed()) return;
  const Depth depth = depth_in(surface, closed, tolerance_m, task);
  if (result.depth_m >= depth.depth_m) return;
  result.depth_m = depth.depth_m;
  result.deepest = depth.point;
  result.deepest_foot = depth.foot;
}

bool lies_in(const PartSurface& surface, const PartSurface& closed) {
  return closed.is_closed() && closed.nearest().nearest(surface.boxes().corners(0)[0]).is_behind;
}

}  // namespace

PairClearance clearance_of_surfaces(const PartSurface& first, const PartSurface& second,
                                    const PairSettings& settings, Task& task) {
  require_fcl();
  // 1. The nearest pair; the others need not be looked for beyond it and the margin.
  const TrianglePair start = nearest_pair(first.boxes(), second.boxes());
  const double limit = std::max(settings.margin_m, start.distance_m) + kSurfacePairRounding_m;

  // 2. Every triangle of the first against its nearest of the second.
  constexpr size_t kGrain = 64;
  std::vector<std::optional<NearTriangle>> found(first.boxes().size());
  parallel_for(task, found.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto t = static_cast<uint32_t>(i);
      found[i] = nearest_to(t, first.boxes().corners(t), second.boxes(), limit);
    }
  });
  PairClearance result;
  result.least = {start.first, start.second, start.distance_m, start.first_point,
                  start.second_point};
  bool fresh = true;
  for (const auto& pair : found) {
    if (!pair) continue;
    if (fresh || pair->distance_m < result.least.distance_m) result.least = *pair;
    fresh = false;
    if (pair->distance_m <= settings.margin_m) result.near.push_back(*pair);
  }

  // 3. How deep, where there is an inside.
  result.meet = result.least.distance_m == 0 || lies_in(first, second) || lies_in(second, first);
  result.depth_m = first.is_closed() || second.is_closed() ? 0 : kNaN;
  if (result.meet) {
    take_depth(first, second, settings.depth_tolerance_m, task, result);
    take_depth(second, first, settings.depth_tolerance_m, task, result);
  }
  return result;
}

}  // namespace jalon
