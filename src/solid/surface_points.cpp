// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/surface_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/numbers.h"
#include "base/parallel.h"
#include "base/serial.h"
#include "spatial/octree/walk.h"

namespace jalon {

namespace {

/// Corners of the surface whose nearest point bounds the search from above.
constexpr size_t kProbes = 256;
constexpr double kSurfacePointsRounding_m = 1e-9;
constexpr size_t kBallsPerLook = 1 << 10;
constexpr size_t kSurfacePointsPerLook = 1 << 16;

// Step 1: some point is at most this far from the surface.
double first_bound(const PartSurface& surface, const Octree& octree) {
  const std::span<const std::array<uint32_t, 3>> triangles = surface.boxes().triangles();
  const size_t step = std::max<size_t>(1, triangles.size() / kProbes);
  double best = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < triangles.size(); i += step) {
    Neighbour nearest;
    octree.knn(surface.boxes().vertices()[triangles[i][0]], 1, {&nearest, 1});
    best = std::min(best, std::sqrt(nearest.squared_distance));
  }
  return best;
}

// Step 2: the points of all leaves that may hold one within the limit, or one inside.
std::vector<uint32_t> candidates(const PartSurface& surface, const Octree& octree, double limit,
                                 Task& task) {
  std::vector<uint32_t> out;
  const std::span<const uint32_t> order = octree.order();
  // Balls about one and the same place, of points on one another, are asked once.
  Vec3 place{kNaN, kNaN, kNaN};
  size_t asked = 0;
  TriangleAnswer answer;
  walk_octree(
      octree,
      [&](const BoundingBall& ball, double& key) {
        if (asked++ % kBallsPerLook == 0) task.checkpoint(0);
        if (!(ball.centre == place)) {
          place = ball.centre;
          answer = surface.nearest().nearest(place, std::numeric_limits<double>::infinity(),
                                             {surface.is_closed(), false});
        }
        key = answer.distance;
        return answer.distance <= limit + ball.radius_m ||
               (surface.is_closed() && answer.is_behind);
      },
      [&](size_t first, size_t last) {
        out.insert(out.end(), order.begin() + first, order.begin() + last);
      });
  return out;
}

bool precedes(const NearPoint& a, const NearPoint& b) {
  return a.distance_m < b.distance_m || (a.distance_m == b.distance_m && a.point < b.point);
}

}  // namespace

PointClearance clearance_of_points(const PartSurface& surface, const Octree& octree,
                                   std::span<const double> xyz, double margin_m, Task& task) {
  const double limit = std::max(margin_m, first_bound(surface, octree)) + kSurfacePointsRounding_m;
  const std::vector<uint32_t> order = candidates(surface, octree, limit, task);

  // Step 3: their distances.
  const bool closed = surface.is_closed();
  Buffer<NearPoint> found(order.size());
  std::vector<uint32_t> place(order.size());
  Buffer<double> picked(3 * order.size());
  serial_for(task, order.size(), kSurfacePointsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      place[i] = static_cast<uint32_t>(i);
      std::copy_n(xyz.data() + 3 * static_cast<size_t>(order[i]), 3, picked.data() + 3 * i);
    }
  });
  surface.nearest().for_each(picked, place, std::numeric_limits<double>::infinity(), {closed, true},
                             task, [&](uint32_t item, const TriangleAnswer& answer) {
                               const bool inside = closed && answer.is_behind;
                               found[item] = {order[item], answer.triangle,
                                              inside ? -answer.distance : answer.distance,
                                              answer.foot};
                             });

  PointClearance result;
  result.least = found[0];
  size_t near = 0;
  serial_for(task, found.size(), kSurfacePointsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const NearPoint& p = found[i];
      if (precedes(p, result.least)) result.least = p;
      result.inside += p.distance_m < 0;
      near += p.distance_m <= margin_m;
    }
  });
  result.near.reserve(near);
  serial_for(task, found.size(), kSurfacePointsPerLook, [&](size_t begin, size_t end) {
    std::copy_if(found.begin() + begin, found.begin() + end, std::back_inserter(result.near),
                 [&](const NearPoint& p) { return p.distance_m <= margin_m; });
  });
  serial_sort(task, result.near.begin(), result.near.end(),
              [](const NearPoint& a, const NearPoint& b) { return a.point < b.point; });
  return result;
}

}  // namespace jalon
