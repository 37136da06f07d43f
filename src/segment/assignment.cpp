// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/assignment.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "geometry/curved_plane.h"

namespace jalon {

namespace {

constexpr size_t kPointsPerChunk = 1 << 14;
constexpr size_t kPointsPerBlock = 64;
constexpr double kLeastSigma = 0.04;      // of the tolerance: noise-free planes do not pull points from noisy ones
constexpr double kLeastArea_m2 = 1e-6;
// Share of the points, and of the variance of their narrow side, that those away from the border must have to stand for
// the surface: strips keep all.
constexpr double kLeastInner = 0.3;
// And their number: the shift is a tenth of sigma at most, which fewer do not know to a third.
constexpr size_t kLeastInnerPoints = 1000;
constexpr double kBendSigmas = 4;         // beyond doubt: 1 in 30 000 flat surfaces is taken for a curved one
constexpr double kCoreSigmas = 4;         // rejection of outliers in the last fit: biases sigma by 0.05 %

struct Patch {
  Plane plane;
  double core_m = 0;
  double weight = 0;    ///< 1 / sigma^2
  double evidence = 0;  ///< 2 ln(sigma / density)
  PlaneFrame frame;
  Raster mask;  ///< the surface's pixels and their neighbours; empty without connectivity
  Box3 box;

  bool reaches(const Vec3& p) const {
    if (mask.size() == 0) return true;
    const Vec2 q = frame(p);
    const double column = std::floor((q.u - mask.origin.u) / mask.pixel_m);
    const double row = std::floor((q.v - mask.origin.v) / mask.pixel_m);
    return column >= 0 && row >= 0 && column < mask.columns && row < mask.rows &&
           mask.pixels[static_cast<size_t>(row) * mask.columns + static_cast<size_t>(column)] != 0;
  }
};

Patch patch_of(const SegmentScene& scene, const Surface& surface) {
  const double tolerance = scene.settings.distance_tolerance_m;
  Patch patch;
  patch.plane = surface.plane;
  patch.core_m = core_reach(scene.settings, surface.sigma_m);
  const double sigma = std::max(surface.sigma_m, kLeastSigma * tolerance);
  patch.weight = 1 / (sigma * sigma);
  const double density = static_cast<double>(surface.positions.size()) / std::max(surface.area_m2, kLeastArea_m2);
  patch.evidence = 2 * std::log(sigma / density);
  patch.frame = plane_frame(surface.plane, scene.local(surface.positions[0]));
  std::vector<Vec2> uv(surface.positions.size());
  for (size_t i = 0; i < uv.size(); ++i) {
    const Vec3 p = scene.local(surface.positions[i]);
    uv[i] = patch.frame(p);
    patch.box.add(p);
  }
  const double margin = 2 * surface.pixel_m + tolerance;
  for (int k = 0; k < 3; ++k) {
    patch.box.min[k] -= margin;
    patch.box.max[k] += margin;
  }
  if (scene.settings.connectivity)
    patch.mask = dilated(bounded_raster(uv, surface.pixel_m, 1), 1);
  else
    patch.box = Box3{{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
  return patch;
}

bool overlap(const Box3& a, const Box3& b) {
  for (int k = 0; k < 3; ++k)
    if (a.min[k] > b.max[k] || b.min[k] > a.max[k]) return false;
  return true;
}

// Owner of one point among the patches near its block; 0 = none. The cost is -2 ln of the likelihood of the mixture
// of surfaces, density / sigma exp(-d^2 / (2 sigma^2)): where a thin cloud of clutter cuts a wall, the points there
// are the wall's. Within the core of a plane the normal has no say: it is that of a cell, and at an edge of two
// surfaces the cell holds both, so that a column of the wall beside a reveal would become the reveal's.
uint32_t choose(const SegmentScene& scene, const std::vector<Patch>& patches, std::span<const uint32_t> near,
                size_t position, double min_cosine) {
  const Vec3 p = scene.local(position);
  uint32_t best = 0;
  double best_cost = INFINITY;
  for (const uint32_t k : near) {
    const Patch& patch = patches[k];
    const double distance = std::fabs(patch.plane.distance(p));
    if (distance > scene.settings.distance_tolerance_m) continue;
    if (distance > patch.core_m && scene.inconsistent(position, patch.plane.normal, min_cosine)) continue;
    const double cost = distance * distance * patch.weight + patch.evidence;
    if (cost < best_cost && patch.reaches(p)) {
      best = k + 1;
      best_cost = cost;
    }
  }
  return best;
}

}  // namespace

void assign_points(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::vector<Patch> patches(surfaces.size());
  parallel_for(task, surfaces.size(), 1, [&](size_t i, size_t) { patches[i] = patch_of(scene, surfaces[i]); });
  const double min_cosine = scene.min_cosine();
  const size_t blocks = (scene.size() + kPointsPerBlock - 1) / kPointsPerBlock;
  parallel_for(task, blocks, kPointsPerChunk / kPointsPerBlock, [&](size_t begin, size_t end) {
    std::vector<uint32_t> near;
    for (size_t block = begin; block < end; ++block) {
      const size_t first = block * kPointsPerBlock, last = std::min(scene.size(), first + kPointsPerBlock);
      Box3 box;
      for (size_t i = first; i < last; ++i) box.add(scene.local(i));
      near.clear();
      for (uint32_t k = 0; k < patches.size(); ++k)
        if (overlap(box, patches[k].box)) near.push_back(k);
      for (size_t i = first; i < last; ++i) scene.owner[i] = choose(scene, patches, near, i, min_cosine);
    }
  });
  for (Surface& surface : surfaces) surface.positions.clear();
  for (size_t i = 0; i < scene.size(); ++i)
    if (scene.owner[i] != 0) surfaces[scene.owner[i] - 1].positions.push_back(static_cast<uint32_t>(i));
}

namespace {

// For each point of the surface, 1 when it lies away from the surface's border. Where another surface meets this one at
// an angle, that one's points are within reach on one side only and shift the plane: 0.3 mm at a pane of 1.2 m whose
// reveals have too few points to be found as planes. Nothing else tells those points from the surface's own.
std::vector<uint8_t> inner_points(const SegmentScene& scene, const Surface& surface, Task& task) {
  const PlaneFrame frame = plane_frame(surface.plane, scene.local(surface.positions[0]));
  std::vector<Vec2> uv(surface.positions.size());
  parallel_for(task, uv.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) uv[i] = frame(scene.local(surface.positions[i]));
  });
  const Raster inner = eroded(closed(bounded_raster(uv, surface.pixel_m, 1), 1), 1);
  std::vector<uint8_t> out(uv.size());
  parallel_for(task, uv.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) out[i] = inner.pixels[inner.pixel_of(uv[i])];
  });
  return out;
}

