// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numbers>

#include "geometry/rigid_motion.h"
#include "scan/misfit.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// What a scanner at the origin observes (Boulaassal 2010, 1.1 turned round).
struct Observed {
  explicit Observed(const Vec3& p)
      : range(norm(p)), horizontal(std::atan2(p.x, p.y)), vertical(std::asin(p.z / norm(p))) {}
  double range, horizontal, vertical;
};

/// An upright wall 100 m in front of a scanner at the origin, a few metres high.
Model far_wall() {
  Model model;
  model.vertices = {{-20, 100, -5}, {20, 100, -5}, {20, 100, 15}, {-20, 100, 15}};
  model.triangles = {{0, 1, 2}, {0, 2, 3}};
  model.triangle_faces = {1, 1};
  return model;
}

struct Spread {
  double n = 0, range = 0, horizontal = 0, vertical = 0, point = 0;  ///< sums of squares
};

Spread spread_of(const Cloud& cloud) {
  Spread sum;
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Observed seen(cloud.point(i)), exact(true_point(cloud, i));
    const auto squared = [](double x) { return x * x; };
    sum.n += 1;
    sum.range += squared(seen.range - exact.range);
    sum.horizontal += squared(seen.horizontal - exact.horizontal);
    sum.vertical += squared(seen.vertical - exact.vertical);
    sum.point += squared_norm(cloud.point(i) - true_point(cloud, i));
  }
  return sum;
}

const ScanStation kInstrumentOrigin = station_at({0, 0, 0});

/// The wall fills the view.
StaticSettings wall_settings(double step_rad, const StaticSettings& more = {}) {
  StaticSettings params = quiet_settings(step_rad, more);
  params.horizontal_from_rad = -0.2;
  params.horizontal_to_rad = 0.2;
  params.vertical_from_rad = -0.05;
  params.vertical_to_rad = 0.15;
  return params;
}

}  // namespace

TEST_CASE("instrument__observations_spread_by_their_own_deviations") {
  const double range_noise = 0.004, ppm = 30, horizontal = 5e-5, vertical = 9e-5;
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    StaticSettings params =
        wall_settings(0.002, {.range_noise_ppm = ppm, .vertical_noise_rad = vertical});
    params.range_noise_m = range_noise;
    params.angle_noise_rad = horizontal;
    params.seed = seed;
    const Cloud cloud = scanned(far_wall(), params, {&kInstrumentOrigin, 1});
    REQUIRE(cloud.size() > 10000);
    double squares[3] = {};
    for (size_t i = 0; i < cloud.size(); ++i) {
      const Observed seen(cloud.point(i)), exact(true_point(cloud, i));
      const double z[3] = {(seen.range - exact.range) / (range_noise + ppm * 1e-6 * exact.range),
                           (seen.horizontal - exact.horizontal) / horizontal,
                           (seen.vertical - exact.vertical) / vertical};
      for (int k = 0; k < 3; ++k) squares[k] += z[k] * z[k];
    }
    for (const double sum : squares) CHECK(is_chi_squared(sum, static_cast<double>(cloud.size())));
  }
}

TEST_CASE("instrument__vertical_noise_alone_and_by_default_that_of_the_horizontal_angle") {
  const Cloud alone = scanned(far_wall(), wall_settings(0.004, {.vertical_noise_rad = 1e-4}),
                              {&kInstrumentOrigin, 1});
  const Spread spread = spread_of(alone);
  CHECK(is_chi_squared(spread.vertical / 1e-8, spread.n));
  CHECK(spread.horizontal < 1e-20);
  StaticSettings params = wall_settings(0.004);
  params.angle_noise_rad = 1e-4;
  const Cloud both = scanned(far_wall(), params, {&kInstrumentOrigin, 1});
  params.vertical_noise_rad = 1e-4;
  CHECK(same_clouds(both, scanned(far_wall(), params, {&kInstrumentOrigin, 1})));
}

