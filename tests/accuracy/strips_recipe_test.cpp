// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Six staggered strips, which points alone take for one slanted plane.
#include <doctest/doctest.h>

#include <numbers>

#include "recipe.h"

namespace jalon::strips_recipe_test {

using namespace jalon::test;

namespace {

// The method of the thesis: any three points are a plane, which keeps what it took.
std::string thesis(const std::string& tolerance_m, const std::string& order) {
  return R"({"connectivity": false, "normals": "none", "sampling": "global", "refit": false, "reassign": false,)"
         R"("distance_tolerance_m": )" +
         tolerance_m + R"(, "orientation_order": ")" + order + R"("})";
}

double tilt_deg(const Segment& segment) {
  return std::acos(std::min(1.0, std::fabs(segment.fit.plane.normal.y))) * 180 / std::numbers::pi;
}

double percent(const Segmentation& s, size_t row) {
  return 100 * static_cast<double>(s.segments[row].point_count()) /
         static_cast<double>(s.cloud->size());
}

}  // namespace

TEST_CASE("S7_strips__slanted_by_points_alone_and_one_strip_a_plane_with_the_orientation") {
  struct Row {
    const char* tolerance_m;
    double least, most, least_deg,
        most_deg;  // of the first plane by points alone, as in the recipe's table
    double sum_percent = 0;
  };
  Row rows[] = {{"0.025", 53, 55, 3.5, 3.7}, {"0.05", 93, 96, 3.7, 3.7}};
  constexpr double kRound_deg = 0.15;  // of the table's five seeds, which are not ours
  const uint64_t seeds = is_full() ? 20 : 3;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    const Recipe recipe(R"({"name": "strips"})", "sample",
                        R"({"points": 3000, "noise_m": 0.005, "equal_counts": true})", seed);
    for (Row& row : rows) {
      CAPTURE(seed);
      CAPTURE(std::string(row.tolerance_m));
      const Segmentation trapped = ransac(recipe.cloud, thesis(row.tolerance_m, ""), seed);
      const Segmentation s = ransac(recipe.cloud, thesis(row.tolerance_m, "parallel"), seed);
      REQUIRE(!trapped.segments.empty());
      REQUIRE(s.segments.size() == 6);
      double worst_deg = 0, most = 0;
      for (size_t k = 0; k < 6; ++k) {
        worst_deg = std::max(worst_deg, tilt_deg(s.segments[k]));
        most = std::max(most, percent(s, k));
      }
      MESSAGE("FIGURE S7, tolerance "
              << std::string(row.tolerance_m) << " m, seed " << seed << ": points alone "
              << percent(trapped, 0) << " % tilted " << tilt_deg(trapped.segments[0])
              << " deg; with the orientation at most " << most << " %, " << worst_deg << " deg");
      row.sum_percent += percent(trapped, 0);
      CHECK(tilt_deg(trapped.segments[0]) >= row.least_deg - kRound_deg);
      CHECK(tilt_deg(trapped.segments[0]) <= row.most_deg + kRound_deg);
      // A sixth of the points. With the larger tolerance the recipe's planes lean by 1 degree and hold 22-24 %: a
      // hypothesis that is turned onto its axis does not.
      CHECK(most < 17.5);
      CHECK(worst_deg < 0.5);
    }
  }
  // The table's range is that of five draws: of twenty some leave it, their mean does not.
  for (const Row& row : rows) {
    const double mean = row.sum_percent / static_cast<double>(seeds);
    MESSAGE("FIGURE S7, tolerance " << std::string(row.tolerance_m) << " m: points alone " << mean
                                    << " % on average");
    CHECK(mean >= row.least);
    CHECK(mean <= row.most);
  }
}

}  // namespace jalon::strips_recipe_test
