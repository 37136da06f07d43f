// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/cell_firsts.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kCellFirstsPointsPerChunk = size_t{1} << 16;

// The coarsest level at which a cell begins with this position; kMaxLevel + 1 when none does.
uint8_t first_level(const Octree& tree, size_t position) {
  if (position == 0) return 0;
  const uint64_t differing = tree.code(position) ^ tree.code(position - 1);
  if (differing == 0) return kMaxLevel + 1;
  return static_cast<uint8_t>(kMaxLevel - (std::bit_width(differing) - 1) / 3);
}

}  // namespace

std::vector<std::vector<uint32_t>> cell_firsts(const Octree& tree, int coarse, int fine,
                                               Buffer<uint8_t>& scratch, Task& task) {
  const size_t levels = static_cast<size_t>(fine - coarse) + 1, n = tree.size();
  // 1. At which level each position begins a cell, and how many do so in each chunk.
  std::vector<std::vector<uint32_t>> room((n + kCellFirstsPointsPerChunk - 1) /
                                          kCellFirstsPointsPerChunk);
  parallel_for(task, n, kCellFirstsPointsPerChunk, [&](size_t begin, size_t end) {
    std::vector<uint32_t> counts(levels, 0);
    for (size_t i = begin; i < end; ++i) {
      scratch[i] = first_level(tree, i);
      for (int level = std::max<int>(scratch[i], coarse); level <= fine; ++level)
        ++counts[static_cast<size_t>(level - coarse)];
    }
    room[begin / kCellFirstsPointsPerChunk] = std::move(counts);
  });
  // 2. Where the chunks write.
  std::vector<std::vector<uint32_t>> firsts(levels);
  for (size_t k = 0; k < levels; ++k) {
    uint32_t total = 0;
    for (auto& counts : room) total += std::exchange(counts[k], total);
    firsts[k].resize(total + 1);
    firsts[k].back() = static_cast<uint32_t>(n);
  }
  // 3. The positions.
  parallel_for(task, n, kCellFirstsPointsPerChunk, [&](size_t begin, size_t end) {
    std::vector<uint32_t>& next = room[begin / kCellFirstsPointsPerChunk];
    for (size_t i = begin; i < end; ++i)
      for (int level = std::max<int>(scratch[i], coarse); level <= fine; ++level) {
        const auto k = static_cast<size_t>(level - coarse);
        firsts[k][next[k]++] = static_cast<uint32_t>(i);
      }
  });
  return firsts;
}

}  // namespace jalon
