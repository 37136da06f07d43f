// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/voxels/voxel_numbers.h"

#include <bit>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kVoxelNumbersGrain = size_t{1} << 15;
constexpr double kMostCells = 0x1p41;  // either side of the origin

}  // namespace

void require_voxels(size_t points, double cell_m) {
  if (!(cell_m > 0) || !std::isfinite(cell_m))
    fail(Status::kInvalidArgument, "the cell size must be positive");
  if (points >= 0xffffffffu)
    fail(Status::kLimit, "a grid holds at most 2^32 - 2 points; there are %zu", points);
}

VoxelNumbers::VoxelNumbers(std::span<const double> xyz, const Box3& box, const Vec3& origin,
                           double cell_m, Task& task)
    : xyz_(xyz.data()), origin_{origin.x, origin.y, origin.z}, cell_m_(cell_m) {
  for (size_t axis = 0; axis < 3; ++axis) {
    // Cell numbers rise with the coordinates, so the outermost points have the outermost ones.
    lowest_[axis] = std::floor(scaled(box.min[static_cast<int>(axis)], axis));
    const double highest = std::floor(scaled(box.max[static_cast<int>(axis)], axis));
    if (!(lowest_[axis] > -kMostCells && highest < kMostCells))
      fail(Status::kLimit,
           "the cells are too small for the extent of the cloud: more than 2^42 along an axis");
    bits_[axis] = static_cast<int>(std::bit_width(static_cast<uint64_t>(highest - lowest_[axis])));
  }
  if (key_bits() <= 64) return;
  for (size_t axis = 0; axis < 3; ++axis) renumber(xyz.size() / 3, axis, task);
  if (key_bits() > 64)
    fail(Status::kLimit,
         "the cells are too small for so many points: their numbers need more than 64 bits");
}

// Keeps the order: the numbers in use get the places they have among themselves.
void VoxelNumbers::renumber(size_t n, size_t axis, Task& task) {
  std::vector<uint64_t> used(n);
  parallel_for(task, n, kVoxelNumbersGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) used[i] = number(i, axis);
  });
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  bits_[axis] = static_cast<int>(std::bit_width(used.size() - 1));
  used_[axis] = std::move(used);
}

}  // namespace jalon
