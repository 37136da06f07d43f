// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Sums over boxes of cells, and the box with the greatest one.
#include <doctest/doctest.h>

#include <vector>

#include "base/random.h"
#include "modelling/evidence/box_search.h"

using namespace jalon;

namespace {

struct ScoredGrid {
  uint32_t columns, rows;
  std::vector<int64_t> scores;
  CellSums<int64_t> sums() const {
    return {columns, rows, [&](size_t k) { return scores[k]; }};
  }
  int64_t slow_sum(const CellBox& box) const {
    int64_t sum = 0;
    for (uint32_t r = box.r0; r < box.r1; ++r)
      for (uint32_t c = box.c0; c < box.c1; ++c) sum += scores[size_t{r} * columns + c];
    return sum;
  }
};

ScoredGrid random_scores(uint32_t columns, uint32_t rows, uint64_t seed) {
  RandomStream random(seed, 21);
  ScoredGrid out{columns, rows, {}};
  for (size_t k = 0; k < size_t{columns} * rows; ++k)
    out.scores.push_back(static_cast<int64_t>(21 * random.uniform()) - 11);
  return out;
}

// f of every box that is not empty.
template <class F>
void for_all_boxes(uint32_t columns, uint32_t rows, F&& f) {
  for (uint32_t c0 = 0; c0 < columns; ++c0)
    for (uint32_t c1 = c0 + 1; c1 <= columns; ++c1)
      for (uint32_t r0 = 0; r0 < rows; ++r0)
        for (uint32_t r1 = r0 + 1; r1 <= rows; ++r1) f(CellBox{c0, r0, c1, r1});
}

}  // namespace

TEST_CASE("cell_sums__of_every_box_are_those_of_its_cells") {
  const ScoredGrid grid = random_scores(7, 5, 1);
  const CellSums<int64_t> sums = grid.sums();
  size_t wrong = 0;
  for_all_boxes(7, 5, [&](const CellBox& b) {
    wrong += sums.of(b.c0, b.r0, b.c1, b.r1) != grid.slow_sum(b);
  });
  CHECK(wrong == 0);
  CHECK(sums.of(3, 2, 3, 4) == 0);
}

TEST_CASE("best_box__of_small_grids_is_the_best_of_all_boxes") {
  for (uint64_t seed = 1; seed <= 100; ++seed)
    for (const auto& [columns, rows] : {std::pair{12u, 9u}, {9u, 12u}}) {
      const ScoredGrid grid = random_scores(columns, rows, seed);
      int64_t most = 0;
      for_all_boxes(columns, rows,
                    [&](const CellBox& box) { most = std::max(most, grid.slow_sum(box)); });
      const ScoredBox best = best_box(grid.sums(), columns, rows);
      CHECK(best.sum == most);
      CHECK(grid.slow_sum(best.box) == best.sum);
    }
}

TEST_CASE("best_box__is_empty_where_no_cell_is_above_zero") {
  const ScoredGrid grid{6, 4, std::vector<int64_t>(24, -1)};
  const ScoredBox best = best_box(grid.sums(), 6, 4);
  CHECK(best.sum == 0);
  CHECK(best.box.width() * best.box.height() == 0);
}

TEST_CASE("best_box__on_large_grids_comes_to_the_cell_whatever_the_coarse_one_cuts") {
  RandomStream random(3, 21);
  for (int k = 0; k < 20; ++k)
    for (const auto& [columns, rows] : {std::pair{700u, 340u}, {300u, 950u}}) {
      const auto c0 = static_cast<uint32_t>(150 * random.uniform()),
                 r0 = static_cast<uint32_t>(150 * random.uniform());
      const CellBox truth{c0, r0, c0 + 31, r0 + 47};
      ScoredGrid grid{columns, rows, std::vector<int64_t>(size_t{columns} * rows, -3)};
      for (uint32_t r = truth.r0; r < truth.r1; ++r)
        for (uint32_t c = truth.c0; c < truth.c1; ++c) grid.scores[size_t{r} * columns + c] = 2;
      const ScoredBox best = best_box(grid.sums(), columns, rows);
      CHECK(best.sum == 2 * 31 * 47);
      CHECK(best.box.c0 == truth.c0);
      CHECK(best.box.r0 == truth.r0);
    }
}

TEST_CASE("cell_box_of__cells_anywhere__is_the_least_that_holds_them") {
  constexpr uint32_t kColumns = 7;
  const std::vector<uint32_t> cells{2 * kColumns + 5, 4 * kColumns + 1, 3 * kColumns + 3};
  const CellBox box = cell_box_of(cells, kColumns);
  CHECK(box.c0 == 1);
  CHECK(box.r0 == 2);
  CHECK(box.c1 == 6);
  CHECK(box.r1 == 5);
  CHECK(cell_box_of({}, kColumns).width() == 0);
}
