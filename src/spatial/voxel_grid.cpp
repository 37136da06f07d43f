// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Cells by sorting: the three cell numbers of a point, counted from the lowest ones in use, are packed into one 64-bit key; keys are
// parted by their highest bits in parallel, and each part is sorted in the cache. Cells too many for 64 bits are first
// renumbered axis by axis: n points occupy at most n different planes of cells.

#include "spatial/voxel_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "spatial/partition.h"
#include "spatial/radix_sort.h"

namespace jalon {

namespace {

constexpr size_t kGrain = size_t{1} << 15;
constexpr double kMostCells = 0x1p41;  // either side of the origin

struct Range {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 3> lo{kFar, kFar, kFar}, hi{-kFar, -kFar, -kFar};
  Range& operator+=(const Range& b) {
    for (size_t axis = 0; axis < 3; ++axis) {
      lo[axis] = std::min(lo[axis], b.lo[axis]);
      hi[axis] = std::max(hi[axis], b.hi[axis]);
    }
    return *this;
  }
};

class Numbering {
 public:
  Numbering(std::span<const double> xyz, const Vec3& origin, double cell_m, Task& task)
      : xyz_(xyz.data()), origin_{origin.x, origin.y, origin.z}, cell_m_(cell_m) {
    const size_t n = xyz.size() / 3;
    const Range range = parallel_reduce(task, n, kGrain, Range{}, [&](size_t begin, size_t end) {
      Range part;
      for (size_t i = begin; i < end; ++i)
        for (size_t axis = 0; axis < 3; ++axis) {
          part.lo[axis] = std::min(part.lo[axis], xyz_[3 * i + axis]);
          part.hi[axis] = std::max(part.hi[axis], xyz_[3 * i + axis]);
        }
      return part;
    });
    for (size_t axis = 0; axis < 3; ++axis) {
      // Cell numbers rise with the coordinates, so the outermost points have the outermost ones.
      lowest_[axis] = std::floor(scaled(range.lo[axis], axis));
      const double highest = std::floor(scaled(range.hi[axis], axis));
      if (!(lowest_[axis] > -kMostCells && highest < kMostCells))
        fail(Status::kLimit, "the cells are too small for the extent of the cloud: more than 2^42 along an axis");
      bits_[axis] = static_cast<int>(std::bit_width(static_cast<uint64_t>(highest - lowest_[axis])));
    }
    if (key_bits() <= 64) return;
    for (size_t axis = 0; axis < 3; ++axis) renumber(n, axis, task);
    if (key_bits() > 64)
      fail(Status::kLimit, "the cells are too small for so many points: their numbers need more than 64 bits");
  }

  int key_bits() const { return bits_[0] + bits_[1] + bits_[2]; }
  uint64_t key(size_t i) const { return (number(i, 2) << bits_[1] | number(i, 1)) << bits_[0] | number(i, 0); }

 private:
  double scaled(double v, size_t axis) const { return (v - origin_[axis]) / cell_m_; }
  uint64_t number(size_t i, size_t axis) const {
    const auto v = static_cast<uint64_t>(std::floor(scaled(xyz_[3 * i + axis], axis)) - lowest_[axis]);
    const auto& used = used_[axis];
    return used.empty() ? v : static_cast<uint64_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  }
  // Keeps the order: the numbers in use get the places they have among themselves.
  void renumber(size_t n, size_t axis, Task& task) {
    std::vector<uint64_t> used(n);
    parallel_for(task, n, kGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) used[i] = number(i, axis);
    });
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    bits_[axis] = static_cast<int>(std::bit_width(used.size() - 1));
    used_[axis] = std::move(used);
  }

  const double* xyz_;
  std::array<double, 3> origin_;
  double cell_m_;
  std::array<double, 3> lowest_{};
  std::array<int, 3> bits_{};
  std::array<std::vector<uint64_t>, 3> used_;
};

struct KeyedIndex {
  uint64_t key;
  uint32_t index;
};

