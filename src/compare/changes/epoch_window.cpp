// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/epoch_window.h"

#include <algorithm>
#include <bit>

#include "base/error.h"
#include "spatial/octree/walk.h"

namespace jalon {

namespace {

constexpr size_t kWindowGrain = 1 << 14;  // between looks for a cancel
constexpr uint32_t kHeld = 0xffffffffu;   // by a support: of no voxel

// May a ball about points hold any of the box? Both local.
bool may_meet(const Box3& box, const Vec3& centre, double radius_m) {
  const Vec3 reach{radius_m, radius_m, radius_m};
  return Box3{box.min - reach, box.max + reach}.contains(centre);
}

}  // namespace

EpochWindow::EpochWindow(const Epoch& epoch)
    : epoch_(epoch),
      statuses_(epoch.statuses()),
      nearests_(epoch.comparison->points.require("nearest").values<uint32_t>()) {}

void EpochWindow::look(const Box3& box, Task& task) {
  const auto tree = epoch_.cloud().octree(task);
  const auto order = tree->order();
  is_inside_.assign((epoch_.cloud().size() + 63) / 64, 0);
  walk_octree(
      *tree,
      [&](const BoundingBall& ball, double&) {
        return may_meet(box, ball.centre - epoch_.origin, ball.radius_m);
      },
      [&](size_t first, size_t last) {
        for (size_t at = first; at < last; ++at)
          if (const uint32_t i = order[at]; box.contains(epoch_.local(i)))
            is_inside_[i / 64] |= uint64_t{1} << i % 64;
      });
  points_.clear();
  voxels_.clear();
  rank_.clear();
  for (size_t w = 0; w < is_inside_.size(); ++w) {
    rank_.push_back(static_cast<uint32_t>(points_.size()));
    for (uint64_t bits = is_inside_[w]; bits != 0; bits &= bits - 1)
      points_.push_back(static_cast<uint32_t>(64 * w) +
                        static_cast<uint32_t>(std::countr_zero(bits)));
  }
}

void EpochWindow::part(const std::vector<Support>& supports, double cell_m, Task& task) {
  pieces_ = VoxelFlood(cell_m);
  voxels_.resize(points_.size());
  for (size_t k = 0; k < points_.size(); ++k) {
    if (k % kWindowGrain == 0 && task.cancelled()) throw Error(Status::kCancelled, "cancelled");
    const Vec3 p = epoch_.local(points_[k]);
    const bool is_held =
        std::any_of(supports.begin(), supports.end(), [&](const Support& s) { return s.holds(p); });
    voxels_[k] = is_held ? kHeld : pieces_.add(p);
  }
}

void EpochWindow::take(uint32_t i) {
  const uint64_t word = is_inside_[i / 64], bit = uint64_t{1} << i % 64;
  if ((word & bit) == 0) return;
  const size_t k = rank_[i / 64] + static_cast<size_t>(std::popcount(word & (bit - 1)));
  if (voxels_[k] != kHeld) pieces_.take(voxels_[k]);
}

bool EpochWindow::take_counterparts(EpochWindow& other) {
  if (!pieces_.has_new()) return false;
  for (size_t k = 0; k < points_.size(); ++k) {
    const uint32_t i = points_[k];
    if (voxels_[k] != kHeld && pieces_.is_new(voxels_[k]) && is_unchanged(i) &&
        nearests_[i] != kNoPoint)
      other.take(nearests_[i]);
  }
  pieces_.settle();
  return true;
}

std::vector<uint32_t> EpochWindow::whole() const {
  std::vector<uint32_t> out;
  for (size_t k = 0; k < points_.size(); ++k)
    if (voxels_[k] != kHeld && pieces_.is_settled(voxels_[k])) out.push_back(points_[k]);
  return out;
}

}  // namespace jalon