struct CoreMoments {
  Moments all, inner;
  CoreMoments& operator+=(const CoreMoments& b) {
    all += b.all;
    inner += b.inner;
    return *this;
  }
};

CoreMoments core_moments(const SegmentScene& scene, const Surface& surface, Task& task) {
  const RansacSettings& settings = scene.settings;
  const double reach =
      settings.uses_normals() && surface.sigma_m > 0
          ? std::min(settings.distance_tolerance_m,
                     std::max(kCoreSigmas * surface.sigma_m, core_reach(settings, surface.sigma_m)))
          : INFINITY;
  const double min_cosine = scene.min_cosine();
  std::vector<uint8_t> inner(surface.positions.size(), 0);
  if (settings.connectivity && settings.reassign) inner = inner_points(scene, surface, task);
  CoreMoments zero;
  zero.all.reference = zero.inner.reference = scene.local(surface.positions[0]);
  const auto part_of = [&](size_t begin, size_t end) {
    CoreMoments part = zero;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = scene.exact(surface.positions[i]);
      if (std::fabs(surface.plane.distance(p)) > reach) continue;
      if (scene.inconsistent(surface.positions[i], surface.plane.normal, min_cosine)) continue;
      part.all.add(p);
      if (inner[i] != 0) part.inner.add(p);
    }
    return part;
  };
  return parallel_reduce(task, surface.positions.size(), kPointsPerChunk, zero, part_of);
}

