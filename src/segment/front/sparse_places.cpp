// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/sparse_places.h"

#include <atomic>
#include <bit>
#include <cmath>
#include <vector>

#include "base/parallel.h"
#include "spatial/voxels/voxel_grid.h"

namespace jalon {

namespace {

constexpr size_t kSparsePointsPerChunk = 1 << 15;
constexpr double kMostCellsPerPoint = 64;  // a bit each: 8 B a point
constexpr double kLeastCells = 1 << 24;    // that any cloud may have: 2 MiB
constexpr size_t kCellsPerWord = 64;
constexpr double kStepsPerCell = 1 << 15;  // of the distance from a cell's middle
constexpr uint64_t kNoPlace = ~uint64_t{0};

/// The cells of a box, a bit each; those that hold points are numbered in their order.
class CellNumbers {
 public:
  CellNumbers(const Box3& box, const Vec3& origin, double cell_m)
      : low_(box.min - origin), origin_(origin), per_m_(1 / cell_m) {
    for (int k = 0; k < 3; ++k) {
      low_[k] = std::floor(low_[k] * per_m_);
      cells_[k] = std::floor((box.max[k] - origin[k]) * per_m_) - low_[k] + 1;
    }
  }
  double count() const { return cells_.x * cells_.y * cells_.z; }

  struct Place {
    size_t cell = 0;
    uint64_t off = 0;  ///< squared distance from its middle, in steps
  };
  Place place_of(const Vec3& p) const {
    Place out;
    double cell = 0, off = 0;
    for (int k = 2; k >= 0; --k) {
      const double at = (p[k] - origin_[k]) * per_m_ - low_[k], whole = std::floor(at);
      const double from_middle = kStepsPerCell * (at - whole - 0.5);
      cell = cell * cells_[k] + whole;
      off += from_middle * from_middle;
    }
    out.cell = static_cast<size_t>(cell);
    out.off = static_cast<uint64_t>(off);
    return out;
  }

  void make_room() {
    words_.assign(static_cast<size_t>(count()) / kCellsPerWord + 1, 0);
    before_.resize(words_.size());
  }
  /// From any thread.
  void mark(size_t cell) {
    const uint64_t bit = uint64_t{1} << (cell % kCellsPerWord);
    std::atomic_ref<uint64_t> word(words_[cell / kCellsPerWord]);
    if ((word.load(std::memory_order_relaxed) & bit) == 0)
      word.fetch_or(bit, std::memory_order_relaxed);
  }
  /// How many cells hold points.
  size_t number() {
    size_t sum = 0;
    for (size_t w = 0; w < words_.size(); ++w) {
      before_[w] = static_cast<uint32_t>(sum);
      sum += static_cast<size_t>(std::popcount(words_[w]));
    }
    return sum;
  }
  size_t number_of(size_t cell) const {
    const uint64_t lower = (uint64_t{1} << (cell % kCellsPerWord)) - 1;
    const size_t word = cell / kCellsPerWord;
    return before_[word] + static_cast<size_t>(std::popcount(words_[word] & lower));
  }

 private:
  Vec3 low_, cells_, origin_;
  double per_m_;
  std::vector<uint64_t> words_;
  std::vector<uint32_t> before_;  ///< cells with points before the word's
};

// From any thread: whatever the order, the least stays.
void keep_least(uint64_t& kept, uint64_t key) {
  std::atomic_ref<uint64_t> least(kept);
  uint64_t before = least.load(std::memory_order_relaxed);
  while (key < before && !least.compare_exchange_weak(before, key, std::memory_order_relaxed)) {
  }
}

// The point of each cell that is nearest to its middle: distance above, index below.
std::vector<uint64_t> middle_points(const Cloud& cloud, CellNumbers& cells, Task& task) {
  cells.make_room();
  parallel_for(task, cloud.size(), kSparsePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) cells.mark(cells.place_of(cloud.point(i)).cell);
  });
  std::vector<uint64_t> nearest(cells.number(), kNoPlace);
  parallel_for(task, cloud.size(), kSparsePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const CellNumbers::Place place = cells.place_of(cloud.point(i));
      keep_least(nearest[cells.number_of(place.cell)], place.off << 32 | i);
    }
  });
  return nearest;
}

}  // namespace

SparsePlaces sparse_places(const Cloud& cloud, const Vec3& origin, Task& task) {
  SparsePlaces out;
  const Box3 box = bounds(cloud, task);
  CellNumbers cells(box, origin, out.cell_m);
  const auto points = static_cast<double>(cloud.size());
  if (cells.count() > std::max(kLeastCells, kMostCellsPerPoint * points)) {
    out.xyz = voxel_centroids(cloud.xyz(), box, origin, out.cell_m, task);
    for (size_t i = 0; i < out.xyz.size(); ++i) out.xyz[i] -= origin[static_cast<int>(i % 3)];
    return out;
  }
  const std::vector<uint64_t> nearest = middle_points(cloud, cells, task);
  out.xyz = Buffer<double>(3 * nearest.size());
  for (size_t c = 0; c < nearest.size(); ++c) {
    const Vec3 p = cloud.point(nearest[c] & 0xffffffffu) - origin;
    for (int k = 0; k < 3; ++k) out.xyz[3 * c + static_cast<size_t>(k)] = p[k];
  }
  return out;
}

}  // namespace jalon
