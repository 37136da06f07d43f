// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/octree/octree.h"

#include <doctest/doctest.h>

#include <ctime>
#include <functional>
#include <set>
#include <string>

#include "base/error.h"
#include "spatial/octree/morton.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// 2.1 step 3: p = min(2^N - 1, floor((x - O) 2^N / L)), written bit by bit.
uint64_t closed_form(const Cube& cube, const Vec3& point, int level) {
  uint64_t code = 0;
  uint64_t number[3];
  const double cells = std::ldexp(1.0, level);
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::floor((point[axis] - cube.origin[axis]) * cells / cube.edge);
    number[axis] = static_cast<uint64_t>(std::min(cells - 1, cell));
  }
  for (int bit = level - 1; bit >= 0; --bit)
    for (auto n : number) code = code << 1 | (n >> bit & 1);
  return code;
}

}  // namespace

TEST_CASE("octree__codes_equal_the_closed_form_and_are_sorted_with_their_indices") {
  const auto xyz = street(20000);
  const auto tree = build(xyz);
  std::vector<bool> seen(tree->size());
  for (size_t i = 0; i < tree->size(); ++i) {
    const uint32_t index = tree->order()[i];
    REQUIRE_FALSE(seen[index]);
    seen[index] = true;
    REQUIRE(tree->code(i) == closed_form(tree->cube(), point(xyz, index), kMaxLevel));
    if (i == 0) continue;
    const bool ascending = tree->code(i - 1) < tree->code(i) ||
                           (tree->code(i - 1) == tree->code(i) && tree->order()[i - 1] < index);
    REQUIRE(ascending);
    REQUIRE(norm(tree->local(i) + tree->cube().origin - point(xyz, index)) < 2 * tree->grid_step());
  }
}

TEST_CASE("morton__increment_and_decrement_equal_integer_arithmetic_at_all_levels") {
  RandomStream random(3, 0);
  for (int level = 1; level <= kMaxLevel; ++level) {
    const uint32_t side = 1u << level;
    for (int n = 0; n < 400; ++n) {
      uint32_t number[3];
      for (auto& v : number) {  // borders as often as not
        const uint64_t kind = random.below(4);
        v = kind == 0 ? 0 : kind == 1 ? side - 1 : static_cast<uint32_t>(random.below(side));
      }
      const uint64_t code = morton_code(number[0], number[1], number[2]);
      const CellNumbers back = cell_numbers(code);
      REQUIRE((back.p == number[0] && back.q == number[1] && back.r == number[2]));
      for (int axis = 0; axis < 3; ++axis) {
        uint32_t up[3] = {number[0], number[1], number[2]},
                 down[3] = {number[0], number[1], number[2]};
        uint64_t next = code, before = code;
        const bool has_next = increment_cell(next, level, axis),
                   has_before = decrement_cell(before, level, axis);
        REQUIRE(has_next == (number[axis] + 1 < side));
        REQUIRE(has_before == (number[axis] > 0));
        ++up[axis];
        --down[axis];
        if (has_next) REQUIRE(next == morton_code(up[0], up[1], up[2]));
        if (has_before) REQUIRE(before == morton_code(down[0], down[1], down[2]));
      }
    }
  }
}

TEST_CASE("octree__cell_counts_cells_and_neighbours_equal_sets") {
  const auto xyz = street(3000);
  const auto tree = build(xyz);
  Task task;
  const auto counts = tree->cell_counts(task);
  REQUIRE(counts.size() == kMaxLevel + 1);
  for (int level = 0; level <= kMaxLevel; ++level) {
    std::set<uint64_t> occupied;
    for (size_t i = 0; i < tree->size(); ++i)
      occupied.insert(closed_form(tree->cube(), point(xyz, i), level));
    CHECK(counts[static_cast<size_t>(level)] == occupied.size());
    const auto cells = tree->cells(level, task);
    REQUIRE(cells.size() == occupied.size());
    size_t next = 0;
    auto code = occupied.begin();
    for (const auto& cell : cells) {
      REQUIRE(cell.code == *code++);
      REQUIRE(cell.first == next);
      REQUIRE(tree->cell(level, cell.code).count == cell.count);
      next += cell.count;
    }
    CHECK(next == tree->size());
    for (const uint32_t reach : {1u, 3u, 40u}) {
      const uint64_t centre = cells[cells.size() / 2].code;
      const CellNumbers c = cell_numbers(centre);
      std::vector<uint64_t> expected;
      for (const uint64_t other : occupied) {
        const CellNumbers n = cell_numbers(other);
        const auto far = [&](uint32_t a, uint32_t b) { return (a > b ? a - b : b - a) > reach; };
        if (other != centre && !far(c.p, n.p) && !far(c.q, n.q) && !far(c.r, n.r))
          expected.push_back(other);
      }
      CHECK(tree->neighbour_cells(level, centre, reach) == expected);
    }
  }
}

TEST_CASE("octree__is_the_same_for_any_number_of_threads") {
  const auto xyz = street(200000);
  const auto one = build(xyz, 1);
  for (const unsigned count : {2u, 7u}) {
    const auto other = build(xyz, count);
    REQUIRE(std::equal(one->order().begin(), one->order().end(), other->order().begin()));
    REQUIRE(std::equal(one->grid_x(), one->grid_x() + one->size(), other->grid_x()));
    CHECK(one->memory_bytes() == other->memory_bytes());
  }
  MESSAGE("index: " << static_cast<double>(one->memory_bytes()) / static_cast<double>(one->size())
                    << " bytes a point");
  CHECK(one->memory_bytes() <= 24 * one->size());
}

