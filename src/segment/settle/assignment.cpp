// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/assignment.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "segment/ransac/curved_hypotheses.h"
#include "segment/settle/each_surface.h"

namespace jalon {

namespace {

constexpr size_t kAssignmentPointsPerChunk = 1 << 14;
constexpr size_t kPointsPerBlock = 64;
// Of the octree's cube: far above the rounding of a distance, far below any tolerance.
constexpr double kReachSlack = 1e-12;
constexpr size_t kPointsPerStretch = 1 << 17;
constexpr double kLeastSigma =
    0.04;  // of the tolerance: noise-free planes do not pull points from noisy ones
constexpr double kLeastArea_m2 = 1e-6;

struct Patch {
  Plane plane;
  Curved curved;  ///< instead of the plane, where it exists
  double core_m = 0;
  double weight = 0;    ///< 1 / sigma^2
  double evidence = 0;  ///< 2 ln(sigma / density)
  FlatFrame frame;
  SurfaceMap map;  ///< instead of the frame, for a curved surface
  Raster mask;     ///< the surface's pixels and their neighbours; empty without connectivity
  Box3 box;

  bool reaches(const Vec3& p) const {
    if (mask.size() == 0) return true;
    return mask.holds(curved.exists() ? map(p) : frame(p));
  }
  double distance(const Vec3& p) const {
    return curved.exists() ? curved.distance(p) : plane.distance(p);
  }
  bool inconsistent(const SegmentScene& scene, size_t position, double min_cosine) const {
    return curved.exists() ? curved_inconsistent(scene, curved, position)
                           : scene.inconsistent(position, plane.normal, min_cosine);
  }
};

// The surface's pixels, and the box of its points.
Raster image_of(const SegmentScene& scene, const Surface& surface, Patch& patch, Task& task) {
  const auto& positions = surface.positions;
  patch.box = parallel_reduce(task, positions.size(), kAssignmentPointsPerChunk, Box3{},
                              [&](size_t begin, size_t end) {
                                Box3 part;
                                for (size_t i = begin; i < end; ++i)
                                  part.add(scene.local(positions[i]));
                                return part;
                              });
  if (surface.is_plane()) {
    patch.frame = plane_frame(surface.plane, scene.local(positions[0]));
    const auto at = [&](size_t i) { return patch.frame(scene.local(positions[i])); };
    return bounded_raster_of(positions.size(), at, surface.pixel_m, 1, task);
  }
  std::vector<Vec3> points(positions.size());
  for (size_t i = 0; i < points.size(); ++i) points[i] = scene.local(positions[i]);
  patch.map = surface.curved.map(points);
  std::vector<Vec2> uv(points.size());
  for (size_t i = 0; i < uv.size(); ++i) uv[i] = patch.map(points[i]);
  return bounded_raster(uv, surface.pixel_m, 1, task);
}

Patch patch_of(const SegmentScene& scene, const Surface& surface, Task& task) {
  const double tolerance = scene.settings.distance_tolerance_m;
  Patch patch;
  patch.plane = surface.plane;
  patch.curved = surface.curved;
  patch.core_m = core_reach(scene.settings, surface.sigma_m);
  const double sigma = std::max(surface.sigma_m, kLeastSigma * tolerance);
  patch.weight = 1 / (sigma * sigma);
  const double density =
      static_cast<double>(surface.positions.size()) / std::max(surface.area_m2, kLeastArea_m2);
  patch.evidence = 2 * std::log(sigma / density);
  if (!scene.settings.connectivity) {
    patch.box = Box3{{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
    return patch;
  }
  patch.mask = dilated(image_of(scene, surface, patch, task), 1);
  const double margin = 2 * surface.pixel_m + tolerance;
  for (int k = 0; k < 3; ++k) {
    patch.box.min[k] -= margin;
    patch.box.max[k] += margin;
  }
  return patch;
}

bool overlap(const Box3& a, const Box3& b) {
  for (int k = 0; k < 3; ++k)
    if (a.min[k] > b.max[k] || b.min[k] > a.max[k]) return false;
  return true;
}

// Could a point of the box be within the tolerance of the patch, and on its raster? Never no where one is.
bool may_reach(const Box3& box, const Patch& patch, double reach_m) {
  if (!overlap(box, patch.box)) return false;
  if (patch.curved.exists()) return true;
  const Vec3 half = 0.5 * (box.max - box.min);
  const Vec3& n = patch.plane.normal;
  const double wide =
      std::fabs(n.x) * half.x + std::fabs(n.y) * half.y + std::fabs(n.z) * half.z + reach_m;
  return std::fabs(patch.plane.distance(box.min + half)) <= wide;
}

Box3 box_of(const SegmentScene& scene, size_t begin, size_t end) {
  Box3 box;
  for (size_t i = begin; i < end; ++i) box.add(scene.local(i));
  return box;
}

// Owner of one point among the patches near its block; 0 = none. The cost is -2 ln of the likelihood of the mixture
// of surfaces, density / sigma exp(-d^2 / (2 sigma^2)): where a thin cloud of clutter cuts a wall, the points there
// are the wall's. Within the core of a plane the normal has no say: it is that of a cell, and at an edge of two
// surfaces the cell holds both, so that a column of the wall beside a reveal would become the reveal's.
uint32_t choose(const SegmentScene& scene, const std::vector<Patch>& patches,
                std::span<const uint32_t> near, size_t position, double min_cosine) {
  const Vec3 p = scene.local(position);
  uint32_t best = 0;
  double best_cost = INFINITY;
  for (const uint32_t k : near) {
    const Patch& patch = patches[k];
    const double distance = std::fabs(patch.distance(p));
    if (distance > scene.settings.distance_tolerance_m) continue;
    if (distance > patch.core_m && patch.inconsistent(scene, position, min_cosine)) continue;
    const double cost = distance * distance * patch.weight + patch.evidence;
    if (cost < best_cost && patch.reaches(p)) {
      best = k + 1;
      best_cost = cost;
    }
  }
  return best;
}

}  // namespace

// Counted by stretches of points, then put in place.
void take_positions(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  const size_t n = scene.size(), count = surfaces.size();
  const size_t stretches = (n + kPointsPerStretch - 1) / kPointsPerStretch;
  std::vector<uint32_t> next(stretches * (count + 1), 0);  // by stretch and owner
  parallel_for(task, n, kPointsPerStretch, [&](size_t begin, size_t end) {
    uint32_t* counts = next.data() + begin / kPointsPerStretch * (count + 1);
    for (size_t i = begin; i < end; ++i) ++counts[scene.owner[i]];
  });
  for (size_t k = 1; k <= count; ++k) {
    uint32_t sum = 0;
    for (size_t stretch = 0; stretch < stretches; ++stretch)
      sum += std::exchange(next[stretch * (count + 1) + k], sum);
    surfaces[k - 1].positions = std::vector<uint32_t>(sum);
  }
  parallel_for(task, n, kPointsPerStretch, [&](size_t begin, size_t end) {
    uint32_t* places = next.data() + begin / kPointsPerStretch * (count + 1);
    for (size_t i = begin; i < end; ++i)
      if (const uint32_t k = scene.owner[i]; k != 0)
        surfaces[k - 1].positions[places[k]++] = static_cast<uint32_t>(i);
  });
}

void assign_points(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::vector<Patch> patches(surfaces.size());
  for_each_surface(surfaces, task,
                   [&](size_t i) { patches[i] = patch_of(scene, surfaces[i], task); });
  const double min_cosine = scene.min_cosine();
  const double reach_m =
      scene.settings.distance_tolerance_m + kReachSlack * scene.tree->cube().edge;
  parallel_for(task, scene.size(), kAssignmentPointsPerChunk, [&](size_t begin, size_t end) {
    std::vector<uint32_t> near_chunk, near;
    const Box3 chunk = box_of(scene, begin, end);
    for (uint32_t k = 0; k < patches.size(); ++k)
      if (may_reach(chunk, patches[k], reach_m)) near_chunk.push_back(k);
    for (size_t first = begin; first < end; first += kPointsPerBlock) {
      const size_t last = std::min(end, first + kPointsPerBlock);
      const Box3 box = box_of(scene, first, last);
      near.clear();
      for (const uint32_t k : near_chunk)
        if (may_reach(box, patches[k], reach_m)) near.push_back(k);
      for (size_t i = first; i < last; ++i)
        scene.owner[i] = choose(scene, patches, near, i, min_cosine);
    }
  });
  take_positions(scene, surfaces, task);
}

}  // namespace jalon
