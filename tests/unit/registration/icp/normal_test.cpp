// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Normal equations against differences of the sum of squares, directions against matrices made by hand.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/icp/normal.h"
#include "unit/registration/icp_problems.h"
#include "unit/registration/registration_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Pairs of a room and its sample a little off, that stay pairs.
struct PairsOfRoom {
  IcpProblem problem;
  Transform T_reference_moving;
  IcpLevel all;
  PairRule rule{IcpMetric::kPointToPlane, 10, 10, 0, 16};
  IcpNeighbours neighbours;

  PairsOfRoom() {
    const Transform off = motion_about({3, 2, 1}, {0.004, 0.003, -0.005}, {0.02, -0.01, 0.03});
    problem = problem_between(scenes::sampled(scenes::room(), 1, {}, 700),
                              scenes::sampled(scenes::room(), 2, off, 600));
    T_reference_moving = problem.clouds.to_local({});
    Task task;
    neighbours = IcpSearch(problem.clouds, all, 0.5, task).find(T_reference_moving, 0.5, task);
  }
  IcpPairing at(const Transform& T) const { return {problem.clouds, all, neighbours, rule, T}; }
  IcpSums sums(const Transform& T, const RobustKernel& kernel = {KernelKind::kNone, 1}) const {
    Task task;
    return icp_sums(at(T), kernel, problem.frame(T_reference_moving), task);
  }
  double squares_after(size_t unknown, double length_m) const {
    const IcpFrame frame = problem.frame(T_reference_moving);
    Vec3 turn, shift;
    if (unknown < 3) turn[static_cast<int>(unknown)] = length_m / frame.extent_m;
    else shift[static_cast<int>(unknown) - 3] = length_m;
    return sums(motion_about(frame.centre, turn, shift) * T_reference_moving).squares;
  }
};

Square<6> diagonal_of(const Coefficients<6>& values) {
  Square<6> out{};
  for (size_t i = 0; i < 6; ++i) out[7 * i] = values[i];
  return out;
}

}  // namespace

TEST_CASE("icp_sums__are_the_slope_and_the_bend_of_the_squares") {
  PairsOfRoom room;
  constexpr double kStep_m = 1e-4;
  for (const bool both_ways : {true, false}) {
    if (!both_ways)
      for (uint32_t& p : room.neighbours.of_reference) p = kNoPoint;
    const IcpSums sums = room.sums(room.T_reference_moving);
    CHECK((sums.of_moving == sums.pairs) == !both_ways);
    // Planes of the moving cloud turn with it, which the equations leave out: turns are told forth alone.
    for (size_t k = both_ways ? 3 : 0; k < 6; ++k) {
      const double above = room.squares_after(k, kStep_m), below = room.squares_after(k, -kStep_m);
      const double slope = (above - below) / (2 * kStep_m);
      // Third derivatives of a turn: squares of the step; else rounding of the difference.
      CHECK(-2 * sums.right[k] == doctest::Approx(slope).scale(0.1).epsilon(1e-5));
      if (k < 3) continue;
      const double bend = (above + below - 2 * sums.squares) / (kStep_m * kStep_m);
      CHECK(2 * sums.normal[7 * k] == doctest::Approx(bend).scale(0).epsilon(1e-5));
    }
    for (size_t r = 0; r < 6; ++r)
      for (size_t c = 0; c < r; ++c) CHECK(sums.normal[6 * r + c] == sums.normal[6 * c + r]);
  }
}

TEST_CASE("icp_sums__count_the_pairs_that_the_kernel_hears") {
  const PairsOfRoom room;
  const std::vector<float> residuals = icp_residual_sample(room.at(room.T_reference_moving));
  const IcpSums all = room.sums(room.T_reference_moving);
  CHECK(all.pairs == residuals.size());
  CHECK(all.weights == static_cast<double>(all.pairs));
  const RobustKernel tukey{KernelKind::kTukey, 0.005};
  const IcpSums heard = room.sums(room.T_reference_moving, tukey);
  double squares = 0, heard_pairs = 0;
  for (const float r : residuals) {
    squares += double{r} * double{r};
    heard_pairs += std::abs(r) < 4.685 * 0.005;
  }
  CHECK(all.squares == doctest::Approx(squares).scale(0).epsilon(1e-6));  // the sample is of floats
  CHECK(static_cast<double>(heard.pairs) == heard_pairs);
  CHECK(heard.pairs < all.pairs);
  CHECK(heard.of_moving > heard.pairs / 3);  // about half of them come from either side
  IcpSums twice = heard;
  twice += heard;
  CHECK(twice.pairs == 2 * heard.pairs);
  CHECK(twice.normal[20] == 2 * heard.normal[20]);
}

TEST_CASE("icp_directions__are_observable_where_information_stands_out_of_noise") {
  IcpSums sums;
  sums.normal = diagonal_of({100, 50, 20, 10, 5, 1});
  sums.noise = diagonal_of({1, 1, 1, 1, 1, 0.2});
  const IcpDirections found = icp_directions(sums);
  const double information[] = {0.8, 4, 9, 19, 49, 99};
  for (size_t k = 0; k < 6; ++k) {
    CHECK(found.information[k] == doctest::Approx(information[k]).scale(0));
    CHECK(found.observable[k] == (k >= 3));  // ten times the noise
    CHECK(std::abs(found.unit[k][5 - k]) == doctest::Approx(1));
  }
  // Without noise: what rounding leaves of a direction that nothing holds.
  sums.normal = diagonal_of({1, 1, 1e-11, 1, 1e-7, 1});
  sums.noise = {};
  const IcpDirections exact = icp_directions(sums);
  CHECK_FALSE(exact.observable[0]);
  CHECK(exact.observable[1]);
}

TEST_CASE("icp_step__solves_the_equations_and_stays_off_what_is_open") {
  const PairsOfRoom room;
  const IcpSums sums = room.sums(room.T_reference_moving);
  IcpDirections directions = icp_directions(sums);
  directions.observable.fill(true);
  const Coefficients<6> x = icp_step(sums, directions);
  for (size_t r = 0; r < 6; ++r) {
    double left = 0, size = 0;
    for (size_t c = 0; c < 6; ++c) {
      const double n = sums.normal[6 * r + c] - sums.noise[6 * r + c];
      left += n * x[c];
      size += std::abs(n * x[c]);
    }
    CHECK(std::abs(left - sums.right[r]) < 1e-9 * size);
  }
  directions.observable[1] = false;
  const Coefficients<6> held = icp_step(sums, directions);
  double along_open = 0, along_other = 0;
  for (size_t i = 0; i < 6; ++i) {
    along_open += held[i] * directions.unit[1][i];
    along_other += (held[i] - x[i]) * directions.unit[4][i];
  }
  CHECK(std::abs(along_open) < 1e-12);
  CHECK(std::abs(along_other) < 1e-12);
}
