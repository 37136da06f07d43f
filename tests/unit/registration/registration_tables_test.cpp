// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/registration_tables.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace jalon;

namespace {

Square<6> diagonal(const Coefficients<6>& values) {
  Square<6> out{};
  for (size_t i = 0; i < 6; ++i) out[7 * i] = values[i];
  return out;
}

}  // namespace

TEST_CASE("pose_directions__are_the_weakest_first_with_turns_as_lengths") {
  // Turns of 1, 2, 3 mrad count 10, 20, 30 mm at an extent of 10 m; shifts are 5, 15, 25 mm.
  const auto directions = pose_directions(diagonal({1e-6, 4e-6, 9e-6, 25e-6, 225e-6, 625e-6}), 10);
  const double sigmas[] = {0.030, 0.025, 0.020, 0.015, 0.010, 0.005};
  const size_t unknowns[] = {2, 5, 1, 4, 0, 3};
  for (size_t k = 0; k < 6; ++k) {
    CHECK(directions[k].sigma_m == doctest::Approx(sigmas[k]).scale(0));
    CHECK(std::abs(directions[k].unit[unknowns[k]]) == doctest::Approx(1));
    CHECK(directions[k].observable);
  }
}

TEST_CASE("pose_directions__make_up_the_covariance_again") {
  Square<6> covariance{};  // a sum of outer products, positive definite
  for (size_t n = 0; n < 9; ++n)
    for (size_t i = 0; i < 6; ++i)
      for (size_t k = 0; k < 6; ++k) {
        const auto at = [n](size_t c) { return std::sin(static_cast<double>(3 * n + 2 * c * c)); };
        covariance[6 * i + k] += at(i) * at(k);
      }
  const double extent_m = 4;
  const auto length = [&](size_t i) { return i < 3 ? extent_m : 1.0; };
  Square<6> sum{};
  for (const PoseDirection& d : pose_directions(covariance, extent_m))
    for (size_t i = 0; i < 6; ++i)
      for (size_t k = 0; k < 6; ++k)
        sum[6 * i + k] += d.sigma_m * d.sigma_m * d.unit[i] * d.unit[k] / (length(i) * length(k));
  for (size_t i = 0; i < 36; ++i)
    CHECK(sum[i] == doctest::Approx(covariance[i]).scale(0).epsilon(1e-9));
}

TEST_CASE("fill_tables__counts_open_directions_and_puts_own_columns_behind_the_common_ones") {
  Registration r;
  r.extent_m = 2;
  r.pairs = 17;
  r.centre = {1, 2, 3};
  r.summary.set(make_column<double>({.name = "own"}, std::vector<double>{5}));
  std::array<PoseDirection, 6> directions;
  for (size_t k = 0; k < 6; ++k) directions[k].unit[k] = 1;
  directions[0].observable = directions[3].observable = false;
  fill_tables(r, directions);
  CHECK(r.unobservable == 2);
  CHECK(r.summary.require("unobservable").number(0) == 2);
  CHECK(r.summary.require("pairs").number(0) == 17);
  CHECK(r.summary.require("centre").number(0, 2) == 3);
  CHECK(r.summary.at(r.summary.size() - 1)->info().name == "own");
  const Column& direction = r.directions.require("direction");
  CHECK(direction.number(1, 1) == 0.5);  // rad for each metre
  CHECK(direction.number(4, 4) == 1);
  CHECK(r.directions.require("observable").number(3) == 0);
  CHECK(r.directions.require("observable").number(4) == 1);
}

TEST_CASE("fill_judgement__sets_the_verdict_and_its_reasons_a_line_each") {
  Registration r;
  fill_judgement(r, {Verdict::kDoubtful, 0.5, "first\nsecond"});
  CHECK(r.summary.require("verdict").values<uint8_t>()[0] == 2);
  CHECK(r.summary.require("confidence").values<double>()[0] == 0.5);
  CHECK(r.judgement.reasons == "first\nsecond");
  fill_judgement(r, {Verdict::kAccepted, 0.99, ""});
  CHECK(r.summary.require("verdict").values<uint8_t>()[0] == 1);
  CHECK(r.judgement.reasons.empty());
}

TEST_CASE("judgement_of_search__refuses_what_was_not_found_and_judges_no_start") {
  CHECK(judgement_of_search(StopReason::kConverged).verdict == Verdict::kNone);
  CHECK(judgement_of_search(StopReason::kAmbiguous).verdict == Verdict::kDoubtful);
  CHECK(judgement_of_search(StopReason::kIterationLimit).verdict == Verdict::kDoubtful);
  CHECK(judgement_of_search(StopReason::kTooFewPairs).verdict == Verdict::kRefused);
  CHECK(judgement_of_search(StopReason::kNothingFound).verdict == Verdict::kRefused);
  CHECK(!judgement_of_search(StopReason::kAmbiguous).reasons.empty());
}
