// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Solving pairs of targets: what is removed, what is refused and why, against blunders put in.

#include <doctest/doctest.h>

#include <string>

#include "base/error.h"
#include "registration/targets/solution.h"
#include "unit/registration/target_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const std::vector<Vec3> kAround{{8, 2, 0},  {-6, 7, 1.5}, {-9, -8, 0.5}, {5, -7, 3},
                                {1, 10, 4}, {10, -2, 2},  {-2, -3, 6}};

TargetSides around_a_station(uint64_t draw, double noise_m) {
  RandomStream random(191, draw);
  TargetSides out = exact_sides(kAround, any_motion(random));
  for (auto* side : {&out.reference, &out.moving})
    for (Target& target : *side)
      if (noise_m > 0) target.xyz += noise_of(isotropic(noise_m), random);
  return out;
}

std::vector<IndexPair> pairs_in_order(size_t n) {
  std::vector<IndexPair> out;
  for (size_t i = 0; i < n; ++i) out.push_back({i, i});
  return out;
}

TargetSolution solved_sides(const TargetSides& sides, size_t n, const TargetSettings& settings) {
  Task task;
  return solve_targets(
      {sides.reference, sides.moving, origin_of(sides.reference), origin_of(sides.moving)},
      pairs_in_order(n), settings, task);
}

std::string why_not(const std::vector<TargetPair>& pairs) {
  std::string why;
  return solve_pairs(pairs, {}, why) ? "" : why;
}

std::vector<TargetPair> pairs_at(const std::vector<Vec3>& reference,
                                 const std::vector<Vec3>& moving, double sigma_m = 0.003) {
  std::vector<TargetPair> out;
  for (size_t i = 0; i < moving.size(); ++i)
    out.push_back({reference[i], moving[i], isotropic(sigma_m), isotropic(sigma_m)});
  return out;
}

}  // namespace

TEST_CASE("solve_targets__removes_the_blunder_and_predicts_it_from_the_others") {
  for (uint64_t draw = 0; draw < 8; ++draw) {
    TargetSides sides = around_a_station(draw, 0.002);
    const size_t wrong = draw % 7;
    sides.reference[wrong].xyz += Vec3{0.2, -0.1, 0.2};  // 0.3 m, 70 standard deviations
    TargetSettings settings;
    settings.remove_outliers = true;
    const TargetSolution found = solved_sides(sides, 7, settings);
    REQUIRE(found.removed == 1);
    REQUIRE(found.pairs.size() == 7);
    CHECK(found.used.size() == 6);
    const TestedPair& last = found.pairs.back();
    CHECK(last.removed);
    CHECK(last.pair == IndexPair{wrong, wrong});
    CHECK(last.test.outlier);
    CHECK(norm(last.residual_m + Vec3{0.2, -0.1, 0.2}) < 0.02);
    for (size_t i = 0; i < 6; ++i) {
      CHECK_FALSE(found.pairs[i].removed);
      CHECK(found.pairs[i].pair.moving == (i < wrong ? i : i + 1));
    }
    settings.remove_outliers = false;
    CHECK(solved_sides(sides, 7, settings).removed == 0);
  }
}

TEST_CASE("solve_targets__never_goes_below_three_pairs") {
  TargetSides sides = around_a_station(9, 0.002);
  for (size_t i = 0; i < 7; i += 2)
    sides.reference[i].xyz += Vec3{1.0 + 2.0 * static_cast<double>(i), 1, 0};
  TargetSettings settings;
  settings.remove_outliers = true;
  CHECK(solved_sides(sides, 7, settings).used.size() >= 3);
  CHECK(solved_sides(sides, 3, settings).used.size() == 3);  // metres off, all three
  try {
    solved_sides(sides, 2, settings);
    FAIL("two pairs");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kInsufficientData);
    CHECK(std::string(error.what()).find("2 targets") != std::string::npos);
  }
}

TEST_CASE("solve_pairs__says_why_lines_and_mirrored_sets_give_no_pose") {
  RandomStream random(192, 0);
  const Transform truth = any_motion(random);
  const auto at = [&](std::vector<Vec3> places) {
    std::vector<Vec3> there;
    for (const Vec3& p : places) there.push_back(truth.point(p));
    return pairs_at(there, places);
  };
  CHECK(why_not(at(kAround)).empty());
  CHECK(why_not(at({{0, 0, 0}, {1, 2, 3}, {3, 6, 9}})).find("on one line: ") != std::string::npos);
  // A centimetre beside a line, known to 4 mm: the turn has 0.4 rad.
  const std::string nearly = why_not(at({{0, 0, 0}, {4, 0, 0}, {8, 0.01, 0}, {12, 0, 0}}));
  CHECK(nearly.find("standard deviation of a turn: 0.") != std::string::npos);
  std::vector<Vec3> mirrored;
  for (const Vec3& p : kAround) mirrored.push_back({p.x, p.y, -p.z});
  CHECK(why_not(pairs_at(mirrored, kAround)).find("mirror image") != std::string::npos);
  auto sure = at(kAround);
  sure[4].reference_covariance = sure[4].moving_covariance = {};
  std::string why;
  try {
    solve_pairs(sure, {}, why);
    FAIL("no weight");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kInvalidArgument);
    CHECK(std::string(error.what()).find("pair 4") != std::string::npos);
  }
}

TEST_CASE("placed__leads_between_the_coordinates_that_came") {
  RandomStream random(193, 0);
  const Transform local = any_motion(random, 1.5);
  const TargetSets sets{{}, {}, {652000, 6861000, 35}, {-1200, 300, 7}};
  const Transform pose = placed(local, sets);
  for (const Vec3& p : kAround) {
    const Vec3 expected = sets.reference_origin + local.point(p);
    CHECK(norm(pose.point(sets.moving_origin + p) - expected) < 4e-9);  // ulps of 7 million metres
  }
}
