// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/merging.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr double kMaxCosine = 0.985;      // 10 degrees: beyond, no joint fit is tried
constexpr double kRoughnessGrowth = 1.5;  // rms about the joint plane against the own sigma
constexpr double kFreeRoughness = 0.3;    // of the tolerance: rms that needs no comparison
constexpr double kOverlap = 0.5;          // share of a layer's points over the other's pixels
constexpr size_t kMergingPointsPerChunk = 1 << 14;

struct MergingPart {
  Moments moments;
  PlaneFit fit;
  Box3 box;
  bool alive = true;
};

MergingPart part_of(const SegmentScene& scene, const Surface& surface, Task& task) {
  struct Sums {
    Moments moments;
    Box3 box;
    Sums& operator+=(const Sums& b) {
      moments += b.moments;
      box += b.box;
      return *this;
    }
  } zero;
  const double half = scene.tree->cube().edge / 2;
  zero.moments.reference = {half, half, half};
  const auto& positions = surface.positions;
  const Sums sums = parallel_reduce(task, positions.size(), kMergingPointsPerChunk, zero,
                                    [&](size_t begin, size_t end) {
                                      Sums part = zero;
                                      for (size_t i = begin; i < end; ++i) {
                                        const Vec3 p = scene.local(positions[i]);
                                        part.moments.add(p);
                                        part.box.add(p);
                                      }
                                      return part;
                                    });
  MergingPart part;
  part.moments = sums.moments;
  part.box = sums.box;
  part.alive = surface.is_plane() && fit_plane(sums.moments, part.fit);
  return part;
}

bool one_plane_fits(const SegmentScene& scene, const MergingPart& a, const MergingPart& b) {
  const double tolerance = scene.settings.distance_tolerance_m;
  const MergingPart& large = a.moments.n >= b.moments.n ? a : b;
  const MergingPart& small = a.moments.n >= b.moments.n ? b : a;
  if (std::fabs(large.fit.plane.distance(small.fit.centroid)) > tolerance) return false;
  if (std::fabs(dot(a.fit.plane.normal, b.fit.plane.normal)) < kMaxCosine) return false;
  Moments joint = a.moments;
  joint += b.moments;
  PlaneFit fit;
  if (!fit_plane(joint, fit)) return false;
  const auto agrees = [&](const MergingPart& part) {
    return rms_about(part.moments, fit.plane) <=
           std::max(kRoughnessGrowth * part.fit.sigma, kFreeRoughness * tolerance);
  };
  return agrees(a) && agrees(b);
}

// Two layers within the tolerance are one plane: it is as thick as its noise.
bool layers_are_one(const SegmentScene& scene, const MergingPart& a, const MergingPart& b) {
  if (std::fabs(dot(a.fit.plane.normal, b.fit.plane.normal)) < kMaxCosine) return false;
  Moments joint = a.moments;
  joint += b.moments;
  PlaneFit fit;
  if (!fit_plane(joint, fit)) return false;
  return !too_rough(scene.settings, rms_about(a.moments, fit.plane)) &&
         !too_rough(scene.settings, rms_about(b.moments, fit.plane));
}

// True when most of the points of one surface lie where the other one has points as well.
bool lies_over(const SegmentScene& scene, const Surface& small, const Surface& large) {
  const FlatFrame frame = plane_frame(large.plane, scene.local(large.positions[0]));
  std::vector<Vec2> uv(large.positions.size());
  for (size_t i = 0; i < uv.size(); ++i) uv[i] = frame(scene.local(large.positions[i]));
  const Raster raster = bounded_raster(uv, large.pixel_m, 0);
  size_t over = 0;
  for (const uint32_t position : small.positions)
    over += raster.holds(frame(scene.local(position)));
  return static_cast<double>(over) >= kOverlap * static_cast<double>(small.positions.size());
}

bool boxes_near(const Box3& a, const Box3& b, double gap) {
  for (int k = 0; k < 3; ++k)
    if (a.min[k] > b.max[k] + gap || b.min[k] > a.max[k] + gap) return false;
  return true;
}

// True when the surfaces' pixels come within merge_gap_m of each other.
bool pixels_near(const SegmentScene& scene, const Surface& a, const Surface& b) {
  const double gap = scene.settings.merge_gap_m;
  const double pixel = std::max({a.pixel_m, b.pixel_m, gap / 64});
  const auto reach = static_cast<uint32_t>(std::max(1.0, std::floor(gap / pixel)));
  const FlatFrame frame = plane_frame(a.plane, scene.local(a.positions[0]));
  std::vector<Vec2> uv(a.positions.size());
  for (size_t i = 0; i < uv.size(); ++i) uv[i] = frame(scene.local(a.positions[i]));
  const Raster near = dilated(bounded_raster(uv, pixel, reach), reach);
  for (const uint32_t position : b.positions)
    if (near.holds(frame(scene.local(position)))) return true;
  return false;
}

void absorb(Surface& into, MergingPart& into_part, Surface& from, MergingPart& from_part) {
  into_part.moments += from_part.moments;
  into_part.box += from_part.box;
  fit_plane(into_part.moments, into_part.fit);
  into.plane = into_part.fit.plane;
  into.sigma_m = into_part.fit.sigma;
  into.area_m2 += from.area_m2;
  into.pixel_m = std::max(into.pixel_m, from.pixel_m);
  const auto middle = static_cast<ptrdiff_t>(into.positions.size());
  into.positions.insert(into.positions.end(), from.positions.begin(), from.positions.end());
  std::inplace_merge(into.positions.begin(), into.positions.begin() + middle, into.positions.end());
  from.positions.clear();
  from_part.alive = false;
}

}  // namespace

void merge_coplanar(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::vector<MergingPart> parts;
  for (const Surface& surface : surfaces) parts.push_back(part_of(scene, surface, task));
  for (bool merged = true; merged;) {
    merged = false;
    for (size_t i = 0; i < surfaces.size(); ++i) {
      task.checkpoint(static_cast<double>(i) / static_cast<double>(surfaces.size()));
      for (size_t j = i + 1; j < surfaces.size() && parts[i].alive; ++j) {
        if (!parts[j].alive || !boxes_near(parts[i].box, parts[j].box, scene.settings.merge_gap_m))
          continue;
        if (!one_plane_fits(scene, parts[i], parts[j]) ||
            !pixels_near(scene, surfaces[i], surfaces[j]))
          continue;
        absorb(surfaces[i], parts[i], surfaces[j], parts[j]);
        merged = true;
      }
    }
  }
  std::erase_if(surfaces, [](const Surface& s) { return s.positions.empty(); });
}

bool merge_layers(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::vector<MergingPart> parts;
  for (const Surface& surface : surfaces) parts.push_back(part_of(scene, surface, task));
  for (size_t i = 0; i < surfaces.size(); ++i) {
    task.checkpoint(static_cast<double>(i) / static_cast<double>(surfaces.size()));
    for (size_t j = i + 1; j < surfaces.size() && parts[i].alive; ++j) {
      if (!parts[j].alive || !boxes_near(parts[i].box, parts[j].box, 0)) continue;
      const bool i_is_large = surfaces[i].positions.size() >= surfaces[j].positions.size();
      const Surface& large = surfaces[i_is_large ? i : j];
      const Surface& small = surfaces[i_is_large ? j : i];
      if (!layers_are_one(scene, parts[i], parts[j]) || !lies_over(scene, small, large)) continue;
      absorb(surfaces[i], parts[i], surfaces[j], parts[j]);
    }
  }
  return std::erase_if(surfaces, [](const Surface& s) { return s.positions.empty(); }) > 0;
}

}  // namespace jalon
