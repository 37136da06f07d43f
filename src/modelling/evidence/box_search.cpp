// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/box_search.h"

#include <algorithm>
#include <array>
#include <vector>

namespace jalon {

namespace {

constexpr uint32_t kMostLines = 110, kMostOtherLines = 800;

// Sums of blocks of cells, as lines the shorter way.
struct CoarseGrid {
  const CellSums<int64_t>& sums;
  uint32_t columns, rows, step;
  bool turned;  // lines are columns

  uint32_t lines() const { return ((turned ? columns : rows) + step - 1) / step; }
  uint32_t others() const { return ((turned ? rows : columns) + step - 1) / step; }
  int64_t of(uint32_t line, uint32_t other) const {
    uint32_t c = (turned ? line : other) * step, r = (turned ? other : line) * step;
    return sums.of(c, r, std::min(columns, c + step), std::min(rows, r + step));
  }
  CellBox box(uint32_t line0, uint32_t line1, uint32_t other0, uint32_t other1) const {
    const auto cut = [&](uint32_t at, uint32_t most) { return std::min(most, at * step); };
    if (turned)
      return {cut(line0, columns), cut(other0, rows), cut(line1, columns), cut(other1, rows)};
    return {cut(other0, columns), cut(line0, rows), cut(other1, columns), cut(line1, rows)};
  }
};

ScoredBox best_coarse_box(const CoarseGrid& grid) {
  ScoredBox best;
  const uint32_t lines = grid.lines(), others = grid.others();
  std::vector<int64_t> blocks(size_t{lines} * others), band(others);
  for (uint32_t a = 0; a < lines; ++a)
    for (uint32_t b = 0; b < others; ++b) blocks[size_t{a} * others + b] = grid.of(a, b);
  for (uint32_t from = 0; from < lines; ++from) {
    std::fill(band.begin(), band.end(), 0);
    for (uint32_t to = from; to < lines; ++to) {
      const int64_t* line = &blocks[size_t{to} * others];
      int64_t sum = 0;
      uint32_t start = 0;
      for (uint32_t k = 0; k < others; ++k) {
        band[k] += line[k];
        if (sum <= 0) {
          sum = 0;
          start = k;
        }
        sum += band[k];
        if (sum > best.sum) best = {grid.box(from, to + 1, start, k + 1), sum};
      }
    }
  }
  return best;
}

// Moves one side after the other by halved steps.
void refine(const CellSums<int64_t>& sums, uint32_t columns, uint32_t rows, uint32_t step,
            ScoredBox& best) {
  for (uint32_t move = step; move > 0; move /= 2)
    for (bool better = true; better;) {
      better = false;
      for (int side = 0; side < 8; ++side) {
        CellBox box = best.box;
        uint32_t& line = std::array{&box.c0, &box.r0, &box.c1, &box.r1}[side / 2][0];
        const uint32_t most = side / 2 % 2 == 0 ? columns : rows;
        if (side % 2 == 0) line = std::min(most, line + move);
        else line = line > move ? line - move : 0;
        if (box.c0 >= box.c1 || box.r0 >= box.r1) continue;
        const int64_t sum = sums.of(box.c0, box.r0, box.c1, box.r1);
        if (sum <= best.sum) continue;
        best = {box, sum};
        better = true;
      }
    }
}

}  // namespace

ScoredBox best_box(const CellSums<int64_t>& sums, uint32_t columns, uint32_t rows) {
  const uint32_t shorter = std::min(columns, rows), longer = std::max(columns, rows);
  const uint32_t step = std::max({1u, (shorter + kMostLines - 1) / kMostLines,
                                  (longer + kMostOtherLines - 1) / kMostOtherLines});
  ScoredBox best = best_coarse_box({sums, columns, rows, step, columns < rows});
  if (best.sum > 0) refine(sums, columns, rows, std::max(1u, step), best);
  return best;
}

}  // namespace jalon
