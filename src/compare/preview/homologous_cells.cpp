// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/preview/homologous_cells.h"

#include <algorithm>

#include "base/parallel.h"

namespace jalon {

namespace {

// First position behind the cell that holds position at: doubled steps, then halves.
size_t end_of_cell(const Octree& tree, int shift, size_t at) {
  const uint64_t cell = tree.code(at) >> shift;
  size_t low = at, step = 1;  // low is in the cell
  while (low + step < tree.size() && tree.code(low + step) >> shift == cell) {
    low += step;
    step *= 2;
  }
  size_t high = std::min(tree.size(), low + step);  // high is not
  while (high - low > 1) {
    const size_t middle = low + (high - low) / 2;
    (tree.code(middle) >> shift == cell ? low : high) = middle;
  }
  return high;
}

}  // namespace

std::vector<Octree::Cell> occupied_cells(const Octree& tree, int level, Task& task) {
  constexpr size_t kGrain = size_t{1} << 16;
  const int shift = 3 * (kMaxLevel - level);
  std::vector<std::vector<Octree::Cell>> parts((tree.size() + kGrain - 1) / kGrain);
  parallel_for(task, tree.size(), kGrain, [&](size_t begin, size_t end) {
    size_t at = begin;  // a cell belongs to the chunk that it begins in
    if (begin > 0 && tree.code(begin - 1) >> shift == tree.code(begin) >> shift)
      at = end_of_cell(tree, shift, begin);
    while (at < end) {
      const size_t next = end_of_cell(tree, shift, at);
      parts[begin / kGrain].push_back({tree.code(at) >> shift, at, next - at});
      at = next;
    }
  });
  std::vector<Octree::Cell> cells;
  for (const auto& part : parts) cells.insert(cells.end(), part.begin(), part.end());
  return cells;
}

std::vector<CellPair> homologous_cells(const Octree& reference, const Octree& compared, int level,
                                       Task& task) {
  const auto r = occupied_cells(reference, level, task), c = occupied_cells(compared, level, task);
  std::vector<CellPair> pairs;
  size_t i = 0;
  for (const Octree::Cell& cell : c) {
    while (i < r.size() && r[i].code < cell.code) ++i;
    if (i < r.size() && r[i].code == cell.code)
      pairs.push_back({cell.code, r[i].first, r[i].count, cell.first, cell.count});
  }
  return pairs;
}

}  // namespace jalon
