// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Checks what every grid asks for: a positive cell size (kInvalidArgument), fewer than 2^32 - 1 points (kLimit).
void require_voxels(size_t points, double cell_m);

/// The three cell numbers of a point, floor((p - origin) / cell) counted from the lowest in use, packed into one
/// 64-bit key: z counts most, x least. Numbers too large for 64 bits together are first replaced by their ranks, axis
/// by axis: n points occupy at most n different planes of cells.
class VoxelNumbers {
 public:
  /// box: of all points. kLimit when a number or a key has too many bits. xyz must outlive this.
  VoxelNumbers(std::span<const double> xyz, const Box3& box, const Vec3& origin, double cell_m,
               Task& task);

  int key_bits() const { return bits_[0] + bits_[1] + bits_[2]; }
  uint64_t key(size_t i) const {
    return (number(i, 2) << bits_[1] | number(i, 1)) << bits_[0] | number(i, 0);
  }

 private:
  double scaled(double v, size_t axis) const { return (v - origin_[axis]) / cell_m_; }
  uint64_t number(size_t i, size_t axis) const {
    const double from_lowest = std::floor(scaled(xyz_[3 * i + axis], axis)) - lowest_[axis];
    const auto v = static_cast<uint64_t>(
        static_cast<int64_t>(from_lowest));  // below 2^42: signed is one instruction
    const auto& used = used_[axis];
    return used.empty() ? v
                        : static_cast<uint64_t>(std::lower_bound(used.begin(), used.end(), v) -
                                                used.begin());
  }
  void renumber(size_t n, size_t axis, Task& task);

  const double* xyz_;
  std::array<double, 3> origin_;
  double cell_m_;
  std::array<double, 3> lowest_{};
  std::array<int, 3> bits_{};
  std::array<std::vector<uint64_t>, 3> used_;
};

}  // namespace jalon
