// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The upper edge of a sill's front, by the rows of points that end below it.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "modelling/edges/adjust/bar_edge.h"

using namespace jalon;

namespace {

constexpr double kBarEdgeSpacing_m = 0.025, kNoise_m = 0.001;
constexpr double kWidth_m = 1.4, kHeight_m = 0.1;  // of the bar; its upper edge at 0

/// Rows that rise by so many of their distances over the bar; a share of the columns hidden from some height on.
std::vector<Vec2> rows_on_bar(double rise, double hidden, RandomStream& random) {
  const double row_m = kBarEdgeSpacing_m * (0.8 + 0.4 * random.uniform()),
               column_m = kBarEdgeSpacing_m * kBarEdgeSpacing_m / row_m;
  const double phase_u = random.uniform(), phase_v = random.uniform();
  std::vector<Vec2> out;
  for (double u = phase_u * column_m; u < kWidth_m; u += column_m) {
    const double end = random.uniform() < hidden ? -kHeight_m * random.uniform() : 0;
    for (double v = (phase_v + rise * u / kWidth_m) * row_m - (rise + 8) * row_m; v < end;
         v += row_m)
      if (v > -kHeight_m) out.push_back({u, v + kNoise_m * random.normal()});
  }
  return out;
}

struct Errors {
  double n = 0, sum = 0, squares = 0, scaled = 0;
  void add(const BarEdge& edge) {
    n += 1;
    sum += edge.at_m;
    squares += edge.at_m * edge.at_m;
    scaled += edge.at_m * edge.at_m / (edge.sigma_m * edge.sigma_m);
  }
};

Errors errors_of(double least_rise, double most_rise, double hidden) {
  Errors out;
  for (uint64_t k = 0; k < 400; ++k) {
    RandomStream random(k, 1);
    const double rise = least_rise + (most_rise - least_rise) * random.uniform();
    const auto edge = upper_edge(rows_on_bar(rise, hidden, random), kBarEdgeSpacing_m, kNoise_m);
    REQUIRE(edge);
    out.add(*edge);
  }
  return out;
}

}  // namespace

TEST_CASE("bar_edge__is_known_to_half_a_row_along_level_rows_and_better_across_them") {
  struct Case {
    const char* name;
    double least_rise, most_rise, hidden, most_rms_m;
  };
  for (const Case& c :
       {Case{"level rows", 0, 0, 0, 0.009}, Case{"rows that rise by 1 to 4", 1, 4, 0, 0.0012},
        Case{"so, half of the columns shaded", 1, 4, 0.5, 0.003}}) {
    CAPTURE(std::string(c.name));
    const Errors e = errors_of(c.least_rise, c.most_rise, c.hidden);
    const double rms_m = std::sqrt(e.squares / e.n), bias_m = e.sum / e.n,
                 scaled = std::sqrt(e.scaled / e.n);
    MESSAGE("FIGURE upper edge of a bar, " << std::string(c.name) << ": bias " << 1000 * bias_m
                                           << " mm, RMS " << 1000 * rms_m
                                           << " mm; error / sigma RMS " << scaled);
    CHECK(rms_m <= c.most_rms_m);
    CHECK(std::fabs(bias_m) <= 0.05 * kBarEdgeSpacing_m);
    CHECK(scaled >= 0.4);
    CHECK(scaled <= 1.3);
  }
}

TEST_CASE("bar_edge__of_points_at_random_is_their_upper_end") {
  Errors e;
  for (uint64_t k = 0; k < 400; ++k) {
    RandomStream random(k, 2);
    std::vector<Vec2> points;
    for (double i = 0; i < kWidth_m * kHeight_m / (kBarEdgeSpacing_m * kBarEdgeSpacing_m); ++i)
      points.push_back({kWidth_m * random.uniform(),
                        -kHeight_m * random.uniform() + kNoise_m * random.normal()});
    const auto edge = upper_edge(points, kBarEdgeSpacing_m, kNoise_m);
    REQUIRE(edge);
    e.add(*edge);
  }
  MESSAGE("FIGURE upper edge of a bar, random points: bias " << 1000 * e.sum / e.n << " mm");
  CHECK(std::fabs(e.sum / e.n) <= 0.05 * kBarEdgeSpacing_m);
}

TEST_CASE("bar_edge__needs_columns") {
  RandomStream random(1, 3);
  std::vector<Vec2> points = rows_on_bar(2, 0, random);
  std::erase_if(points, [](const Vec2& p) { return p.u > 0.1; });
  CHECK_FALSE(upper_edge(points, kBarEdgeSpacing_m, kNoise_m));
  CHECK_FALSE(upper_edge({}, kBarEdgeSpacing_m, kNoise_m));
}
