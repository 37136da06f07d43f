// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edge_curve.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "unit/modelling/walls.h"

using namespace jalon;

namespace {

// The wall of the specification's own measurements: 3.0 x 3.5 m, points 0.10 m apart, one window of 1.1 x 1.6 m.
constexpr double kStep_m = 0.1;
bool in_window(double x, double z) { return x > 0.9 && x < 2.0 && z > 1.0 && z < 2.6; }

Segmentation wall_with_window(double jitter_m) {
  std::vector<Vec3> points;
  RandomStream random(1, 7);
  for (int i = 0; i <= 30; ++i)
    for (int k = 0; k <= 35; ++k) {
      const double x = kStep_m * i, z = kStep_m * k;
      if (in_window(x, z)) continue;
      points.push_back({x + jitter_m * (2 * random.uniform() - 1), 0,
                        z + jitter_m * (2 * random.uniform() - 1)});
    }
  return walls::segmentation_of({points});
}

EdgeCurve curve_of(const Segmentation& segmentation, double threshold_m = 0, uint32_t label = 1) {
  Task task;
  return find_edge_curve(segmentation, label, {threshold_m}, task);
}

}  // namespace

TEST_CASE("edge_curve__contour_points_are_borders_and_none_lies_inside") {
  const Segmentation wall = wall_with_window(0.001);
  for (const double spacings : {2.0, 3.0, 4.0}) {
    CAPTURE(spacings);
    const EdgeCurve curve = curve_of(wall, spacings * kStep_m);
    size_t outer = 0, hole = 0, inner = 0;
    for (const uint64_t i : curve.points) {
      const Vec3 p = wall.cloud->point(i);
      const bool is_outer = p.x < 0.02 || p.x > 2.98 || p.z < 0.02 || p.z > 3.48;
      const bool is_hole = p.x > 0.85 && p.x < 2.05 && p.z > 0.95 && p.z < 2.65;
      ++(is_outer ? outer : is_hole ? hole : inner);
    }
    MESSAGE("FIGURE long edges, T = " << spacings << " spacings: outer " << outer << ", hole "
                                      << hole << ", inner " << inner);
    CHECK(inner == 0);
    CHECK(hole >= 30);  // of 54: the rule misses T / sqrt(2) beside each corner
    CHECK(outer > 10);  // of 130: on a straight border only where it is ragged
    CHECK(curve.threshold_m == spacings * kStep_m);
    CHECK(std::is_sorted(curve.points.begin(), curve.points.end()));
  }
}

TEST_CASE("edge_curve__is_sorted_counts_every_edge_once_and_turns_between_two_and_five_spacings") {
  for (const double jitter_m : {0.001, 0.01, 0.03}) {
    CAPTURE(jitter_m);
    const EdgeCurve curve = curve_of(wall_with_window(jitter_m));
    CHECK(std::is_sorted(curve.lengths_m.begin(), curve.lengths_m.end()));
    CHECK(curve.lengths_m.size() > 2000);
    CHECK(curve.lengths_m.size() < 3 * 1116);  // 3 n - 6 at most (Euler)
    CHECK(curve.spacing_m == doctest::Approx(kStep_m).epsilon(0.2).scale(0));
    CHECK(curve.threshold_m == curve.knee_m);
    CHECK(curve.knee_m >= 2 * curve.spacing_m);
    CHECK(curve.knee_m <= 5 * curve.spacing_m);
    const auto longer =
        static_cast<uint64_t>(std::count_if(curve.lengths_m.begin(), curve.lengths_m.end(),
                                            [&](double l) { return l > curve.threshold_m; }));
    CHECK(curve.longer == longer);
    CHECK(longer > 0);
  }
}

TEST_CASE("edge_curve__refuses_what_has_no_triangles") {
  const Segmentation wall = wall_with_window(0.001);
  CHECK_THROWS_WITH_AS(curve_of(wall, 0, 0), doctest::Contains("label 0"), Error);
  CHECK_THROWS_WITH_AS(curve_of(wall, 0, 2), doctest::Contains("1 segments"), Error);
  Segmentation ball = wall;
  ball.segments[0].type = PrimitiveType::kSphere;
  CHECK_THROWS_WITH_AS(curve_of(ball), doctest::Contains("no plane"), Error);
  Segmentation none = wall;
  none.segments.push_back(none.segments[0]);
  CHECK_THROWS_WITH_AS(curve_of(none, 0, 2), doctest::Contains("0 points"), Error);
}

TEST_CASE("edge_curve__tables_hold_what_was_found") {
  const EdgeCurve curve = curve_of(wall_with_window(0.01));
  CHECK(edge_length_table(curve).require("length").count() == curve.lengths_m.size());
  CHECK(contour_point_table(curve).require("point").values<uint64_t>()[0] == curve.points[0]);
  CHECK(edge_summary_table(curve).require("longer").values<uint64_t>()[0] == curve.longer);
}
