// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Scores of groups of pairs, summed by hand for groups that are a metre each.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/icp/influence.h"
#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Two pairs of points near the middle of each metre along x.
struct Groups {
  Cloud reference, moving;
  IcpClouds clouds;
  IcpNeighbours neighbours;
  Transform T_reference_moving;
  IcpLevel all;
  PairRule rule{IcpMetric::kPointToPoint, 1, 0, 0, 16};
  IcpFrame frame{{2, 1, 3}, 2.5};

  Groups(const std::vector<Vec3>& r, const std::vector<Vec3>& m, bool both_ways)
      : reference(cloud_of(r)), moving(cloud_of(m)) {
    const auto up = [](const Vec3&) { return Vec3{0, 0, 1}; };
    clouds = {planes_by_hand(reference, up), planes_by_hand(moving, up)};
    clouds.reference.radius_m = clouds.moving.radius_m = 0.125;  // groups have an edge of 8 radii
    T_reference_moving = clouds.to_local({});
    std::vector<uint32_t> forth, back;
    for (const uint32_t i : clouds.moving.tree->order())
      forth.push_back(position_in(*clouds.reference.tree, i));
    for (const uint32_t i : clouds.reference.tree->order())
      back.push_back(both_ways ? position_in(*clouds.moving.tree, i) : kNoPoint);
    neighbours = {positions_of(forth), positions_of(back)};
  }
  Square<6> scores() const {
    return icp_scores({clouds, all, neighbours, rule, T_reference_moving}, frame);
  }
};

struct Pairs {
  std::vector<Vec3> reference, moving;
};

Pairs pairs_of(int groups, bool opposite, RandomStream& random) {
  Pairs out;
  for (int g = 0; g < groups; ++g) {
    const Vec3 middle{g + 0.5, 0.5, 0.5};
    const Vec3 off{0.1 * random.uniform(), 0.1 * random.uniform(), 0.1 * random.uniform()};
    for (const double side : {-1.0, 1.0}) {
      out.reference.push_back(middle + Vec3{0, 0.1 * side, 0});
      out.moving.push_back(out.reference.back() + off * (opposite ? side : 1));
    }
  }
  return out;
}

// Sum of s s^T, s = sum of (arm x offset, offset) of the pairs of a group.
Square<6> by_hand(const Pairs& pairs, const Groups& groups) {
  Square<6> out{};
  const Vec3 origin = groups.clouds.reference.tree->cube().origin;
  for (size_t g = 0; g < pairs.reference.size(); g += 2) {
    double s[6] = {};
    for (size_t i = g; i < g + 2; ++i) {
      const Vec3 off = pairs.moving[i] - pairs.reference[i];
      const Vec3 arm = (pairs.moving[i] - origin - groups.frame.centre) / groups.frame.extent_m;
      for (int k = 0; k < 3; ++k) s[k] += cross(arm, off)[k], s[k + 3] += off[k];
    }
    for (size_t r = 0; r < 6; ++r)
      for (size_t c = 0; c < 6; ++c) out[6 * r + c] += s[r] * s[c];
  }
  return out;
}

void check_scores(const Square<6>& found, const Square<6>& expected, double factor) {
  for (size_t i = 0; i < 36; ++i)
    CHECK(std::abs(found[i] - factor * expected[i]) < 1e-6);  // places lie on the trees' grids
}

}  // namespace

TEST_CASE("icp_scores__pairs_of_a_group_count_together_and_groups_apart") {
  RandomStream random(81, 0);
  const Pairs pairs = pairs_of(3, false, random);
  const Groups one_way(pairs.reference, pairs.moving, false);
  check_scores(one_way.scores(), by_hand(pairs, one_way), 1);
  // Each pair found from both sides counts twice, so its square four times.
  const Groups both(pairs.reference, pairs.moving, true);
  check_scores(both.scores(), by_hand(pairs, both), 4);
}

TEST_CASE("icp_scores__offsets_that_cancel_in_a_group_say_nothing_of_a_shift") {
  RandomStream random(82, 0);
  const Pairs pairs = pairs_of(3, true, random);
  const Groups groups(pairs.reference, pairs.moving, false);
  const Square<6> found = groups.scores();
  for (const size_t shift : {3u, 4u, 5u}) CHECK(std::abs(found[7 * shift]) < 1e-12);
  CHECK(found[0] + found[7] + found[14] > 1e-6);
}

TEST_CASE("icp_scores__more_groups_than_unknowns_are_corrected_for_these") {
  RandomStream random(83, 0);
  const Pairs pairs = pairs_of(8, false, random);
  Groups groups(pairs.reference, pairs.moving, false);
  check_scores(groups.scores(), by_hand(pairs, groups), 8.0 / (8 - 6));
  groups.rule.most_m = 0.001;  // none of them is a pair
  CHECK(groups.scores() == Square<6>{});
}