// Sorts one part; out takes the indices, ends the places (in the part) where a cell begins.
void sort_part(const KeyedIndex* part, size_t n, KeyedRange keys, KeyedRange scratch, uint32_t* out, size_t offset,
               std::vector<uint32_t>& firsts) {
  for (size_t i = 0; i < n; ++i) {
    keys.keys[i] = part[i].key;
    keys.values[i] = part[i].index;
  }
  sort_pairs(keys, scratch, n);
  for (size_t i = 0; i < n; ++i) {
    out[i] = keys.values[i];
    if (i == 0 || keys.keys[i] != keys.keys[i - 1]) firsts.push_back(static_cast<uint32_t>(offset + i));
  }
}

void add_centroids(std::span<const double> xyz, const Vec3& origin, VoxelGrid& grid, Task& task) {
  const size_t cells = grid.size();
  grid.centroids = Buffer<double>(3 * cells);
  constexpr size_t kCells = size_t{1} << 12;
  parallel_for(task, cells, kCells, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      Vec3 sum;
      for (size_t i = grid.first[v]; i < grid.first[v + 1]; ++i) {
        const double* p = xyz.data() + 3 * static_cast<size_t>(grid.order[i]);
        sum += Vec3{p[0], p[1], p[2]} - origin;
      }
      const Vec3 mean = origin + sum / static_cast<double>(grid.first[v + 1] - grid.first[v]);
      double* out = grid.centroids.data() + 3 * v;
      out[0] = mean.x;
      out[1] = mean.y;
      out[2] = mean.z;
    }
  });
}

}  // namespace

VoxelGrid voxel_grid(std::span<const double> xyz, const Vec3& origin, double cell_m, Task& task) {
  if (!(cell_m > 0) || !std::isfinite(cell_m)) fail(Status::kInvalidArgument, "the cell size must be positive");
  const size_t n = xyz.size() / 3;
  if (n >= 0xffffffffu) fail(Status::kLimit, "a grid holds at most 2^32 - 2 points; there are %zu", n);
  VoxelGrid grid;
  if (n == 0) return grid;
  Buffer<KeyedIndex> records(n);
  std::vector<size_t> begins;
  {
    Span span(task, 0, 0.5, "sorting points into cells");
    const Numbering numbering(xyz, origin, cell_m, task);
    Buffer<uint64_t> keys(n);  // made once: divisions cost more than memory
    parallel_for(task, n, kGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) keys[i] = numbering.key(i);
    });
    // Parts of about a thousand points, at most 4096 of them.
    const int digit_bits = std::min({12, numbering.key_bits(), static_cast<int>(std::bit_width(n >> 10))});
    const int shift = numbering.key_bits() - digit_bits;
    begins = partition(
        n, size_t{1} << digit_bits, [=](const KeyedIndex& r) { return digit_bits == 0 ? 0 : r.key >> shift; }, task,
        records.data(), [&](size_t i) { return KeyedIndex{keys[i], static_cast<uint32_t>(i)}; });
  }
  grid.order = Buffer<uint32_t>(n);
  const auto groups = groups_of(begins.size() - 1, kGrain, [&](size_t b) { return begins[b + 1] - begins[b]; });
  std::vector<std::vector<uint32_t>> firsts(groups.size() - 1);
  {
    Span span(task, 0.5, 0.8);
    parallel_chunks(task, firsts.size(), [&](size_t g) {
      size_t most = 0;
      for (size_t b = groups[g]; b < groups[g + 1]; ++b) most = std::max(most, begins[b + 1] - begins[b]);
      Buffer<uint64_t> keys(2 * most);
      Buffer<uint32_t> values(2 * most);
      for (size_t b = groups[g]; b < groups[g + 1]; ++b)
        sort_part(records.data() + begins[b], begins[b + 1] - begins[b], {keys.data(), values.data()},
                  {keys.data() + most, values.data() + most}, grid.order.data() + begins[b], begins[b], firsts[g]);
    });
  }
  size_t cells = 0;
  for (const auto& part : firsts) cells += part.size();
  grid.first = Buffer<uint32_t>(cells + 1);
  size_t at = 0;
  for (const auto& part : firsts)
    for (const uint32_t first : part) grid.first[at++] = first;
  grid.first[cells] = static_cast<uint32_t>(n);
  Span span(task, 0.8, 1);
  add_centroids(xyz, origin, grid, task);
  return grid;
}

}  // namespace jalon