TEST_CASE("octree__whole_metre_shifts_change_no_bit_on_a_2^-20_m_grid") {
  for (const double scale : {1.0, 0x1p-8}) {  // a street, and something of a few centimetres
    auto xyz = street(20000, 5);
    for (double& v : xyz) v = std::round(v * scale * 0x1p20) * 0x1p-20;
    auto shifted = xyz;
    for (size_t i = 0; i < xyz.size(); ++i)
      shifted[i] += i % 3 == 0 ? 652000.0 : i % 3 == 1 ? 6861000.0 : 35.0;
    const auto a = build(xyz), b = build(shifted);
    CHECK(a->cube().edge == b->cube().edge);
    CHECK(b->cube().origin == a->cube().origin + Vec3{652000, 6861000, 35});
    REQUIRE(std::equal(a->order().begin(), a->order().end(), b->order().begin()));
    REQUIRE(std::equal(a->grid_y(), a->grid_y() + a->size(), b->grid_y()));
    CHECK(all_knn(*a, 12) == all_knn(*b, 12));
  }
}

TEST_CASE("octree__takes_degenerate_clouds") {
  Task task;
  const auto none = build({});
  CHECK(none->size() == 0);
  CHECK(none->cells(5, task).empty());
  CHECK(none->cell_counts(task)[3] == 0);
  Neighbour out[4];
  CHECK(none->knn({1, 2, 3}, 4, out) == 0);
  CHECK(all_knn(*none, 4).index.empty());
  const auto one = build({652000.25, 6861000.5, 12.125});
  CHECK(one->knn({0, 0, 0}, 4, out) == 1);
  CHECK(all_knn(*one, 2).index == std::vector<uint32_t>{0, kNoPoint});
  std::vector<double> equal, line;
  for (int i = 0; i < 3000; ++i) {
    equal.insert(equal.end(), {1.5, 2.5, 3.5});
    line.insert(line.end(), {std::ldexp(1.0, -i % 40), 0, 0});
  }
  const auto same = build(equal);
  CHECK(same->cell_counts(task)[kMaxLevel] == 1);
  CHECK(all_knn(*same, 3).index[8999] == 2);  // ties by index: the first three for every point
  const auto spaced = build(line);
  CHECK(spaced->knn({0, 0, 0}, 1, out) == 1);
  CHECK(out[0].index == 39);
}

TEST_CASE("octree__refuses_clouds_that_no_cube_holds") {
  CHECK_THROWS_AS(enclosing_cube(Box3{{-1e300, 0, 0}, {1e300, 0, 0}}), Error);
}

TEST_CASE("octree__stops_on_cancel_and_builds_afterwards") {
  const auto xyz = street(100000);
  std::atomic<bool> cancel{true};
  Task::Hooks hooks = threads(2);
  hooks.cancel = &cancel;
  const Cube cube = enclosing_cube(box_of(xyz));
  {
    Task task(hooks);
    CHECK_THROWS_AS(Octree::build(xyz, cube, task), Error);
  }
  cancel = false;
  Task task(hooks);
  CHECK(Octree::build(xyz, cube, task)->size() == 100000);
}

TEST_CASE("octree__of_skewed_clouds_takes_no_more_memory_and_answers_as_brute_force") {
  constexpr size_t kPoints = 100000;
  const auto make = [](const std::function<Vec3(size_t)>& at) {
    std::vector<double> xyz;
    for (size_t i = 0; i < kPoints; ++i) {
      const Vec3 p = at(i);
      xyz.insert(xyz.end(), {p.x, p.y, p.z});
    }
    return xyz;
  };
  // Processor seconds of this process, so that what else runs on the machine counts little; the best of three.
  const auto seconds = [&](const std::vector<double>& xyz) {
    double best = 1e9;
    for (int round = 0; round < 3; ++round) {
      const std::clock_t start = std::clock();
      const auto tree = build(xyz);
      best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      REQUIRE(tree->size() == kPoints);
    }
    return best;
  };
  RandomStream random(5, 0);
  const auto random_xyz = make([&](size_t) {
    return Vec3{random.uniform(), random.uniform(), random.uniform()} * 100.0;
  });
  auto outlier = random_xyz;
  outlier[0] = 1e7;
  const double fair = seconds(random_xyz);
  const std::pair<std::string, std::vector<double>> skewed[] = {
      {"all equal", make([](size_t) {
         return Vec3{1, 2, 3};
       })},
      {"one far outlier", outlier},
      {"exponential spacing", make([](size_t i) {
         return Vec3{1000, 700, 300} * std::exp(-4e-4 * static_cast<double>(i));
       })},
      {"collinear grid", make([](size_t i) {
         return Vec3{0.01 * static_cast<double>(i), 0, 0};
       })},
  };
  for (const auto& points : skewed) {
    const auto& name = points.first;
    const auto& xyz = points.second;
    const double t = seconds(xyz);
    MESSAGE("FIGURE octree of " << name << ": " << 1e3 * t << " ms, " << t / fair
                                << " times random points (" << 1e3 * fair << " ms)");
    CAPTURE(name);
    const auto tree = build(xyz);
    CHECK(tree->memory_bytes() <= 24 * tree->size());
    constexpr uint32_t kNear = 8;
    for (size_t i = 0; i < kPoints; i += kPoints / 25) {
      const Vec3 q = point(xyz, i) + Vec3{0.004, 0, 0} * static_cast<double>(i % 2);
      Neighbour found[kNear];
      REQUIRE(tree->knn(q, kNear, found) == kNear);
      const auto truth = brute_force(xyz, q, kNear);
      for (size_t j = 0; j < kNear; ++j) {
        CHECK(found[j].index == truth[j].index);
        CHECK(found[j].squared_distance == truth[j].squared_distance);
      }
    }
  }
}