// Do the fits to all points and to the inner ones differ by more than chance? The difference of an efficient and a
// consistent estimate has the difference of their variances (Hausman 1978, 2.4): of the height at the inner points'
// centroid and of the two slopes there.
bool border_shifts(const PlaneFit& all, const PlaneFit& inner) {
  constexpr double kHeightAndSlopes99 = 11.345;  // chi-square, 3 degrees of freedom, 0.99
  const double n_all = static_cast<double>(all.n), n_inner = static_cast<double>(inner.n);
  const double squared = inner.sigma * inner.sigma;
  const auto term = [&](double difference, double inner_weight, double all_weight) {
    const double variance = squared * std::max(1 / inner_weight - 1 / all_weight, 0.1 / inner_weight);
    return difference * difference / variance;
  };
  const double sign = dot(all.plane.normal, inner.plane.normal) < 0 ? -1 : 1;
  const Vec3 turn = sign * all.plane.normal - inner.plane.normal;
  const double height = term(all.plane.distance(inner.centroid), n_inner, n_all);
  const double slope_u = term(dot(turn, inner.axis_u), n_inner * inner.eigenvalues[2], n_all * all.eigenvalues[2]);
  const double slope_v = term(dot(turn, inner.axis_v), n_inner * inner.eigenvalues[1], n_all * all.eigenvalues[1]);
  return height + slope_u + slope_v > kHeightAndSlopes99;
}

}  // namespace

bool fit_core(const SegmentScene& scene, const Surface& surface, Task& task, PlaneFit& fit) {
  if (surface.positions.size() < 3) return false;
  const CoreMoments core = core_moments(scene, surface, task);
  if (!fit_plane(core.all, fit)) return false;
  PlaneFit inner;
  const auto share = static_cast<double>(core.inner.n) / static_cast<double>(core.all.n);
  if (core.inner.n < kLeastInnerPoints || share < kLeastInner) return true;
  if (!fit_plane(core.inner, inner) || inner.eigenvalues[1] < kLeastInner * fit.eigenvalues[1]) return true;
  if (!border_shifts(fit, inner)) return true;
  fit = inner;
  fit.sigma = rms_about(core.all, fit.plane);
  return true;
}

namespace {

// True when the surface bends, beyond doubt, more tightly than the least radius.
bool bends(const SegmentScene& scene, const Surface& surface, const PlaneFit& fit, Task& task) {
  const double radius = scene.settings.least_radius_m;
  // Noise aside, a surface of that radius is within the tolerance on both sides of a plane over sqrt(16 r t) only.
  const double width = std::sqrt(16 * radius * scene.settings.distance_tolerance_m);
  const double narrow = std::sqrt(12 * fit.eigenvalues[1]);  // of evenly spread points
  if (radius == 0 || narrow > width) return false;
  const double long_m = std::sqrt(fit.eigenvalues[2]), across_m = std::sqrt(fit.eigenvalues[1]);
  if (!(across_m > 0)) return false;
  const auto sums_of = [&](size_t begin, size_t end) {
    BendSums part;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 d = scene.exact(surface.positions[i]) - fit.centroid;
      part.add(dot(d, fit.axis_u) / long_m, dot(d, fit.axis_v) / across_m, dot(d, fit.plane.normal));
    }
    return part;
  };
  const BendSums sums = parallel_reduce(task, surface.positions.size(), kPointsPerChunk, BendSums{}, sums_of);
  Bend bend;
  if (!largest_bend(sums, long_m, across_m, bend)) return false;
  return std::fabs(bend.curvature) > 1 / radius && std::fabs(bend.curvature) - 1 / radius > kBendSigmas * bend.sigma;
}

}  // namespace

bool refit_surfaces(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  const RansacSettings& settings = scene.settings;
  bool dropped = false;
  for (Surface& surface : surfaces) {
    PlaneFit fit;
    bool keep = surface.positions.size() >= std::max<size_t>(3, settings.min_points) &&
                fit_core(scene, surface, task, fit) && wide_enough(settings, fit) &&
                !too_rough(settings, fit.sigma) && !bends(scene, surface, fit, task);
    if (keep) {
      surface.plane = fit.plane;
      surface.sigma_m = fit.sigma;
      const PlaneFrame frame = plane_frame(surface.plane, scene.local(surface.positions[0]));
      std::vector<Vec2> uv(surface.positions.size());
      for (size_t i = 0; i < uv.size(); ++i) uv[i] = frame(scene.local(surface.positions[i]));
      surface.area_m2 = occupied_area_m2(bounded_raster(uv, surface.pixel_m, 0));
      keep = surface.area_m2 >= settings.min_area_m2;
    }
    if (keep) continue;
    for (const uint32_t position : surface.positions) scene.owner[position] = 0;
    surface.positions.clear();
    dropped = true;
  }
  std::erase_if(surfaces, [](const Surface& s) { return s.positions.empty(); });
  return dropped;
}

}  // namespace jalon
