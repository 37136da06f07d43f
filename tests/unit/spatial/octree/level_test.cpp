// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>

#include "spatial/octree/morton.h"
#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Sheets: 10 x 10 units, z = 1.5 sin(0.7 x) cos(0.5 y), sigma 0.003.
std::vector<double> sheet(size_t n, uint64_t seed, double bump, double shift) {
  RandomStream random(seed, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < n; ++i) {
    const double x = 10 * random.uniform(), y = 10 * random.uniform();
    const double r = std::hypot(x - 5, y - 5);
    double z = 1.5 * std::sin(0.7 * x) * std::cos(0.5 * y) + 0.003 * random.normal() + shift;
    if (r < 1.2) z += bump * 0.5 * (1 + std::cos(r / 1.2 * 3.14159265358979));
    xyz.insert(xyz.end(), {x, y, z});
  }
  return xyz;
}

// What a look at one cell costs, in points looked at: a search among the sorted codes, and memory far away.
constexpr double kCellCost = 300;

// Points and cells that the search of 2.3 must look at, of every seventh cell of the queries: shells around
// the cell until
// they hold the ball of each query's distance.
double work_at(const Octree& reference, const Octree& compared, const std::vector<Vec3>& queries,
               const std::vector<Neighbour>& found, int level, Task& task) {
  const double edge = reference.cube().edge / std::ldexp(1.0, level);
  double work = 0;
  const auto cells = compared.cells(level, task);
  for (size_t c = 0; c < cells.size(); c += 7) {
    const CellNumbers n = cell_numbers(cells[c].code);
    const Vec3 centre = reference.cube().origin + Vec3{n.p + 0.5, n.q + 0.5, n.r + 0.5} * edge;
    double reach = 0;
    for (size_t i = cells[c].first; i < cells[c].first + cells[c].count; ++i) {
      const Vec3 off = queries[i] - centre;
      const double inscribed =
          0.5 * edge - std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)});
      reach = std::max(reach, std::ceil((std::sqrt(found[i].squared_distance) - inscribed) / edge));
    }
    auto shells = reference.neighbour_cells(level, cells[c].code, static_cast<uint32_t>(reach));
    shells.push_back(cells[c].code);
    double points = 0;
    for (const uint64_t code : shells)
      points += static_cast<double>(reference.cell(level, code).count);
    work += kCellCost * static_cast<double>(shells.size()) +
            points * static_cast<double>(cells[c].count);
  }
  return work;
}

}  // namespace

TEST_CASE("best_level__is_at_most_2_levels_from_the_one_of_least_work_and_all_give_one_answer") {
  const bool full = std::getenv("JALON_FULL") != nullptr;
  const size_t thinning = full ? 1 : 10;
  const struct {
    const char* name;
    double bump, shift;
  } cases[] = {{"same shape", 0, 0}, {"bump", 0.6, 0}, {"bump and shift", 0.6, 0.15}};
  for (const auto& c : cases) {
    CAPTURE(c.name);
    const auto compared = sheet(625931 / thinning, 1, c.bump, c.shift),
               reference = sheet(627339 / thinning, 2, 0, 0);
    Box3 box = box_of(compared);
    box += box_of(reference);
    const Cube cube = enclosing_cube(box);
    Task task(threads(1));
    const auto tree1 = Octree::build(compared, cube, task),
               tree2 = Octree::build(reference, cube, task);
    const int chosen = best_level(*tree2, *tree1, 1, task);
    REQUIRE((chosen >= 4 && chosen <= 10));
    std::vector<Vec3> queries;
    for (size_t i = 0; i < tree1->size(); ++i)
      queries.push_back(point(compared, tree1->order()[i]));
    std::vector<Neighbour> found(queries.size()), again(queries.size());
    knn_at_level(*tree2, queries, 1, chosen, task, found);
    double least = INFINITY;
    int best = 0;
    std::string line;
    for (int level = 4; level <= 10; ++level) {
      const std::clock_t start = std::clock();
      knn_at_level(*tree2, queries, 1, level, task, again);
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      size_t other = 0;
      for (size_t i = 0; i < found.size(); ++i) other += again[i].index != found[i].index;
      CHECK(other == 0);
      const double work = work_at(*tree2, *tree1, queries, found, level, task);
      if (work < least) least = work, best = level;
      line += " " + std::to_string(level) + ":" + std::to_string(seconds) + "/" +
              std::to_string(work / static_cast<double>(queries.size()));
    }
    MESSAGE("FIGURE " << std::string(c.name) << ": formula 4.2 picks " << chosen
                      << ", least work at " << best << "; seconds/work a query by level" << line);
    CHECK(std::abs(chosen - best) <= 2);
  }
}

TEST_CASE("level__gives_the_neighbours_of_crowds_at_any_level") {
  for (const HostileCloud& cloud : hostile_clouds(2000)) {
    CAPTURE(cloud.name);
    const auto tree = build(cloud.xyz);
    Task task;
    std::vector<Vec3> queries;
    for (size_t i = 0; i < 2000; i += 41) queries.push_back(point(cloud.xyz, i));
    for (const int level : {1, 12, 21}) {
      std::vector<Neighbour> found(queries.size() * 6);
      knn_at_level(*tree, queries, 6, level, task, found);
      for (size_t q = 0; q < queries.size(); ++q) {
        const auto truth = brute_force(cloud.xyz, queries[q], 6);
        for (size_t j = 0; j < 6; ++j) REQUIRE(found[6 * q + j].index == truth[j].index);
      }
    }
  }
}

// A cell of any level but the deepest holds all points but one: to look at all of them for each query would be the
// square of their number, and a cancel would come late.
TEST_CASE("level__gives_the_neighbours_of_a_cloud_with_one_point_far_away") {
  std::vector<double> xyz = street(40000);
  xyz[0] = xyz[1] = -1e7;
  const auto tree = build(xyz);
  std::vector<Vec3> queries;
  for (size_t i = 0; i < 40000; ++i) queries.push_back(point(xyz, i));
  Task task;
  std::vector<Neighbour> found(queries.size() * 6), truth(6);
  knn_at_level(*tree, queries, 6, 1, task, found);
  for (size_t q = 0; q < queries.size(); q += 97) {
    REQUIRE(tree->knn(queries[q], 6, truth) == 6);
    for (size_t j = 0; j < 6; ++j) {
      REQUIRE(found[6 * q + j].index == truth[j].index);
      REQUIRE(found[6 * q + j].squared_distance == truth[j].squared_distance);
    }
  }
}
