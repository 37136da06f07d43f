// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The reveal beside an edge, wherever the edge was assumed.
#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "modelling/edges/adjust/edge_reveal.h"

using namespace jalon;

namespace {

constexpr RevealSetting kSetting{2, 0.025, 0.003};
constexpr double kDepth_m = 0.2;

/// A pane behind an opening that ends at the reveal, in columns as a tripod leaves them. d: into the solid.
std::vector<RevealPoint> pane(double reveal_d_m, RandomStream& random) {
  std::vector<RevealPoint> out;
  for (double d = reveal_d_m - 0.025 * random.uniform(); d > -0.05; d -= 0.025)
    for (double t = 0; t < kSetting.length_m; t += 0.025)
      out.push_back({t, d, -kDepth_m + kSetting.sigma_m * random.normal()});
  return out;
}

std::vector<RevealPoint> pane_and_reveal(double reveal_d_m, RandomStream& random) {
  std::vector<RevealPoint> out = pane(reveal_d_m, random);
  for (double h = 0.06 * random.uniform(); h < kDepth_m; h += 0.06)
    for (double t = 0; t < kSetting.length_m; t += 0.05)
      out.push_back({t, reveal_d_m + kSetting.sigma_m * random.normal(), -h});
  return out;
}

}  // namespace

TEST_CASE("edge_reveal__is_found_wherever_the_edge_was_assumed") {
  double worst_m = 0, squares_m2 = 0;
  constexpr int kTrials = 200;
  for (uint64_t k = 0; k < kTrials; ++k) {
    RandomStream random(k, 1);
    const double truth_m =
        kSetting.spacing_m * (2 * random.uniform() - 1);  // half a spacing, and noise
    CAPTURE(truth_m);
    const auto reveal = find_reveal(pane_and_reveal(truth_m, random), kSetting);
    REQUIRE(reveal);
    const double error_m = reveal->offset_m - truth_m;
    worst_m = std::max(worst_m, std::fabs(error_m));
    squares_m2 += error_m * error_m;
  }
  const double rms_m = std::sqrt(squares_m2 / kTrials);
  MESSAGE("FIGURE reveals within a spacing of the assumed edge: all found, "
          << 1000 * rms_m << " mm off (RMS), worst " << 1000 * worst_m << " mm");
  CHECK(rms_m <= 0.001);
  CHECK(worst_m <= 0.005);
}

TEST_CASE("edge_reveal__a_pane_alone_has_none") {
  for (uint64_t k = 0; k < 200; ++k) {
    RandomStream random(k, 2);
    CHECK_FALSE(find_reveal(pane(0.02 * random.uniform(), random), kSetting));
  }
}

TEST_CASE("edge_reveal__one_column_on_it_and_one_on_the_frame_behind_are_no_splayed_embrasure") {
  // Of a window seen at a slant by one coarse scan: seed 1284 of scene "grammar".
  std::vector<RevealPoint> columns;
  for (double t = 0; t < kSetting.length_m; t += 0.05) {
    RandomStream random(static_cast<uint64_t>(100 * t), 3);
    const double noise_m = 0.001 * random.normal();
    columns.push_back({t, noise_m, -0.108 + noise_m});
    columns.push_back({t, -0.009 + noise_m, -0.143 + noise_m});
    columns.push_back({t, -0.04, -0.205 + noise_m});
  }
  CHECK_FALSE(find_reveal(columns, kSetting));
  // The embrasure itself, in as many points.
  std::vector<RevealPoint> splayed;
  for (double t = 0; t < kSetting.length_m; t += 0.05)
    for (const double h : {0.1, 0.12, 0.14, 0.16})
      splayed.push_back({t + h, -0.25 * (h - 0.1), -h});
  const auto found = find_reveal(splayed, kSetting);
  REQUIRE(found);
  CHECK(found->slope == doctest::Approx(0.25).epsilon(0.03).scale(0));
}
