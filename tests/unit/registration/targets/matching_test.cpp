// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "base/error.h"
#include "registration/maximum_cliques.h"
#include "unit/registration/target_scenes.h"

namespace jalon {
namespace {

using namespace test;

constexpr const char* kSimilarity = R"({"transform": "similarity"})";

std::vector<Vec3> random_places(size_t n, RandomStream& random) {
  std::vector<Vec3> out;
  while (out.size() < n) out.push_back(within(15, random));
  return out;
}

TargetSides noisy(const std::vector<Vec3>& places, const Transform& truth, bool named,
                  RandomStream& random) {
  TargetSides out = exact_sides(places, truth, named);
  for (auto* side : {&out.reference, &out.moving})
    for (Target& target : *side)
      target.xyz += 0.003 * Vec3{random.normal(), random.normal(), random.normal()};
  return out;
}

void shuffle(std::vector<Target>& targets, RandomStream& random) {
  for (size_t i = targets.size(); i > 1; --i) std::swap(targets[i - 1], targets[random.below(i)]);
}

double solutions(const Registration& r) { return r.summary.require("solutions").number(0); }

Status refused(const TargetSides& sides, const char* json = "{}") {
  try {
    registered(sides, json);
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

}  // namespace

TEST_CASE("matching__finds_unnamed_targets_by_their_distances") {
  for (const char* json : {"{}", kSimilarity}) {
    int right = 0;
    constexpr int kDraws = 40;
    for (uint64_t draw = 0; draw < kDraws; ++draw) {
      RandomStream random(31, draw);
      const double scale = std::string(json) == "{}" ? 1 : 0.1 + 5 * random.uniform();
      const Transform truth = any_motion(random, scale);
      TargetSides sides = noisy(random_places(8, random), truth, false, random);
      sides.reference.resize(6);  // five in common: 1 to 5
      sides.moving.erase(sides.moving.begin());
      shuffle(sides.reference, random);
      shuffle(sides.moving, random);
      const Registration r = registered(sides, json);
      const Coefficients<6> e = pose_error(r, truth);
      const double limit = std::string(json) == "{}" ? 0.02 : 0.05;
      right += r.converged && r.pairs >= 5 && norm({e[3], e[4], e[5]}) < limit && solutions(r) == 1;
    }
    CHECK(right == kDraws);
  }
}

TEST_CASE("matching__pairs_a_scan_without_names_with_named_control_points") {
  RandomStream random(32, 0);
  const Transform truth = any_motion(random);
  TargetSides sides = noisy(random_places(6, random), truth, true, random);
  for (size_t i = 2; i < 6; ++i) sides.moving[i].name.clear();
  shuffle(sides.moving, random);
  const Registration r = registered(sides);
  CHECK(r.converged);
  CHECK(r.pairs == 6);
  for (size_t i = 0; i < 6; ++i)
    CHECK(r.pair_names[i] ==
          sides.reference[static_cast<size_t>(r.residuals.require("reference").number(i))].name);
}

TEST_CASE("matching__of_a_square_says_that_it_is_ambiguous") {
  RandomStream random(33, 0);
  const Transform truth = any_motion(random);
  const std::vector<Vec3> square = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  for (const char* json : {"{}", kSimilarity}) {
    const Registration r = registered(noisy(square, truth, false, random), json);
    CHECK(!r.converged);
    CHECK(r.stopped == StopReason::kAmbiguous);
    CHECK(solutions(r) == 8);  // four turns, and the same upside down
  }
  CHECK(registered(noisy(square, truth, true, random)).converged);
  // A fifth target off the symmetry settles it; so does one name more than a symmetry keeps.
  std::vector<Vec3> five = square;
  five.push_back({3, 1, 2});
  CHECK(registered(noisy(five, truth, false, random)).converged);
  TargetSides sides = noisy(square, truth, true, random);
  sides.moving[2].name.clear();
  CHECK(registered(sides).converged);
}

TEST_CASE("matching__of_a_cube_counts_its_turns_and_of_a_grid_ends") {
  RandomStream random(34, 0);
  std::vector<Vec3> cube, grid;
  for (int i = 0; i < 8; ++i) cube.push_back({4.0 * (i & 1), 4.0 * (i >> 1 & 1), 4.0 * (i >> 2)});
  for (int i = 0; i < 36; ++i) grid.push_back({2.0 * (i % 6), 2.0 * (i / 6), 0});
  CHECK(solutions(registered(noisy(cube, any_motion(random), false, random))) == 24);
  CHECK(solutions(registered(noisy(grid, any_motion(random), false, random))) >= 2);
}

TEST_CASE("matching__refuses_mirrored_and_unrelated_sets") {
  RandomStream random(35, 0);
  const auto anywhere = [&](size_t count) {
    const std::vector<Vec3> places = random_places(count, random);
    return noisy(places, any_motion(random), false, random);
  };
  TargetSides sides = anywhere(6);
  for (Target& target : sides.moving) target.xyz.y *= -1;
  CHECK(refused(sides) == Status::kDegenerate);
  const TargetSides other = anywhere(5);
  sides.moving = other.moving;
  CHECK(refused(sides) == Status::kInsufficientData);
  TargetSides many = anywhere(150);
  CHECK(refused(many) == Status::kLimit);
}

TEST_CASE("maximum_cliques__equal_those_of_every_subset") {
  for (uint64_t draw = 0; draw < 60; ++draw) {
    RandomStream random(36, draw);
    const size_t n = 4 + draw % 9;
    PairGraph graph(n);
    std::vector<uint32_t> rows(n);
    for (size_t i = 0; i < n; ++i)
      for (size_t j = 0; j < i; ++j)
        if (random.uniform() < 0.6) {
          graph.join(i, j);
          rows[i] |= 1u << j;
          rows[j] |= 1u << i;
        }
    std::set<std::vector<size_t>> expected;
    size_t largest = 0;
    for (uint32_t set = 1; set < 1u << n; ++set) {
      std::vector<size_t> nodes;
      bool clique = true;
      for (size_t i = 0; i < n; ++i)
        if (set >> i & 1) {
          nodes.push_back(i);
          clique = clique && (set & ~rows[i]) == 1u << i;
        }
      if (!clique || nodes.size() < largest) continue;
      if (nodes.size() > largest) expected.clear();
      largest = nodes.size();
      expected.insert(nodes);
    }
    Task task;
    const Cliques found = maximum_cliques(graph, {(uint64_t{1} << n) - 1}, 1, 1000, task);
    CHECK(found.complete);
    CHECK(std::set<std::vector<size_t>>(found.all.begin(), found.all.end()) == expected);
  }
}

}  // namespace jalon
