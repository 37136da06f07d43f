// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scan/flat_triangles.h"
#include "spatial/union_find.h"

namespace jalon {

/// Connected groups of coplanar triangles, in the order of their first.
class Patches {
 public:
  struct Patch {
    Box3 box;
    uint32_t largest;  ///< the triangle whose plane is the patch's
    uint32_t first;    ///< of its triangles, among all
  };
  Patches(const FlatTriangles& flats, UnionFind& groups, Task& task);

  size_t size() const { return patches_.size(); }
  const Patch& operator[](size_t p) const { return patches_[p]; }
  std::span<const uint32_t> triangles(size_t p) const {
    const size_t end = p + 1 < patches_.size() ? patches_[p + 1].first : triangles_.size();
    return {triangles_.data() + patches_[p].first, end - patches_[p].first};
  }

 private:
  std::vector<Patch> patches_;
  std::vector<uint32_t> triangles_;
};

/// Whether boxes come within kTouching_m of each other.
bool meet(const Box3& a, const Box3& b);

/// A grid over the two widest extents with at most about as many bins as patches. Patches that meet share a bin.
class PatchBins {
 public:
  PatchBins(const Patches& patches, Task& task);
  size_t size() const { return first_.size() - 1; }
  std::span<const uint32_t> members(size_t bin) const {
    return {members_.data() + first_[bin], first_[bin + 1] - first_[bin]};
  }
  /// The one bin in which two patches that meet are compared.
  size_t bin_of(const Box3& a, const Box3& b) const;

 private:
  template <class F>
  void for_each_bin(const Patches& patches, Task& task, F&& f) const;
  /// First and last along either axis.
  std::array<size_t, 4> range(const Box3& box) const;
  size_t entries(const Patches& patches, Task& task) const;
  size_t at(size_t k, const Vec3& p, double shift) const;
  std::array<int, 2> axis_{};
  std::array<double, 2> from_{}, per_m_{};
  size_t side_ = 1;
  std::vector<size_t> first_;
  std::vector<uint32_t> members_;
};

}  // namespace jalon
