// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/snooping.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "base/distributions.h"
#include "unit/registration/target_scenes.h"

namespace jalon {
namespace {

using namespace test;

constexpr int kPairs = 6;
int draws() { return std::getenv("JALON_SANITIZED") != nullptr ? 200 : 4000; }

Layout site() {
  Layout out{"site",
             {{8, 2, 0}, {-6, 7, 1.5}, {-9, -8, 0.5}, {5, -7, 3}, {1, 10, 4}, {10, -2, 2}},
             {},
             {}};
  for (size_t i = 0; i < kPairs; ++i) {
    out.reference.push_back(isotropic(i < 3 ? 0.002 : 0.004));
    out.moving.push_back(along_ray(out.places[i], 0.003, 0.001));
  }
  return out;
}

// Within four standard deviations of a count: a chance of 1 in 16000 to fail by accident.
void check_share(double found, double expected, double n) {
  CHECK(std::fabs(found - expected) <= 4 * std::sqrt(expected * (1 - expected) / n) + 1 / n);
}

void false_alarms(const char* params, const std::string& name) {
  const Layout layout = site();
  double alarms = 0, rejected = 0, squares = 0;
  for (int draw = 0; draw < draws(); ++draw) {
    RandomStream random(5, static_cast<uint64_t>(draw));
    const Registration r = registered(measured_sides(layout, any_motion(random), random), params);
    alarms += r.residuals.require("outlier").number(2);
    for (uint32_t axis = 0; axis < 3; ++axis)
      squares += std::pow(r.residuals.require("normalised").number(2, axis), 2) / 3;
    rejected += 1 - r.summary.require("global_accepted").number(0);
  }
  MESSAGE("FIGURE snooping false alarms, " << name << ": " << 100 * alarms / draws()
                                           << " % of 5 %");
  check_share(alarms / draws(), 0.05, draws());
  check_share(rejected / draws(), 0.05, draws());
  // Standard normal, or of Pope's tau: mean square 1, of a draw with a variance of 2 or less.
  CHECK(std::fabs(squares / draws() - 1) < 4 * std::sqrt(2.0 / draws()));
}

// A blunder of the detectable size along each axis of target 2 is found with the power that was asked for.
void power(const char* params, const std::string& name, double scatter) {
  const Layout layout = site();
  for (int axis = 0; axis < 3; ++axis) {
    RandomStream first(6, 0);
    const Transform truth = any_motion(first);
    const Registration known =
        registered(measured_sides(layout, truth, first), R"({"significance": 0.01})");
    double found = 0,
           size_m = known.residuals.require("detectable").number(2, static_cast<uint32_t>(axis));
    size_m *= scatter;
    for (int draw = 0; draw < draws(); ++draw) {
      RandomStream random(7, static_cast<uint64_t>(draw));
      TargetSides sides = measured_sides(layout, truth, random);
      sides.reference[2].xyz[axis] += size_m;
      found += registered(sides, params).residuals.require("outlier").number(2);
    }
    MESSAGE("FIGURE snooping power, " << name << ": " << 100 * found / draws() << " % of 80 % ("
                                      << 1000 * size_m << " mm)");
    check_share(found / draws(), 0.8, draws());
  }
}

}  // namespace

TEST_CASE("snooping__calls_good_targets_outliers_as_often_as_the_significance_says") {
  false_alarms(R"({"significance": 0.05})", "known sigma0");
  false_alarms(R"({"significance": 0.05, "sigma0": "estimated"})", "estimated sigma0");
}

TEST_CASE("snooping__finds_detectable_blunders_with_the_stated_power") {
  power(R"({"significance": 0.01})", "known sigma0", 1);
  // The share of squares needs a larger blunder: the ratio of the noncentralities of both tests.
  const Snooping known({UnitWeight::kKnown, 0.01, 0.8}, 12, 12),
      estimated({UnitWeight::kEstimated, 0.01, 0.8}, 12, 12);
  power(R"({"significance": 0.01, "sigma0": "estimated"})", "estimated sigma0",
        std::sqrt(estimated.noncentrality(3) / known.noncentrality(3)));
}

TEST_CASE("snooping__has_the_noncentralities_of_the_literature") {
  // Baarda 1968: 4.13 for alpha = 0.001 and beta = 0.80; Teunissen 2006 for more dimensions.
  const Snooping snooping({UnitWeight::kKnown, 0.001, 0.8}, 1, 12);
  CHECK(std::sqrt(snooping.noncentrality(1)) == doctest::Approx(4.1321).epsilon(1e-4));
  CHECK(snooping.noncentrality(1) == doctest::Approx(17.075).epsilon(1e-4));
  CHECK(snooping.noncentrality(3) > snooping.noncentrality(2));
  CHECK(std::isinf(Snooping({UnitWeight::kEstimated, 0.001, 0.8}, 1, 3).noncentrality(3)));
}

TEST_CASE("snooping__of_one_dimension_is_popes_tau_test") {
  // tau^2 = f t^2 / (f - 1 + t^2) with Student's t of f - 1 degrees of freedom (Pope 1976).
  for (const int f : {3, 7, 20})
    for (const double alpha : {0.05, 0.001}) {
      const double t = student_quantile(f - 1, 1 - alpha / 2), tau2 = f * t * t / (f - 1 + t * t);
      CHECK(beta_tail(0.5, (f - 1) / 2.0, tau2 / f) ==
            doctest::Approx(alpha).scale(0).epsilon(1e-9));
    }
}

TEST_CASE("snooping__redundancies_sum_up_and_three_targets_leave_their_normal_uncontrolled") {
  RandomStream random(9, 0);
  Layout layout = site();
  Registration r = registered(measured_sides(layout, any_motion(random), random));
  double sum = 0;
  for (size_t i = 0; i < kPairs; ++i)
    for (uint32_t k = 0; k < 3; ++k) sum += r.residuals.require("redundancy").number(i, k);
  CHECK(sum == doctest::Approx(12));
  CHECK(r.summary.require("redundancy").number(0) == 12);

  // Level targets and a turn about the vertical: heights of three targets control nothing.
  layout.places = {{8, 2, 0}, {-6, 7, 0}, {-9, -8, 0}};
  for (auto* side : {&layout.reference, &layout.moving}) side->assign(3, isotropic(0.002));
  r = registered(measured_sides(layout, motion_about({}, {0, 0, 1}, {5, 5, 5}), random));
  for (size_t i = 0; i < 3; ++i) {
    CHECK(std::fabs(r.residuals.require("redundancy").number(i, 2)) < 1e-5);
    CHECK(r.residuals.require("detectable").number(i, 2) >
          1);  // metres, where the others are millimetres
    CHECK(r.residuals.require("detectable").number(i, 0) < 0.1);
  }
}

TEST_CASE("snooping__removes_two_blunders_and_names_them") {
  RandomStream random(10, 0);
  const Layout layout = site();
  const Transform truth = any_motion(random);
  TargetSides sides = measured_sides(layout, truth, random);
  sides.reference[1].xyz.y += 0.08;
  sides.moving[4].xyz.x -= 0.05;
  const Registration r = registered(sides, R"({"remove_outliers": true})");
  CHECK(r.summary.require("removed").number(0) == 2);
  CHECK(r.summary.require("global_accepted").number(0) == 1);
  CHECK(r.pairs == 4);
  const Column &removed = r.residuals.require("removed"), &at = r.residuals.require("reference");
  REQUIRE(removed.count() == 6);
  for (size_t i = 0; i < 6; ++i) {
    const bool wrong = at.number(i) == 1 || at.number(i) == 4;
    CHECK((removed.number(i) == 1) == wrong);
    CHECK((r.residuals.require("outlier").number(i) == 1) == wrong);
  }
  CHECK(squared_length<6>(r.covariance, pose_error(r, truth)) < chi_square_quantile(6, 0.999));
  // Kept in, they spoil the fit, and the result says so.
  const Registration kept = registered(sides);
  CHECK(kept.summary.require("global_accepted").number(0) == 0);
  CHECK(kept.summary.require("removed").number(0) == 0);
}

TEST_CASE("snooping__leaves_three_targets_whatever_their_residuals") {
  RandomStream random(12, 0);
  std::vector<Vec3> places = {{8, 2, 0}, {-6, 7, 1.5}, {-9, -8, 0.5}, {5, -7, 3}, {1, 10, 4}};
  TargetSides sides = exact_sides(places, any_motion(random));
  for (Target& target : sides.reference) target.xyz += within(0.3, random);
  const Registration r = registered(sides, R"({"remove_outliers": true})");
  CHECK(r.pairs >= 3);
  CHECK(r.pairs + static_cast<uint64_t>(r.summary.require("removed").number(0)) == 5);
}

}  // namespace jalon