TEST_CASE("instrument__gx_scatters_as_its_maker_says") {
  // Boulaassal 2010, 5.3.3: 11.58 mm at 100 m on the horizon; the maker says 12.
  StaticSettings params = wall_settings(0.0015, {.instrument = StaticSettings::Instrument::kGx});
  const Cloud cloud = scanned(far_wall(), params, {&kInstrumentOrigin, 1});
  const Spread spread = spread_of(cloud);
  CHECK(is_chi_squared(spread.range / (0.007 * 0.007), spread.n));
  CHECK(is_chi_squared(spread.horizontal / (60e-6 * 60e-6), spread.n));
  CHECK(is_chi_squared(spread.vertical / (70e-6 * 70e-6), spread.n));
  double expected = 0;
  for (const float r : values<float>(cloud, "range")) {
    const double at = static_cast<double>(r);
    expected += 0.007 * 0.007 + at * at * (60e-6 * 60e-6 + 70e-6 * 70e-6);
  }
  const double point = std::sqrt(spread.point / spread.n);
  CHECK(is_chi_squared(spread.point / (expected / spread.n), spread.n));
  MESSAGE("FIGURE gx single point at 100 m: " << 1000 * point
                                              << " mm (11.58 by propagation, 12 by the maker)");
}

TEST_CASE("misfit__is_a_small_rigid_error_with_the_deviations_asked_for") {
  const StaticSettings settings{.misfit_shift_m = 0.004, .misfit_rotation_rad = 2e-4};
  const ScanStation station = station_at({652000, 6861000, 35});
  constexpr size_t kStations = 20000;
  Vec3 shifts, turns, mean_shift;
  for (size_t s = 0; s < kStations; ++s) {
    const Transform recorded = Misfit(settings, s).recorded(station.pose);
    REQUIRE_NOTHROW(require_rigid(recorded, "a pose"));
    const Vec3 shift = (recorded.translation() - station.pose.translation()) / 0.004;
    // The skew part of a small rotation is its vector.
    const Vec3 turn = Vec3{recorded.m[9] - recorded.m[6], recorded.m[2] - recorded.m[8],
                           recorded.m[4] - recorded.m[1]} /
                      (2 * 2e-4);
    for (int a = 0; a < 3; ++a) shifts[a] += shift[a] * shift[a], turns[a] += turn[a] * turn[a];
    mean_shift += shift;
  }
  for (int a = 0; a < 3; ++a) {
    CHECK(is_chi_squared(shifts[a], kStations));
    CHECK(is_chi_squared(turns[a], kStations));
    CHECK(std::abs(mean_shift[a]) < 4 * std::sqrt(double{kStations}));
  }
}

TEST_CASE("misfit__moves_pose_and_points_of_a_station_alike_and_leaves_the_truth") {
  const Model model = scene("facade");
  const ScanStation stations[] = {station_at({5, -13, 1.7}), station_at({17, -12, 1.5})};
  const StaticSettings quiet = quiet_settings(0.01, {.outliers = 0.05});
  StaticSettings params = quiet;
  params.misfit_shift_m = 0.005;
  params.misfit_rotation_rad = 1e-3;
  const Cloud exact = scanned(model, quiet, stations), moved = scanned(model, params, stations);
  REQUIRE(exact.size() == moved.size());
  CHECK(same_bits(values<double>(exact, "true_xyz"), values<double>(moved, "true_xyz")));
  for (size_t s = 0; s < 2; ++s) {
    CHECK(exact.stations[s].pose.m == stations[s].pose.m);
    const Transform error = moved.stations[s].pose * inverse(stations[s].pose);
    CHECK(norm(moved.stations[s].pose.translation() - stations[s].pose.translation()) > 1e-4);
    for (uint64_t i = moved.stations[s].first;
         i < moved.stations[s].first + moved.stations[s].count; ++i)
      REQUIRE(norm(moved.point(i) - error.point(exact.point(i))) < 1e-11);
  }
  CHECK_FALSE(moved.stations[0].pose.m == moved.stations[1].pose.m);
}

TEST_CASE("automatic_stations__take_a_number_and_a_distance") {
  const Model facade = scene("facade");
  const auto four = automatic_stations(facade, 4, 30);
  REQUIRE(four.size() == 4);
  for (size_t i = 0; i < 4; ++i) {
    CHECK(std::abs(four[i].pose.translation().x - 11) ==
          doctest::Approx(i == 0 || i == 3 ? 8.25 : 2.75));
    CHECK(four[i].pose.translation().y == doctest::Approx(-0.35 - 30));
  }
  CHECK(automatic_stations(scene("room"), 3).size() == 3);
  const auto around = automatic_stations(scene("box"), 6, 5);
  REQUIRE(around.size() == 6);
  for (const ScanStation& station : around)
    CHECK(std::hypot(station.pose.translation().x, station.pose.translation().y) ==
          doctest::Approx(std::hypot(4.2, 1.8) / 2 + 5));
  StaticSettings params = quiet_settings(0.05, {.stations = 5, .station_distance_m = 20});
  CHECK(scanned(facade, params).stations.size() == 5);
}
