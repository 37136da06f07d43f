// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Cells that hold points of two clouds, against counting every point by its coordinates.
#include "compare/preview/homologous_cells.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>

#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using CellPlace = std::array<int, 3>;

CellPlace place_of(const Vec3& p, int level) {
  CellPlace out{};
  for (int i = 0; i < 3; ++i)
    out[static_cast<size_t>(i)] = static_cast<int>(std::floor(std::ldexp(p[i], level)));
  return out;
}

std::map<CellPlace, size_t> counted(const Cloud& cloud, int level) {
  std::map<CellPlace, size_t> out;
  for (size_t i = 0; i < cloud.size(); ++i) ++out[place_of(cloud.point(i), level)];
  return out;
}

/// The cell that all of these sorted positions lie in; {-1, -1, -1} where they do not lie in one.
CellPlace common_place(const Cloud& cloud, const Octree& tree, size_t first, size_t count,
                       int level) {
  const CellPlace out = place_of(cloud.point(tree.order()[first]), level);
  for (size_t i = first; i < first + count; ++i)
    if (place_of(cloud.point(tree.order()[i]), level) != out) return {-1, -1, -1};
  return out;
}

}  // namespace

TEST_CASE("homologous_cells__are_those_with_points_of_both_and_hold_all_of_them") {
  Task task;
  const Cloud a = cloud_of(random_points(3000, 0.999, 1)),
              b = cloud_of(shifted(random_points(2000, 0.5, 2), {0.3, 0.4, 0.45}));
  const auto tree_a = Octree::build(a.xyz(), {{}, 1}, task),
             tree_b = Octree::build(b.xyz(), {{}, 1}, task);
  for (const int level : {0, 1, 3, 4, 6}) {
    const auto of_a = counted(a, level), of_b = counted(b, level);
    size_t both = 0;
    for (const auto& [place, count] : of_a) both += of_b.count(place);
    const auto pairs = homologous_cells(*tree_a, *tree_b, level, task);
    REQUIRE(pairs.size() == both);
    uint64_t before = 0;
    for (const CellPair& pair : pairs) {
      CHECK((before == 0 || pair.code > before));
      before = pair.code;
      const CellPlace place =
          common_place(a, *tree_a, pair.reference_first, pair.reference_count, level);
      REQUIRE(place == common_place(b, *tree_b, pair.compared_first, pair.compared_count, level));
      CHECK(of_a.at(place) == pair.reference_count);
      CHECK(of_b.at(place) == pair.compared_count);
    }
  }
}

TEST_CASE("homologous_cells__are_none_of_clouds_apart_but_the_whole_cube") {
  Task task;
  const Cloud left = cloud_of(random_points(500, 0.4, 3)),
              right = cloud_of(shifted(random_points(500, 0.4, 4), {0.55, 0, 0}));
  const auto tree_l = Octree::build(left.xyz(), {{}, 1}, task),
             tree_r = Octree::build(right.xyz(), {{}, 1}, task);
  CHECK(homologous_cells(*tree_l, *tree_r, 1, task).empty());
  const auto whole = homologous_cells(*tree_l, *tree_r, 0, task);
  REQUIRE(whole.size() == 1);
  CHECK(whole[0].reference_count == 500);
  CHECK(whole[0].compared_count == 500);
}

TEST_CASE("occupied_cells__reach_over_the_threads_chunks_whole") {
  // Chunks are of 2^16 sorted points; cells of 100000 and 50000 points begin in one and end in another.
  auto points = shifted(random_points(100000, 0.4, 5), {0.05, 0.05, 0.05});
  for (const Vec3& p : shifted(random_points(50000, 0.4, 6), {0.55, 0.55, 0.55}))
    points.push_back(p);
  const Cloud cloud = cloud_of(points);
  for (const unsigned n : {1u, 2u}) {
    Task task(threads(n));
    const auto tree = Octree::build(cloud.xyz(), {{}, 1}, task);
    const auto cells = occupied_cells(*tree, 1, task);
    REQUIRE(cells.size() == 2);
    CHECK(cells[0].first == 0);
    CHECK(cells[0].count == 100000);
    CHECK(cells[1].first == 100000);
    CHECK(cells[1].count == 50000);
  }
}
