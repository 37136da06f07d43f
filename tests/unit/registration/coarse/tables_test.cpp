// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Tables of coarse registration against the search that they describe.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/coarse/tables.h"

using namespace jalon;

namespace {

RankedPose ranked(double count, double likeness, PoseSource source) {
  RankedPose out;
  out.source = source;
  out.overlap.count = count;
  out.overlap.likeness = likeness;
  out.overlap.of_moving = 0.7;
  out.overlap.of_reference = 0.4;
  out.overlap.pairs = 321;
  out.overlap.rms_m = 0.012;
  return out;
}

// Normal equations without products of different unknowns: turns (m2), then shifts.
Square<6> holding(const Coefficients<6>& diagonal) {
  Square<6> out{};
  for (size_t i = 0; i < 6; ++i) out[7 * i] = diagonal[i];
  return out;
}

double summary_of(const Registration& r, const char* name) {
  return r.summary.require(name).number(0);
}

}  // namespace

TEST_CASE("fill_coarse_tables__show_the_best_pose_and_the_score_of_the_second") {
  CoarseSearch found;
  found.poses = {ranked(0.5, 0.8, PoseSource::kPlanes), ranked(0.4, 0.5, PoseSource::kSlide)};
  found.poses[1].T_reference_moving.m[3] = 17;
  found.fixed = holding({1, 1, 1, 1, 1, 1});
  Registration r;
  r.stopped = StopReason::kAmbiguous;
  fill_coarse_tables(r, found, 0.25, 77);
  CHECK(r.pairs == 321);
  CHECK(r.rms_m == 0.012);
  CHECK(summary_of(r, "score") == doctest::Approx(0.4));
  CHECK(summary_of(r, "second_score") == doctest::Approx(0.2).scale(0));
  CHECK(summary_of(r, "overlap_moving") == 0.7);
  CHECK(summary_of(r, "overlap_reference") == 0.4);
  CHECK(summary_of(r, "ambiguous") == 1);
  CHECK(summary_of(r, "cell") == 0.25);
  CHECK(summary_of(r, "candidates") == 77);
  CHECK(r.iteration_log.require("score").count() == 2);
  CHECK(r.iteration_log.require("source").number(0) == 2);
  CHECK(r.iteration_log.require("source").number(1) == 3);
  CHECK(r.iteration_log.require("pose").number(1, 3) == 17);
  CHECK(r.iteration_log.require("pose").number(0, 5) == 1);
  for (const double c : r.covariance) CHECK(std::isnan(c));
}

TEST_CASE("fill_coarse_tables__call_open_what_has_less_than_a_twentieth_of_the_mean_stiffness") {
  CoarseSearch found;
  found.poses = {ranked(1, 1, PoseSource::kFeatures)};
  Registration r;
  r.extent_m = 4;
  // With turns over 4 m: 100 each, and shifts along x and z of 2 and 30: of a mean of 72 a twentieth is 3.6.
  found.fixed = holding({1600, 1600, 1600, 2, 100, 30});
  fill_coarse_tables(r, found, 0.1, 1);
  CHECK(r.unobservable == 1);
  const Column& direction = r.directions.require("direction");
  CHECK(std::abs(direction.number(0, 3)) == doctest::Approx(1));
  CHECK(std::abs(direction.number(1, 5)) == doctest::Approx(1));
  CHECK(r.directions.require("observable").number(0) == 0);
  CHECK(r.directions.require("observable").number(1) == 1);
  for (size_t k = 0; k < 6; ++k) CHECK(std::isnan(r.directions.require("sigma").number(k)));
}

TEST_CASE("fill_coarse_tables__of_nothing_found_are_zeros_and_no_rows") {
  Registration r;
  fill_coarse_tables(r, {}, 0.1, 5);
  CHECK(summary_of(r, "score") == 0);
  CHECK(summary_of(r, "second_score") == 0);
  CHECK(summary_of(r, "ambiguous") == 0);
  CHECK(r.iteration_log.require("pose").count() == 0);
  CHECK(r.unobservable == 6);
}
