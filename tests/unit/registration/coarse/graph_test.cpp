// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/graph.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "unit/registration/coarse_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr uint32_t kRight = 12;

/// Right matches 0 ... 11 between a surface and its moved copy, and twelve wrong ones behind them.
struct Matched {
  CoarseSurface reference, moving;
  std::vector<FeatureMatch> matches;

  Matched() {
    const Transform T_reference_moving = random_start(3, true);
    RandomStream random(12, 0);
    moving.points = random_points(kRight, 20, 5);
    for (size_t i = 0; i < kRight; ++i) {
      const double x = random.normal(), y = random.normal(), z = random.normal();
      moving.normals.push_back(normalized(Vec3{x, y, z}));
      reference.points.push_back(T_reference_moving.point(moving.points[i]));
      reference.normals.push_back(T_reference_moving.direction(moving.normals[i]) *
                                  (i % 2 ? 1.0 : -1.0));
    }
    for (uint32_t i = 0; i < kRight; ++i) matches.push_back({i, i, 0});
    for (uint32_t i = 0; i < kRight; ++i) matches.push_back({i, (i * 5 + 3) % kRight, 1});
  }
  double off(size_t a, size_t b) const {
    return std::abs(
        norm(moving.points[matches[a].moving] - moving.points[matches[b].moving]) -
        norm(reference.points[matches[a].reference] - reference.points[matches[b].reference]));
  }
};

}  // namespace

TEST_CASE("match_graph__the_right_matches_are_a_clique_whatever_the_signs_of_normals") {
  const Matched m;
  Task task;
  const MatchGraph graph(m.matches, m.reference, m.moving, 0.01, 0.01, task);
  REQUIRE(graph.size() == 2 * kRight);
  for (size_t i = 0; i < kRight; ++i) CHECK(graph.degree(i) >= kRight - 1);
  const auto cliques = graph.cliques(10, 4, task);
  REQUIRE_FALSE(cliques.empty());
  std::vector<uint32_t> best = cliques[0];
  std::sort(best.begin(), best.end());
  for (uint32_t i = 0; i < kRight; ++i) CHECK(std::binary_search(best.begin(), best.end(), i));
}

TEST_CASE("match_graph__cliques_begin_with_their_seed_and_keep_all_distances") {
  const Matched m;
  Task task;
  const double tolerance_m = 1.5;
  const MatchGraph graph(m.matches, m.reference, m.moving, tolerance_m, 0.5, task);
  for (size_t seed = 0; seed < graph.size(); ++seed) {
    const auto clique = graph.clique(seed);
    REQUIRE(clique[0] == seed);
    CHECK(clique.size() <= graph.degree(seed) + 1);
    for (size_t a = 0; a < clique.size(); ++a)
      for (size_t b = 0; b < a; ++b) REQUIRE(m.off(clique[a], clique[b]) <= tolerance_m);
  }
}

TEST_CASE("match_graph__pairs_nearer_than_the_least_and_few_in_common_are_left_out") {
  const Matched m;
  Task task;
  const MatchGraph none(m.matches, m.reference, m.moving, 0.01, 1000, task);
  for (size_t i = 0; i < none.size(); ++i) CHECK(none.degree(i) == 0);
  CHECK(none.cliques(10, 1, task).empty());
  const MatchGraph graph(m.matches, m.reference, m.moving, 0.01, 0.01, task);
  CHECK(graph.cliques(10, 2 * kRight + 1, task).empty());
  CHECK(MatchGraph({}, m.reference, m.moving, 1, 1, task).cliques(5, 1, task).empty());
}
