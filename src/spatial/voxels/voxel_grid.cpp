// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Cells by sorting: the three cell numbers of a point, counted from the lowest ones in use, are packed into one 64-bit
// key; keys are parted by their highest bits in parallel, and each part is sorted in the cache.

#include "spatial/voxels/voxel_grid.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "base/parallel.h"
#include "spatial/partition.h"
#include "spatial/radix_sort.h"
#include "spatial/voxels/voxel_numbers.h"

namespace jalon {

namespace {

constexpr size_t kVoxelGridGrain = size_t{1} << 15;

Box3 range_of(std::span<const double> xyz, Task& task) {
  return parallel_reduce(task, xyz.size() / 3, kVoxelGridGrain, Box3{},
                         [&](size_t begin, size_t end) {
                           Box3 part;
                           for (size_t i = begin; i < end; ++i)
                             part.add({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]});
                           return part;
                         });
}

struct KeyedIndex {
  uint64_t key;
  uint32_t index;
};

// Sorts one part; out takes the indices, ends the places (in the part) where a cell begins.
void sort_part(const KeyedIndex* part, size_t n, KeyedRange keys, KeyedRange scratch, uint32_t* out,
               size_t offset, std::vector<uint32_t>& firsts) {
  for (size_t i = 0; i < n; ++i) {
    keys.keys[i] = part[i].key;
    keys.values[i] = part[i].index;
  }
  sort_pairs(keys, scratch, n);
  for (size_t i = 0; i < n; ++i) {
    out[i] = keys.values[i];
    if (i == 0 || keys.keys[i] != keys.keys[i - 1])
      firsts.push_back(static_cast<uint32_t>(offset + i));
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

VoxelGrid voxel_lists(std::span<const double> xyz, const Vec3& origin, double cell_m, Task& task) {
  const size_t n = xyz.size() / 3;
  require_voxels(n, cell_m);
  VoxelGrid grid;
  if (n == 0) return grid;
  Buffer<KeyedIndex> records(n);
  std::vector<size_t> begins;
  {
    ProgressSpan span(task, 0, 0.6, "sorting points into cells");
    have_pages(records.data(), n, task);
    const VoxelNumbers numbering(xyz, range_of(xyz, task), origin, cell_m, task);
    Buffer<uint64_t> keys(n);  // made once: divisions cost more than memory
    parallel_for(task, n, kVoxelGridGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) keys[i] = numbering.key(i);
    });
    // Parts of about a thousand points, at most 4096 of them.
    const int digit_bits =
        std::min({12, numbering.key_bits(), static_cast<int>(std::bit_width(n >> 10))});
    const int shift = numbering.key_bits() - digit_bits;
    begins = partition(
        n, size_t{1} << digit_bits,
        [=](const KeyedIndex& r) { return digit_bits == 0 ? 0 : r.key >> shift; }, task,
        records.data(),
        [&](size_t i) {
          return KeyedIndex{keys[i], static_cast<uint32_t>(i)};
        });
  }
  grid.order = Buffer<uint32_t>(n);
  const auto groups = groups_of(begins.size() - 1, kVoxelGridGrain,
                                [&](size_t b) { return begins[b + 1] - begins[b]; });
  std::vector<std::vector<uint32_t>> firsts(groups.size() - 1);
  {
    ProgressSpan span(task, 0.6, 1);
    parallel_chunks(task, firsts.size(), [&](size_t g) {
      size_t most = 0;
      for (size_t b = groups[g]; b < groups[g + 1]; ++b)
        most = std::max(most, begins[b + 1] - begins[b]);
      Buffer<uint64_t> keys(2 * most);
      Buffer<uint32_t> values(2 * most);
      for (size_t b = groups[g]; b < groups[g + 1]; ++b)
        sort_part(records.data() + begins[b], begins[b + 1] - begins[b],
                  {keys.data(), values.data()}, {keys.data() + most, values.data() + most},
                  grid.order.data() + begins[b], begins[b], firsts[g]);
    });
  }
  size_t cells = 0;
  for (const auto& part : firsts) cells += part.size();
  grid.first = Buffer<uint32_t>(cells + 1);
  size_t at = 0;
  for (const auto& part : firsts)
    for (const uint32_t first : part) grid.first[at++] = first;
  grid.first[cells] = static_cast<uint32_t>(n);
  return grid;
}

VoxelGrid voxel_grid(std::span<const double> xyz, const Vec3& origin, double cell_m, Task& task) {
  VoxelGrid grid;
  {
    ProgressSpan span(task, 0, 0.8);
    grid = voxel_lists(xyz, origin, cell_m, task);
  }
  if (grid.size() == 0) return grid;
  ProgressSpan span(task, 0.8, 1);
  add_centroids(xyz, origin, grid, task);
  return grid;
}

}  // namespace jalon
