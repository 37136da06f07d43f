// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Scenes std, normal, patches and robbery: the noise of planes, two patches of one plane, a shelf on a wall.
#include <doctest/doctest.h>

#include <map>

#include "recipe.h"
#include "segment/result/residuals.h"
#include "segment/surface/tolerance.h"

namespace jalon::plane_recipes_test {

using namespace jalon::test;

namespace {

/// Share of the points whose residual is less than so many standard deviations.
double share_within(const Segmentation& s, double reach_m) {
  const auto residuals = s.residuals->values<float>();
  const auto within = std::count_if(residuals.begin(), residuals.end(),
                                    [&](float r) { return std::fabs(r) < reach_m; });
  return static_cast<double>(within) / static_cast<double>(residuals.size());
}

std::string with(std::string json, const std::string& more) {
  return json.insert(json.size() - 1, ", " + more);
}

}  // namespace

TEST_CASE("S5_std__ten_planes_are_6_to_9_mm_thick_as_in_table_3_4") {
  for (uint64_t seed = 1; seed <= (is_full() ? 20 : 3); ++seed) {
    CAPTURE(seed);
    const Recipe recipe(R"({"name": "std"})", "sample", R"({"points": 50000, "noise_m": 0.0075})",
                        seed);
    const Segmentation s = ransac(recipe.cloud, R"({"distance_tolerance_m": 0.025})", seed);
    REQUIRE(s.segments.size() == 10);
    std::string row;
    double sum = 0;
    std::map<Orientation, int> of_class;
    for (const Segment& segment : s.segments) {
      const double sigma_mm = 1000 * segment.sigma_m();
      row += " " + std::to_string(sigma_mm).substr(0, 4);
      sum += sigma_mm;
      ++of_class[segment.orientation];
      CHECK(sigma_mm > 6);
      CHECK(sigma_mm < 9);
    }
    CHECK(sum / 10 > 7);
    CHECK(sum / 10 < 8);
    CHECK(of_class[Orientation::kParallel] == 6);
    CHECK(of_class[Orientation::kVertical] == 2);
    CHECK(of_class[Orientation::kHorizontal] == 2);
    const Evaluation e = evaluated(s, true_segmentation(recipe.cloud), 50);
    MESSAGE("FIGURE S5, seed " << seed << ": standard deviations" << row << " mm, mean " << sum / 10
                               << " mm, TDR " << e.totals.detection << ", TDA "
                               << e.totals.accuracy);
    CHECK(e.totals.detection > 0.99);
    CHECK(e.totals.accuracy > 0.99);
  }
}

TEST_CASE("S6_normal__the_residuals_of_one_plane_are_the_normal_distribution_of_figure_3_9") {
  constexpr double kSigma_m = 0.0025;
  const std::string given = R"({"tolerance_from": "sigma", "sigma_m": 0.0025})";
  for (uint64_t seed = 1; seed <= (is_full() ? 20 : 3); ++seed) {
    CAPTURE(seed);
    const Recipe recipe(R"({"name": "normal"})", "sample",
                        R"({"points": 100000, "noise_m": 0.0025})", seed);
    // The plain method: least squares through all points of the segment. With normals the last fit leaves out what is
    // farther off than four sigma, here six points, and the mean of all is 0.4 micrometres.
    const Segmentation s = ransac(recipe.cloud, R"({"normals": "none"})", seed);
    REQUIRE(s.segments.size() == 1);
    Task task;
    const Residuals r = bin_residuals(s, 1, 50, task);
    double sum = 0;
    for (size_t i = 0; i < recipe.cloud->size(); ++i)
      sum += s.segments[0].distance(recipe.cloud->point(i));
    const double mean = sum / 100000,
                 estimate = estimate_sigma(*recipe.cloud, *recipe.cloud->octree(task), task);
    const double inner = share_within(s, 2.576 * kSigma_m),
                 outer = share_within(s, 3.035 * kSigma_m);
    MESSAGE("FIGURE S6, seed " << seed << ": mean " << mean << " m, sigma " << 1000 * r.sigma_m
                               << " mm, estimated without a plane " << 1000 * estimate << " mm; "
                               << inner << " of the points within 2.576 sigma, " << outer
                               << " within 3.035");
    CHECK(r.count == 100000);
    CHECK(std::fabs(mean) < 1e-9);
    CHECK(std::fabs(r.sigma_m - kSigma_m) < 0.01 * kSigma_m);
    CHECK(std::fabs(ransac(recipe.cloud, "{}", seed).segments[0].sigma_m() - kSigma_m) <
          0.01 * kSigma_m);
    CHECK(std::fabs(estimate - kSigma_m) < 0.02 * kSigma_m);
    // Four standard deviations of the shares of 100 000 points.
    CHECK(std::fabs(inner - 0.990) < 4 * std::sqrt(0.990 * 0.010 / 1e5));
    CHECK(std::fabs(outer - 0.9976) < 4 * std::sqrt(0.9976 * 0.0024 / 1e5));
    // The same shares are what the tolerance by chi-square keeps: one degree of freedom is right, two are the thesis'.
    const auto kept = [&](const char* dof) {
      const Segmentation t =
          ransac(recipe.cloud, with(given, "\"tolerance_dof\": " + std::string(dof)), seed);
      return static_cast<double>(t.segments.at(0).point_count());
    };
    CHECK(std::fabs(kept("1") / 1e5 - 0.990) < 4 * std::sqrt(0.990 * 0.010 / 1e5));
    CHECK(std::fabs(kept("2") / 1e5 - 0.9976) < 4 * std::sqrt(0.9976 * 0.0024 / 1e5));
  }
}

TEST_CASE("S8_patches__two_of_one_plane_are_two_segments_or_one_as_the_gap_says") {
  struct Case {
    std::string json;
    size_t segments;
  };
  const Case cases[] = {{"{}", 2},
                        {R"({"gap_m": 0, "merge_gap_m": 0})", 2},
                        {R"({"gap_m": 0.9, "merge_gap_m": 0.9})", 2},
                        {R"({"gap_m": 1.2})", 1},
                        {R"({"merge_gap_m": 1.2})", 1},
                        {R"({"connectivity": false})", 1}};
  for (uint64_t seed = 1; seed <= (is_full() ? 20 : 3); ++seed) {
    const Recipe recipe(R"({"name": "patches"})", "sample",
                        R"({"points": 20000, "noise_m": 0.005})", seed);
    for (const Case& c : cases) {
      CAPTURE(seed);
      CAPTURE(c.json);
      const Segmentation s = ransac(recipe.cloud, c.json, seed);
      REQUIRE(s.segments.size() == c.segments);
      if (c.segments == 1) {
        CHECK(s.segments[0].point_count() == 20000);
        continue;
      }
      const double first = std::max(share_of(s, 1, 1), share_of(s, 1, 2));
      const double second = std::max(share_of(s, 2, 1), share_of(s, 2, 2));
      if (c.json == "{}")
        MESSAGE("FIGURE S8, seed " << seed << ": 2 segments with " << first << " and " << second);
      CHECK(first > 0.999);
      CHECK(second > 0.999);
    }
  }
}

TEST_CASE(
    "S9b_robbery__a_shelf_loses_what_the_recipe_says_when_the_wall_comes_first_and_nothing_when_"
    "last") {
  constexpr double kTolerance_m = 0.025, kWallHeight_m = 6;
  // The chain of the thesis: classes in order, and points stay with the plane that took them first.
  const std::string thesis =
      R"({"distance_tolerance_m": 0.025, "normals": "none", "reassign": false})";
  for (const char* crossing : {"false", "true"})
    for (const char* depth : {"0.10", "0.25", "0.50"}) {
      CAPTURE(crossing);
      CAPTURE(depth);
      const double sides = *crossing == 't' ? 2 : 1,
                   expected = sides * kTolerance_m / std::strtod(depth, nullptr);
      const std::string sizes =
          R"("depth_m": )" + std::string(depth) + R"(, "crossing": )" + crossing;
      const std::string scene = with(R"({"name": "robbery"})", sizes);
      const Recipe recipe(scene.c_str(), "sample", R"({"points": 200000, "noise_m": 0.005})", 1);
      const auto in_order = [&](const std::string& order) {
        return ransac(recipe.cloud, with(thesis, R"("orientation_order": ")" + order + "\""));
      };
      const Segmentation wall_first = in_order("parallel horizontal"),
                         shelf_first = in_order("horizontal parallel");
      const Segmentation shared_out = ransac(recipe.cloud, "{}");
      for (const Segmentation* s : {&wall_first, &shelf_first, &shared_out})
        REQUIRE(s->segments.size() == 2);
      const double robbed = share_of(wall_first, 2, 1), strip = share_of(shelf_first, 1, 2);
      MESSAGE("FIGURE S9b, depth "
              << std::string(depth) << " m, " << std::string(sides == 2 ? "crossing" : "ending at")
              << " the wall: wall first robs " << robbed << " of the shelf (recipe " << expected
              << "), shelf first " << strip << " of the wall; shared out anew "
              << share_of(shared_out, 2, 1) << " and " << share_of(shared_out, 1, 2));
      CHECK(std::fabs(robbed - expected) < 0.01);
      CHECK(share_of(shelf_first, 2, 2) > 0.999);
      // A strip of twice the tolerance: the wall does not miss it.
      CHECK(std::fabs(strip - 2 * kTolerance_m / kWallHeight_m) < 0.001);
      CHECK(share_of(shared_out, 2, 1) < expected / 3);
      CHECK(share_of(shared_out, 1, 2) < strip / 3);
    }
}

}  // namespace jalon::plane_recipes_test
