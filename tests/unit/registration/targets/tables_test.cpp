// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Tables of registration by targets against the solution and the layout that they describe.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/targets/tables.h"
#include "unit/registration/target_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const std::vector<Vec3> kPlaces{{8, 2, 0},  {-6, 7, 1.5}, {-9, -8, 0.5},
                                {5, -7, 3}, {1, 10, 4},   {3, 3, 9}};
const Vec3 kGridOrigin{652000, 6861000, 120};

// Five of six targets on a national grid, the last left without a partner; one of them a blunder.
struct Described {
  TargetSides sides;
  TargetSets sets;
  TargetSolution solution;
  Registration result;

  explicit Described(const TargetSettings& settings, double blunder_m = 0) {
    RandomStream random(211, 0);
    sides = exact_sides(kPlaces, motion_about({}, {}, kGridOrigin) * any_motion(random));
    for (auto* side : {&sides.reference, &sides.moving})
      for (Target& target : *side) target.xyz += noise_of(isotropic(0.002), random);
    sides.moving[1].name.clear();
    sides.reference[2].xyz.z += blunder_m;
    sides.reference.resize(5);
    sets = {sides.reference, sides.moving, origin_of(sides.reference), origin_of(sides.moving)};
    Task task;
    solution = solve_targets(sets, {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}}, settings, task);
    describe_targets(sets, solution, settings, result);
  }
  double summary(const char* name) const { return result.summary.require(name).number(0); }
  double residual(const char* name, size_t row, uint32_t axis = 0) const {
    return result.residuals.require(name).number(row, axis);
  }
};

}  // namespace

TEST_CASE("describe_targets__is_in_the_callers_coordinates") {
  const Described d({});
  const Registration& r = d.result;
  double squares = 0;
  Vec3 mean;
  for (size_t i = 0; i < 5; ++i) {
    const Vec3 moved = r.pose.point(d.sides.moving[i].xyz);
    const Vec3 off = moved - d.sides.reference[i].xyz;
    squares += squared_norm(off);
    mean += (moved - kGridOrigin) / 5;
    for (int k = 0; k < 3; ++k)
      CHECK(std::abs(d.residual("residual", i, static_cast<uint32_t>(k)) - off[k]) < 4e-9);
  }
  CHECK(r.rms_m == doctest::Approx(std::sqrt(squares / 5)).scale(0).epsilon(1e-5));
  CHECK(norm(r.centre - kGridOrigin - mean) < 4e-9);  // ulps of 7 million metres
  double spread = 0;
  for (size_t i = 0; i < 5; ++i)
    spread += squared_norm(r.pose.point(d.sides.moving[i].xyz) - r.centre) / 5;
  CHECK(r.extent_m == doctest::Approx(std::sqrt(spread)).scale(0));
  CHECK(r.pairs == 5);
  CHECK(r.iterations == r.iteration_log.require("step").count());
}

TEST_CASE("describe_targets__names_pairs_and_counts_those_left_over") {
  const Described d({});
  CHECK(d.result.pair_names == std::vector<std::string>{"T0", "T1", "T2", "T3", "T4"});
  CHECK(d.summary("unpaired_reference") == 0);
  CHECK(d.summary("unpaired_moving") == 1);
  CHECK(d.summary("redundancy") == 9);
  CHECK(d.summary("removed") == 0);
  CHECK(d.summary("scale_sigma") == 0);
  CHECK(d.summary("global_accepted") == 1);
  CHECK(d.summary("sigma0_estimated") == 0);
  TargetSettings similarity;
  similarity.transform = TargetTransform::kSimilarity;
  const Described scaled(similarity);
  CHECK(scaled.summary("redundancy") == 8);
  // Of 5 targets of 3 mm on both sides: sigma sqrt(2 / (5 extent^2)).
  CHECK(
      scaled.summary("scale_sigma") ==
      doctest::Approx(0.003 * std::sqrt(2.0 / 5) / scaled.result.extent_m).scale(0).epsilon(1e-3));
}

TEST_CASE("describe_targets__an_estimated_sigma0_scales_covariance_and_sigmas") {
  TargetSettings estimated;
  estimated.snooping.sigma0 = UnitWeight::kEstimated;
  const Described known({}), scaled(estimated);
  const double sigma0 = known.summary("sigma0");
  CHECK(sigma0 ==
        doctest::Approx(std::sqrt(known.solution.adjustment.weighted_squares / 9)).scale(0));
  CHECK(scaled.summary("sigma0") == doctest::Approx(sigma0).scale(0));
  CHECK(scaled.summary("sigma0_estimated") == 1);
  for (size_t i = 0; i < 36; ++i)
    CHECK(scaled.result.covariance[i] ==
          doctest::Approx(sigma0 * sigma0 * known.result.covariance[i]).scale(1e-9).epsilon(1e-6));
  for (uint32_t axis = 0; axis < 3; ++axis)
    CHECK(scaled.residual("sigma", 3, axis) ==
          doctest::Approx(sigma0 * known.residual("sigma", 3, axis)).scale(0));
}

TEST_CASE("describe_targets__a_removed_blunder_stands_in_the_last_row") {
  TargetSettings settings;
  settings.remove_outliers = true;
  const Described d(settings, 0.5);
  CHECK(d.summary("removed") == 1);
  CHECK(d.result.pairs == 4);
  CHECK(d.result.pair_names.back() == "T2");
  CHECK(d.residual("moving", 4) == 2);
  CHECK(d.residual("removed", 4) == 1);
  CHECK(d.residual("outlier", 4) == 1);
  CHECK(d.residual("removed", 0) == 0);
  CHECK(d.residual("residual", 4, 2) == doctest::Approx(-0.5).epsilon(0.05).scale(0));
}
