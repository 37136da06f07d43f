// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/hough/accumulator.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

using namespace jalon;

TEST_CASE("accumulator__has_a_direction_within_reach_of_every_normal_and_none_twice") {
  const double step = 0.1;
  const HoughAccumulator votes(step, 0.05, 5);
  RandomStream random(3, 0);
  for (int i = 0; i < 500; ++i) {
    const Vec3 n = normalized({random.normal(), random.normal(), random.normal()});
    double best = 0;
    for (size_t d = 0; d < votes.directions(); ++d)
      best = std::max(best, std::fabs(dot(n, votes.direction(d))));
    CHECK(std::acos(std::min(1.0, best)) < 0.75 * step);
  }
  for (size_t a = 0; a < votes.directions(); ++a)
    for (size_t b = 0; b < a; ++b)
      REQUIRE(std::fabs(dot(votes.direction(a), votes.direction(b))) < std::cos(0.4 * step));
}

TEST_CASE("accumulator__widens_the_step_of_distances_beyond_what_it_has_cells_for") {
  const double longest_m = HoughAccumulator::longest_half_m(0.05, 0.04);
  CHECK(HoughAccumulator(0.05, 0.04, 0.999 * longest_m).rho_step_m() == 0.04);
  CHECK(HoughAccumulator(0.05, 0.04, 1.1 * longest_m).rho_step_m() == doctest::Approx(0.044));
}

TEST_CASE("accumulator__peaks_at_the_plane_and_forgets_what_is_taken_back") {
  for (const bool with_normals : {true, false}) {
    HoughAccumulator votes(0.05, 0.05, 5);
    RandomStream random(4, 0);
    std::vector<HoughAccumulator::Voter> voters;
    const Vec3 n = with_normals ? Vec3{0, 0, -1} : Vec3{};
    for (int i = 0; i < 300; ++i)
      voters.push_back({{4 * random.uniform() - 2, 4 * random.uniform() - 2, 1.01}, n});
    Task task;
    votes.vote(voters, 0.17, task);
    const HoughAccumulator::Peak peak = votes.peak();
    CHECK(peak.votes == 300);
    CHECK(votes.direction(peak.direction).z == doctest::Approx(1));
    CHECK(std::fabs(votes.rho_m(peak.rho) - 1.01) <= 0.026);
    for (const auto& voter : voters) {
      CHECK(votes.voted(voter, peak, 0.17));
      votes.take_back(voter, 0.17);
    }
    CHECK(votes.peak().votes == 0);
  }
}
