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

// The coarsest level at which a cell begins with a point, by its code and that of the point before; kMaxLevel + 1 when
// none does.
uint8_t first_level(uint64_t code, uint64_t before) {
  const uint64_t differing = code ^ before;
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
    uint64_t before = begin > 0 ? tree.code(begin - 1) : 0;
    for (size_t i = begin; i < end; ++i) {
      const uint64_t code = tree.code(i);
      scratch[i] = i > 0 ? first_level(code, before) : 0;
      before = code;
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
