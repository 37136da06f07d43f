// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/assignment.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "segment/settle/each_surface.h"
#include "segment/settle/positions.h"

namespace jalon {

namespace {

constexpr size_t kAssignmentPointsPerChunk = 1 << 14;
// Of the octree's cube: far above the rounding of a distance, far below any tolerance.
constexpr double kReachSlack = 1e-12;
constexpr double kLeastSigma =
    0.04;  // of the tolerance: noise-free planes do not pull points from noisy ones
constexpr double kLeastArea_m2 = 1e-6;

using Patch = SurfacePatch;

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
    if (surface.image.size() > 0) return surface.image;
    const auto at = [&](size_t i) { return patch.frame(scene.local(positions[i])); };
    return bounded_raster_of(positions.size(), at, surface.pixel_m, 1, task);
  }
  std::vector<Vec3> points(positions.size());
  for (size_t i = 0; i < points.size(); ++i) points[i] = scene.local(positions[i]);
  patch.map = surface.curved.map(points, task);
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

using Moved = std::vector<std::atomic<size_t>>;  // points that came or went, by owner

struct Round {
  SegmentScene& scene;
  const std::vector<Patch>& patches;
  const std::vector<Box3>& boxes;
  const std::vector<Patch>& changed;
  const std::vector<uint32_t>& now;  // of the owners of the round before
  bool is_first;

  double reach_m() const {
    return scene.settings.distance_tolerance_m + kReachSlack * scene.tree->cube().edge;
  }
};

// Those of a list, or of all, that may reach a point of the box.
std::vector<uint32_t> near_box(const Box3& box, const std::vector<Patch>& patches, double reach_m) {
  std::vector<uint32_t> near;
  for (uint32_t k = 0; k < patches.size(); ++k)
    if (may_reach(box, patches[k], reach_m)) near.push_back(k);
  return near;
}
void near_box(const Box3& box, const std::vector<Patch>& patches, double reach_m,
              std::span<const uint32_t> among, std::vector<uint32_t>& near) {
  near.clear();
  for (const uint32_t k : among)
    if (may_reach(box, patches[k], reach_m)) near.push_back(k);
}

// Points of a run of blocks that came or went, put together at its end: all threads count the same few owners.
class MovedHere {
 public:
  explicit MovedHere(Moved& moved) : moved_(moved), counts_(moved.size(), 0) {}
  ~MovedHere() {
    for (size_t k = 0; k < counts_.size(); ++k)
      if (counts_[k] != 0) moved_[k].fetch_add(counts_[k], std::memory_order_relaxed);
  }
  MovedHere(const MovedHere&) = delete;
  MovedHere& operator=(const MovedHere&) = delete;
  void count(uint32_t before, uint32_t now) {
    ++counts_[before];
    ++counts_[now];
  }

 private:
  Moved& moved_;
  std::vector<size_t> counts_;
};

// A run of blocks: each is left as it is where no patch that changed may reach it.
void share_out(const Round& round, size_t begin, size_t end, Moved& moved,
               std::vector<MovedPoint>& moves) {
  SegmentScene& scene = round.scene;
  const double reach_m = round.reach_m();
  MovedHere moved_here(moved);
  Box3 chunk;
  for (size_t b = begin / kPointsPerBlock; b * kPointsPerBlock < end; ++b) chunk += round.boxes[b];
  const auto changed_here = near_box(chunk, round.changed, reach_m);
  std::vector<uint32_t> here, near;
  if (round.is_first || !changed_here.empty()) here = near_box(chunk, round.patches, reach_m);
  for (size_t first = begin; first < end; first += kPointsPerBlock) {
    const size_t last = std::min(end, first + kPointsPerBlock);
    const Box3& box = round.boxes[first / kPointsPerBlock];
    const bool stays =
        !round.is_first && std::none_of(changed_here.begin(), changed_here.end(), [&](uint32_t k) {
          return may_reach(box, round.changed[k], reach_m);
        });
    if (stays) {
      for (size_t i = first; i < last; ++i) scene.owner[i] = round.now[scene.owner[i]];
      continue;
    }
    near_box(box, round.patches, reach_m, here, near);
    uint32_t owners[kPointsPerBlock];
    choose_owners(scene, round.patches, near, {first, last, box}, owners);
    for (size_t i = first; i < last; ++i) {
      const uint32_t before = round.is_first ? 0 : round.now[scene.owner[i]];
      const uint32_t own = owners[i - first];
      scene.owner[i] = own;
      if (own == before) continue;
      moved_here.count(before, own);
      if (!round.is_first) moves.push_back({static_cast<uint32_t>(i), before, own});
    }
  }
}

// Not those that were split or joined since the last round: scene.owner tells what they were.
bool own_their_points(const std::vector<Surface>& surfaces) {
  return std::all_of(surfaces.begin(), surfaces.end(), [](const Surface& s) {
    return s.sharing.number != 0 && s.sharing.moved != Surface::Sharing::kAll;
  });
}

}  // namespace

