// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The field of distances along a surface against paths of known length, and its seeds and limits.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "fieldtools/fast_marching.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// The error that the front's own header states, 1.5 % of the distance, and a cell at either end.
constexpr double kFrontError = 0.015;

std::vector<double> along_surface(const std::vector<Vec3>& points,
                                  const std::vector<uint64_t>& seeds,
                                  const GeodesicSettings& settings = {}) {
  Task task;
  const Cloud out = with_geodesic_distance(cloud_of(points), seeds, settings, task);
  const auto found = out.fields.require(settings.name).values<double>();
  return {found.begin(), found.end()};
}

// A sheet folded along two edges, as a U: 2 m up, 1 m across, 2 m down, 1 m deep; 4 cm between points.
struct Fold {
  std::vector<Vec3> points;
  std::vector<Vec2> flat;  ///< where they lie on the sheet

  Fold() {
    for (int i = 0; i <= 125; ++i)
      for (int j = 0; j <= 25; ++j) {
        const double s = 0.04 * i, v = 0.04 * j;
        flat.push_back({s, v});
        points.push_back(s < 2 ? Vec3{0, v, s} : s < 3 ? Vec3{s - 2, v, 2} : Vec3{1, v, 5 - s});
      }
  }
};

}  // namespace

TEST_CASE("with_geodesic_distance__over_two_folds__the_straight_way_on_the_unfolded_sheet") {
  const Fold fold;
  const auto found = along_surface(fold.points, {0});  // cells of 3 mean spacings
  size_t shorter = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    const double truth = norm(fold.flat[i] - fold.flat[0]);
    // Centroids of cells of 12 cm cut each of the two folds: at most 2 - sqrt(2) cells a fold.
    CHECK(found[i] <= (1 + kFrontError) * truth + 0.12);
    CHECK(found[i] >= (1 - kFrontError) * truth - 0.12 - 2 * 0.6 * 0.12);
    shorter += found[i] > 2 * norm(fold.points[i] - fold.points[0]) + 0.5;
  }
  CHECK(shorter > 200);  // through the air the far end is near
}

TEST_CASE("with_geodesic_distance__of_several_seeds_the_nearest_counts") {
  const Fold fold;
  GeodesicSettings set;
  set.cell_m = 0.12;
  const uint64_t last = fold.points.size() - 1;
  const auto a = along_surface(fold.points, {10}, set), b = along_surface(fold.points, {last}, set),
             both = along_surface(fold.points, {last, 10, 10}, set);
  for (size_t i = 0; i < both.size(); ++i) {
    const double truth = std::min(a[i], b[i]);
    CHECK(std::fabs(both[i] - truth) <= kFrontError * truth + 0.12);
  }
  CHECK(both[10] == 0);
  CHECK(both[last] == 0);
}

TEST_CASE("with_geodesic_distance__beyond_the_limit_or_a_gap_there_is_no_value") {
  const Fold fold;
  GeodesicSettings set, limited;
  set.cell_m = limited.cell_m = 0.12;
  limited.max_distance_m = 2.5;
  limited.name = "walk";
  const auto all = along_surface(fold.points, {0}, set),
             near = along_surface(fold.points, {0}, limited);
  size_t missing = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    missing += std::isnan(near[i]);
    if (std::isnan(near[i])) CHECK(all[i] > 2.5 - 0.12);  // whole cells end there
    else CHECK(near[i] <= 2.5);
  }
  CHECK(missing > 1000);
  std::vector<Vec3> torn = fold.points;
  std::erase_if(torn, [](const Vec3& p) { return p.z == 2 && p.x > 0.3 && p.x < 0.8; });
  const auto found = along_surface(torn, {0}, set);
  for (size_t i = 0; i < torn.size(); ++i) CHECK(std::isnan(found[i]) == (torn[i].x > 0.5));
}

TEST_CASE("with_geodesic_distance__what_is_wrong_with_seeds_and_names_is_told") {
  const Fold fold;
  CHECK(refuses([&] { along_surface(fold.points, {}); }, Status::kInsufficientData, "no seeds"));
  CHECK(refuses(
      [&] {
        along_surface({{0, 0, 0}, {1, 0, 0}}, {1, 2});
      },
      Status::kInvalidArgument, "seed 2 is no point of the cloud, which has 2"));
  GeodesicSettings nameless;
  nameless.name = "";
  CHECK(refuses([&] { along_surface(fold.points, {0}, nameless); }, Status::kInvalidArgument,
                "name"));
  CHECK(refuses(
      [&] {
        along_surface({{0, 0, 0}, {1, 0, 0}}, {0});
      },
      Status::kInsufficientData, "2 points"));
}
