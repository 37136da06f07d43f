// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/merging.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "segment/settle/blocked_points.h"
#include "segment/settle/each_surface.h"

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
  BlockedPoints points;
  std::vector<size_t> pieces;  ///< surfaces that have the points
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
  part.points = BlockedPoints(scene, positions, task);
  return part;
}

std::vector<MergingPart> parts_of(const SegmentScene& scene, const std::vector<Surface>& surfaces,
                                  Task& task) {
  std::vector<MergingPart> parts(surfaces.size());
  for_each_surface(surfaces, task, [&](size_t s) {
    parts[s] = part_of(scene, surfaces[s], task);
    parts[s].pieces = {s};
  });
  return parts;
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

FlatFrame frame_of(const SegmentScene& scene, const Surface& surface, const MergingPart& part) {
  return plane_frame(surface.plane, scene.local(part.points.first_position()));
}

// True when most of the points of one surface lie where the other one has points as well.
bool lies_over(const SegmentScene& scene, const MergingPart& small, const Surface& large_surface,
               const MergingPart& large) {
  const auto least =
      static_cast<size_t>(std::ceil(kOverlap * static_cast<double>(small.points.size())));
  return lie_over(scene, small.points, least, large.points, frame_of(scene, large_surface, large),
                  large_surface.pixel_m, 0);
}

bool boxes_near(const Box3& a, const Box3& b, double gap) {
  for (int k = 0; k < 3; ++k)
    if (a.min[k] > b.max[k] + gap || b.min[k] > a.max[k] + gap) return false;
  return true;
}

// True when the surfaces' pixels come within merge_gap_m of each other.
bool pixels_near(const SegmentScene& scene, const Surface& a, const MergingPart& a_part,
                 const Surface& b, const MergingPart& b_part) {
  const double gap = scene.settings.merge_gap_m;
  const double pixel = std::max({a.pixel_m, b.pixel_m, gap / 64});
  const auto reach = static_cast<uint32_t>(std::max(1.0, std::floor(gap / pixel)));
  return lie_over(scene, b_part.points, 1, a_part.points, frame_of(scene, a, a_part), pixel, reach);
}

// All but the lists of positions, which join_pieces() makes one.
void absorb(Surface& into, MergingPart& into_part, const Surface& from, MergingPart& from_part) {
  into_part.moments += from_part.moments;
  into_part.box += from_part.box;
  fit_plane(into_part.moments, into_part.fit);
  into.plane = into_part.fit.plane;
  into.sigma_m = into_part.fit.sigma;
  into.area_m2 += from.area_m2;
  into.pixel_m = std::max(into.pixel_m, from.pixel_m);
  into.image = {};
  into.sharing.fresh = true;
  into.sharing.moved = Surface::Sharing::kAll;
  into_part.points.take(std::move(from_part.points));
  into_part.pieces.insert(into_part.pieces.end(), from_part.pieces.begin(), from_part.pieces.end());
  from_part.pieces.clear();
  from_part.alive = false;
}

// Two runs at a time, so that each position is moved once a doubling.
void join_sorted_runs(std::vector<uint32_t>& positions, std::vector<size_t> ends) {
  const auto at = [&](size_t place) { return positions.begin() + static_cast<ptrdiff_t>(place); };
  while (ends.size() > 1) {
    std::vector<size_t> joined;
    size_t begin = 0;
    for (size_t k = 0; k < ends.size(); k += 2) {
      const size_t end = ends[std::min(k + 1, ends.size() - 1)];
      std::inplace_merge(at(begin), at(ends[k]), at(end));
      joined.push_back(begin = end);
    }
    ends = std::move(joined);
  }
}

// Each surface gets the points of its pieces, ascending; those that were absorbed go.
void join_pieces(std::vector<Surface>& surfaces, const std::vector<MergingPart>& parts,
                 Task& task) {
  parallel_for(task, surfaces.size(), 1, [&](size_t s, size_t) {
    if (parts[s].pieces.size() < 2) return;
    std::vector<uint32_t> positions;
    std::vector<size_t> ends;
    positions.reserve(parts[s].points.size());
    for (const size_t piece : parts[s].pieces) {
      std::vector<uint32_t> own = std::move(surfaces[piece].positions);
      positions.insert(positions.end(), own.begin(), own.end());
      ends.push_back(positions.size());
    }
    join_sorted_runs(positions, std::move(ends));
    surfaces[s].positions = std::move(positions);
  });
  for (size_t s = 0; s < surfaces.size(); ++s)
    if (parts[s].pieces.empty()) surfaces[s].positions.clear();
  std::erase_if(surfaces, [](const Surface& s) { return s.positions.empty(); });
}

}  // namespace

void merge_coplanar(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::vector<MergingPart> parts = parts_of(scene, surfaces, task);
  for (bool merged = true; merged;) {
    merged = false;
    for (size_t i = 0; i < surfaces.size(); ++i) {
      task.checkpoint(static_cast<double>(i) / static_cast<double>(surfaces.size()));
      for (size_t j = i + 1; j < surfaces.size() && parts[i].alive; ++j) {
        if (!parts[j].alive || !boxes_near(parts[i].box, parts[j].box, scene.settings.merge_gap_m))
          continue;
        if (!one_plane_fits(scene, parts[i], parts[j]) ||
            !pixels_near(scene, surfaces[i], parts[i], surfaces[j], parts[j]))
          continue;
        absorb(surfaces[i], parts[i], surfaces[j], parts[j]);
        merged = true;
      }
    }
  }
  join_pieces(surfaces, parts, task);
}

bool merge_layers(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::vector<MergingPart> parts = parts_of(scene, surfaces, task);
  for (size_t i = 0; i < surfaces.size(); ++i) {
    task.checkpoint(static_cast<double>(i) / static_cast<double>(surfaces.size()));
    for (size_t j = i + 1; j < surfaces.size() && parts[i].alive; ++j) {
      if (!parts[j].alive || !boxes_near(parts[i].box, parts[j].box, 0)) continue;
      const bool i_is_large = parts[i].points.size() >= parts[j].points.size();
      const size_t large = i_is_large ? i : j, small = i_is_large ? j : i;
      if (!layers_are_one(scene, parts[i], parts[j]) ||
          !lies_over(scene, parts[small], surfaces[large], parts[large]))
        continue;
      absorb(surfaces[i], parts[i], surfaces[j], parts[j]);
    }
  }
  const size_t before = surfaces.size();
  join_pieces(surfaces, parts, task);
  return surfaces.size() < before;
}

}  // namespace jalon
