// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/growing/growing.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "segment/growing/flatness.h"

namespace jalon {

namespace {

constexpr double kRefitGrowth =
    1.1;  // growth of the number of points after which the plane is fitted anew
constexpr float kSparser =
    2;  // a region goes on into places at most so much sparser than where it stands
constexpr size_t kLeastToGoOn = 3;  // points of a leaf
constexpr double kMaxRoughness =
    0.5;  // rms, in tolerances, of a region that is a plane (as in extraction.cpp)
constexpr double kPieceShare =
    0.25;  // of the least surface: pieces this large may be joined to their neighbours
constexpr size_t kLeavesPerCheckpoint = 4096;

// A region while it grows.
struct GrowingRegion {
  uint32_t id = 0;
  Plane plane;
  Moments moments;
  uint64_t fitted = 0;            ///< points at the last fit
  std::vector<uint32_t> leaves;   ///< in the order of their discovery
  std::vector<uint32_t> members;  ///< points of the tree

  bool refit() {
    PlaneFit fit;
    fitted = moments.n;
    if (!fit_plane(moments, fit)) return false;
    plane = fit.plane;
    return true;
  }
};

class Grower {
 public:
  Grower(SegmentScene& scene, const GrowingPoints& points, uint32_t first_id, Task& task)
      : scene_(scene),
        points_(points),
        task_(task),
        next_id_(first_id),
        first_(points.leaf_first()),
        visited_(points.leaves(), 0),
        spent_(points.leaves(), 0),
        cosine_(scene.min_cosine()) {}

  std::vector<Surface> run() {
    const std::vector<uint32_t> seeds = seeds_by_flatness(scene_, points_, task_);
    for (size_t i = 0; i < seeds.size(); ++i) {
      progress_ = static_cast<double>(i) / static_cast<double>(seeds.size());
      if (i % kLeavesPerCheckpoint == 0) task_.checkpoint(progress_);
      if (spent_[seeds[i]] == 0) try_seed(seeds[i]);
    }
    return std::move(surfaces_);
  }

 private:
  void try_seed(uint32_t leaf) {
    GrowingRegion region;
    region.id = next_id_;
    PlaneFit fit;
    spent_[leaf] = 1;
    if (!seed_plane(scene_, points_, leaf, fit)) return;
    region.plane = fit.plane;
    region.moments.reference = fit.centroid;
    ++round_;
    visit(leaf, points_.leaf_spacing[leaf], region);
    grow(region);
    Surface surface;
    if (!settle(region, surface)) {
      for (const uint32_t point : region.members) scene_.owner[points_.position(point)] = 0;
      for (const uint32_t l : region.leaves) spent_[l] = 1;  // it would grow the same region again
      return;
    }
    ++next_id_;
    surfaces_.push_back(std::move(surface));
  }

  // Breadth first, so that the plane is fitted to a compact patch as early as possible.
  void grow(GrowingRegion& region) {
    for (size_t at = 0; at < region.leaves.size(); ++at) {
      if ((at + 1) % kLeavesPerCheckpoint == 0) task_.checkpoint(progress_);
      const uint32_t leaf = region.leaves[at];
      for (const uint32_t next : points_.graph.of(leaf))
        if (visited_[next] != round_) visit(next, points_.leaf_spacing[leaf], region);
    }
  }

  // Takes the points of a leaf that fit; the region goes on from it when these are a good part of the leaf: through
  // clutter that lies in the plane by chance it would reach coplanar surfaces far away.
  void visit(uint32_t leaf, float spacing, GrowingRegion& region) {
    visited_[leaf] = round_;
    if (points_.leaf_spacing[leaf] < 0) return;
    const size_t before = region.members.size();
    size_t free = 0;
    for (size_t i = first_[leaf]; i < first_[leaf + 1]; ++i) {
      const uint32_t position = points_.position(i);
      if (scene_.owner[position] != 0 || points_.isolated[i] != 0) continue;
      ++free;
      if (scene_.spacing[position] > kSparser * spacing) continue;
      const Vec3 p = points_.tree->local(i);
      if (std::fabs(region.plane.distance(p)) > scene_.settings.distance_tolerance_m) continue;
      if (scene_.inconsistent(position, region.plane.normal, cosine_)) continue;
      scene_.owner[position] = region.id;
      region.moments.add(p);
      region.members.push_back(static_cast<uint32_t>(i));
    }
    const size_t taken = region.members.size() - before;
    if (taken >= kLeastToGoOn && 2 * taken >= free) region.leaves.push_back(leaf);
    if (static_cast<double>(region.moments.n) >= kRefitGrowth * static_cast<double>(region.fitted))
      region.refit();
  }

  // The finished region as a surface; false when it is too small, too rough or bent.
  bool settle(GrowingRegion& region, Surface& surface) const {
    const SurfaceSettings& settings = scene_.settings;
    PlaneFit fit;
    const double least =
        std::max(3.0, kPieceShare * settings.min_points / points_.points_per_member);
    if (static_cast<double>(region.members.size()) < least || !fit_plane(region.moments, fit))
      return false;
    if (fit.sigma > kMaxRoughness * settings.distance_tolerance_m || !wide_enough(settings, fit))
      return false;
    if (is_bent(fit, points_, region.members)) return false;
    surface.plane = fit.plane;
    surface.sigma_m = fit.sigma;
    std::vector<Vec2> uv(region.members.size());
    const FlatFrame frame = plane_frame(fit.plane, fit.centroid);
    std::sort(region.members.begin(), region.members.end());
    for (size_t i = 0; i < region.members.size(); ++i) {
      const uint32_t position = points_.position(region.members[i]);
      surface.positions.push_back(position);
      uv[i] = frame(points_.tree->local(region.members[i]));
    }
    std::sort(surface.positions.begin(), surface.positions.end());
    surface.pixel_m = connectivity_pixel(
        settings, region.members.size(),
        [&](size_t i) { return scene_.spacing[points_.position(region.members[i])]; }, task_);
    surface.area_m2 = occupied_area_m2(bounded_raster(uv, surface.pixel_m, 0, task_));
    return surface.area_m2 >= kPieceShare * settings.min_area_m2;
  }

  SegmentScene& scene_;
  const GrowingPoints& points_;
  Task& task_;
  uint32_t next_id_, round_ = 0;
  std::span<const uint32_t> first_;
  std::vector<uint32_t> visited_;  ///< by leaf: the last region that looked at it
  std::vector<uint8_t> spent_;     ///< by leaf: has been a seed, or part of what was no surface
  double cosine_, progress_ = 0;
  std::vector<Surface> surfaces_;
};

}  // namespace

std::vector<Surface> grow_surfaces(SegmentScene& scene, const GrowingPoints& points,
                                   uint32_t first_id, Task& task) {
  return Grower(scene, points, first_id, task).run();
}

}  // namespace jalon
