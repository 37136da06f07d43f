// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/fast_marching.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "fieldtools/field_values.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

std::vector<double> geodesic(const Cloud& cloud, const std::vector<uint64_t>& seeds, double cell_m,
                             double most = 0) {
  Task task;
  GeodesicSettings set;
  set.cell_m = cell_m;
  set.max_distance_m = most;
  const Cloud out = with_geodesic_distance(cloud, seeds, set, task);
  const auto values = out.fields.require("geodesic").values<double>();
  return {values.begin(), values.end()};
}

/// Largest and root mean square error relative to the distance, beyond ten cells from the seed.
struct Error2 {
  double worst = 0, rms = 0;
};
template <class F>
Error2 errors(const std::vector<double>& found, double cell_m, F&& truth) {
  Error2 out;
  size_t n = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    const double t = truth(i);
    if (t < 10 * cell_m) continue;
    const double e = found[i] / t - 1;
    out.worst = std::max(out.worst, std::fabs(e));
    out.rms += e * e;
    ++n;
  }
  out.rms = std::sqrt(out.rms / static_cast<double>(n));
  return out;
}

TEST_CASE("arrival_time__one_two_and_three_axes") {
  AxisStep one[] = {{3, 0.5}};
  CHECK(arrival_time(one) == 3.5);
  AxisStep two[] = {{0, 1}, {0, 1}};
  CHECK(arrival_time(two) == doctest::Approx(std::sqrt(0.5)));
  AxisStep three[] = {{1, 1}, {1, 1}, {1, 1}};
  CHECK(arrival_time(three) == doctest::Approx(1 + std::sqrt(1.0 / 3)));
  AxisStep late[] = {{5, 1}, {0, 1}};  // the later one has no say
  CHECK(arrival_time(late) == 1);
  // A plane wave with a slowness of its own on each axis is met exactly.
  const double h = 0.1;
  AxisStep wave[] = {{1 - 0.6 * h, h}, {1 - 0.8 * h, h}};
  CHECK(arrival_time(wave) == doctest::Approx(1).epsilon(1e-14));
}

TEST_CASE("geodesic__on_planes__the_straight_distance") {
  const Vec3 directions[] = {{1, 0, 0}, {1, 1, 0}, {1, 2, 3}, {3, -1, 1}};
  for (int tilt = 0; tilt < 4; ++tilt) {
    const Vec3 u = normalized(directions[tilt]);
    const Vec3 v = normalized(cross(tilt == 0 ? Vec3{0, 0, 1} : Vec3{0.3, -0.2, 1}, u));
    RandomStream random(1, static_cast<uint64_t>(tilt));
    std::vector<Vec3> points{u * 3.0 + v * 3.0};
    for (size_t i = 0; i < 90000; ++i) {
      const double a = 10 * random.uniform(), b = 10 * random.uniform();
      points.push_back(u * a + v * b);
    }
    for (const double cell_m : {0.2, 0.1}) {
      const auto found = geodesic(cloud_of(points), {0}, cell_m);
      const Error2 e = errors(found, cell_m, [&](size_t i) { return norm(points[i] - points[0]); });
      MESSAGE("FIGURE geodesic, plane ", tilt, ", cell ", cell_m, ": largest error ", 100 * e.worst,
              " %, rms ", 100 * e.rms, " %");
      CHECK(e.worst < 0.015);
      CHECK(e.rms < 0.006);
    }
  }
}

TEST_CASE("geodesic__on_a_cylinder__the_helix") {
  constexpr double kRadius = 2, kHeight = 6;
  RandomStream random(2, 0);
  std::vector<Vec2> flat{{0, 1}};
  for (size_t i = 0; i < 80000; ++i)
    flat.push_back({2 * std::numbers::pi * random.uniform(), kHeight * random.uniform()});
  std::vector<Vec3> points;
  for (const Vec2& p : flat)
    points.push_back({kRadius * std::cos(p.u), kRadius * std::sin(p.u), p.v});
  for (const double cell_m : {0.2, 0.1}) {
    const auto found = geodesic(cloud_of(points), {0}, cell_m);
    const Error2 e = errors(found, cell_m, [&](size_t i) {
      const double a = std::min(flat[i].u, 2 * std::numbers::pi - flat[i].u);
      return std::hypot(kRadius * a, flat[i].v - 1);
    });
    MESSAGE("FIGURE geodesic, cylinder of radius 2 m, cell ", cell_m, ": largest error ",
            100 * e.worst, " %, rms ", 100 * e.rms, " %");
    CHECK(e.worst < 0.015);
    CHECK(e.rms < 0.006);
  }
}

TEST_CASE("geodesic__gaps_limits_and_several_seeds") {
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i)
    for (int j = 0; j < 20; ++j)
      if (i < 100 || i >= 120) points.push_back({0.05 * i + 0.013, 0.05 * j + 0.013, 0});
  const Cloud cloud = cloud_of(points);
  auto found = geodesic(cloud, {0}, 0.2);
  CHECK(found[0] == 0);
  CHECK(std::isnan(found.back()));  // beyond the gap of 1 m
  found = geodesic(cloud, {0, points.size() - 1}, 0.2);
  CHECK(found.back() == 0);
  found = geodesic(cloud, {0}, 0.2, 2.0);
  for (size_t i = 0; i < points.size(); ++i) CHECK(!(found[i] > 2.0));
  CHECK(status_of([&] { geodesic(cloud, {}, 0.2); }) == Status::kInsufficientData);
  CHECK(status_of([&] { geodesic(cloud, {points.size()}, 0.2); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { geodesic(cloud_of({{0, 0, 0}}), {0}, 0); }) == Status::kInsufficientData);
  CHECK(geodesic(cloud_of({{0, 0, 0}}), {0}, 1) == std::vector<double>{0});
}

TEST_CASE("geodesic__threads_and_a_shift_by_whole_metres__the_same_bits") {
  std::vector<Vec3> points = random_points(30000, 6, 4);
  for (Vec3& p : points) p.z = snapped(0.1 * std::sin(p.x));
  Task one(threads(1)), seven(threads(7));
  const GeodesicSettings set{};
  const std::vector<uint64_t> seeds{5, 700};
  const Cloud a = with_geodesic_distance(cloud_of(points), seeds, set, one);
  CHECK(same_bits(a, with_geodesic_distance(cloud_of(points), seeds, set, seven)));
  CHECK(same_fields(a, with_geodesic_distance(cloud_of(shifted(points, kFar)), seeds, set, one)));
}

}  // namespace
}  // namespace jalon