// The patches of the surfaces that are what they were stand; the others are made anew. Those that are gone or new are
// where points may change hands.
std::vector<uint32_t> Assignment::renew_patches(const SegmentScene& scene,
                                                const std::vector<Surface>& surfaces,
                                                std::vector<Patch>& changed, Task& task) {
  std::vector<Patch> patches(surfaces.size());
  std::vector<uint32_t> now(patches_.size() + 1, 0);
  const auto stands = [&](size_t s) {
    return surfaces[s].sharing.number != 0 && !surfaces[s].sharing.fresh;
  };
  for (size_t s = 0; s < surfaces.size(); ++s) {
    const uint32_t before = surfaces[s].sharing.number;
    if (before != 0) now[before] = static_cast<uint32_t>(s + 1);
    if (stands(s)) patches[s] = std::move(patches_[before - 1]);
    else if (before != 0) changed.push_back(patches_[before - 1].outline());
  }
  for (uint32_t before = 1; before < now.size(); ++before)
    if (now[before] == 0) changed.push_back(patches_[before - 1].outline());
  for_each_surface(surfaces, task, [&](size_t s) {
    if (!stands(s)) patches[s] = patch_of(scene, surfaces[s], task);
  });
  for (size_t s = 0; s < surfaces.size(); ++s)
    if (!stands(s)) changed.push_back(patches[s].outline());
  patches_ = std::move(patches);
  return now;
}

void Assignment::box_blocks(const SegmentScene& scene, Task& task) {
  boxes_.resize((scene.size() + kPointsPerBlock - 1) / kPointsPerBlock);
  parallel_for(task, scene.size(), kAssignmentPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t first = begin; first < end; first += kPointsPerBlock)
      boxes_[first / kPointsPerBlock] =
          box_of(scene, first, std::min(end, first + kPointsPerBlock));
  });
}

void Assignment::next_round(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  const bool is_first = boxes_.empty();
  if (is_first) box_blocks(scene, task);
  if (is_first)
    for (Surface& surface : surfaces) surface.sharing = {};
  std::vector<Patch> changed;
  const std::vector<uint32_t> now = renew_patches(scene, surfaces, changed, task);
  Moved moved(surfaces.size() + 1);
  const Round round{scene, patches_, boxes_, changed, now, is_first};
  std::vector<std::vector<MovedPoint>> moves((scene.size() + kAssignmentPointsPerChunk - 1) /
                                             kAssignmentPointsPerChunk);
  parallel_for(task, scene.size(), kAssignmentPointsPerChunk, [&](size_t begin, size_t end) {
    share_out(round, begin, end, moved, moves[begin / kAssignmentPointsPerChunk]);
  });
  if (!is_first && own_their_points(surfaces)) move_positions(moves, surfaces, task);
  else take_positions(scene, surfaces, task);
  for (size_t s = 0; s < surfaces.size(); ++s) {
    surfaces[s].image = {};
    Surface::Sharing& sharing = surfaces[s].sharing;
    sharing.number = static_cast<uint32_t>(s + 1);
    sharing.fresh = false;
    if (sharing.moved != Surface::Sharing::kAll) sharing.moved += moved[s + 1];
  }
}

void assign_points(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  Assignment().next_round(scene, surfaces, task);
}

}  // namespace jalon
