// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Points in the cells of a sparse raster, against a look at all of them.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "base/random.h"
#include "modelling/plane/cell_rows.h"

using namespace jalon;

namespace {

std::vector<Vec2> scattered(size_t n, double width_m) {
  RandomStream random(n, 4);
  std::vector<Vec2> out;
  for (size_t i = 0; i < n; ++i)
    out.push_back({width_m * random.uniform() - 3, width_m * random.uniform() + 7});
  return out;
}

}  // namespace

TEST_CASE("cell_rows__every_point_is_in_the_cell_of_its_key_ascending_within_it") {
  Task task;
  for (const double width_m : {1.0, 1e6}) {  // counted and compared
    const auto points = scattered(500, width_m);
    const CellRows rows = sort_into_cells(points, 0.1, task);
    CHECK(rows.cell_m == 0.1);
    REQUIRE(rows.first.size() == rows.keys.size() + 1);
    CHECK(std::is_sorted(rows.keys.begin(), rows.keys.end()));
    CHECK(std::adjacent_find(rows.keys.begin(), rows.keys.end()) == rows.keys.end());
    std::vector<uint8_t> seen(points.size(), 0);
    for (size_t c = 0; c < rows.keys.size(); ++c) {
      REQUIRE(rows.first[c] < rows.first[c + 1]);
      CHECK(rows.find(rows.keys[c]) == c);
      for (uint32_t k = rows.first[c]; k < rows.first[c + 1]; ++k) {
        if (k > rows.first[c]) CHECK(rows.order[k - 1] < rows.order[k]);
        CHECK(rows.key_of(points[rows.order[k]]) == rows.keys[c]);
        ++seen[rows.order[k]];
      }
    }
    CHECK(std::count(seen.begin(), seen.end(), 1) == 500);
    CHECK(rows.find(rows.keys.back() + 1) == rows.keys.size());
  }
}

TEST_CASE("cell_rows__too_many_cells_for_31_bits_get_larger_ones") {
  Task task;
  const std::vector<Vec2> points{{0, 0}, {1e6, 1}, {5e5, 0.5}};
  const CellRows rows = sort_into_cells(points, 1e-6, task);
  CHECK(rows.cell_m > 1e-6);
  CHECK((rows.keys.back() & 0xffffffffu) < 0x80000000u);
  CHECK(sort_into_cells(std::vector<Vec2>{{2, 3}}, 0.1, task).order == std::vector<uint32_t>{0});
}

TEST_CASE("cell_rows__erosion_leaves_cells_whose_eight_neighbours_are_marked") {
  Task task;
  std::vector<Vec2> points;
  for (int r = 0; r < 7; ++r)
    for (int c = 0; c < 9; ++c)
      if (!(r == 3 && c == 5)) points.push_back({c + 0.5, r + 0.5});
  const CellRows rows = sort_into_cells(points, 1, task);
  std::vector<uint8_t> marked(rows.keys.size(), 1);
  marked[rows.find(rows.key_of({2.5, 1.5}))] = 0;
  const auto is_marked = [&](double u, double v) {
    if (u < 0 || v < 0 || u > 9 || v > 7) return false;
    const size_t c = rows.find(rows.key_of({u, v}));
    return c < rows.keys.size() && marked[c] != 0;
  };
  const auto out = eroded(rows, marked);
  REQUIRE(out.size() == points.size());
  int left = 0;
  for (const Vec2& p : points) {
    bool all = true;
    for (int dr = -1; dr <= 1; ++dr)
      for (int dc = -1; dc <= 1; ++dc) all = all && is_marked(p.u + dc, p.v + dr);
    CAPTURE(p.u);
    CAPTURE(p.v);
    CHECK(out[rows.find(rows.key_of(p))] == (all ? 1 : 0));
    left += all;
  }
  CHECK(left > 0);
}

TEST_CASE("cell_rows__a_box_visits_all_points_in_it_once") {
  Task task;
  PointRows all;
  all.points = scattered(400, 2);
  all.sort(0.13, task);
  RandomStream random(1, 5);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec2 low{-4 + 3 * random.uniform(), 6 + 3 * random.uniform()};
    const Vec2 high = low + Vec2{random.uniform(), random.uniform()};
    std::vector<int> seen(all.points.size(), 0);
    all.visit(low, high, [&](uint32_t i) { ++seen[i]; });
    for (size_t i = 0; i < seen.size(); ++i) {
      const Vec2& p = all.points[i];
      const bool inside = p.u >= low.u && p.u <= high.u && p.v >= low.v && p.v <= high.v;
      CHECK(seen[i] <= 1);
      if (inside) CHECK(seen[i] == 1);
      // Whole cells: nothing from further than one of them.
      if (p.u < low.u - 0.13 || p.v > high.v + 0.13) CHECK(seen[i] == 0);
    }
  }
  PointRows none;
  none.sort(1, task);
  none.visit({0, 0}, {1, 1}, [](uint32_t) { FAIL("there is no point"); });
}
