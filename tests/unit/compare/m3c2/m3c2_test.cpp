// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/m3c2.h"

#include <cstring>
#include <doctest/doctest.h>
#include <string>

#include "base/error.h"
#include "base/random.h"
#include "unit/compare/m3c2_slow.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kM3c2Noise = 0.003;  // m

CloudPtr m3c2_cloud_of(const std::vector<Vec3>& points) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int c = 0; c < 3; ++c) xyz[3 * i + static_cast<size_t>(c)] = points[i][c];
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

using S = M3c2Settings;

std::string m3c2_name_of(S::Position position) {
  return position == S::Position::kMedian ? "median" : "mean";
}

Comparison run(const CloudPtr& reference, const CloudPtr& compared, const S& settings = {},
               unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return compare_m3c2(reference, compared, settings, task);
}

std::span<const double> doubles(const Comparison& made, const char* name) {
  return made.points.require(name).values<double>();
}

/// A square of a plane through the middle of the cube [0, size]^3, with noise along its normal and moved along it.
std::vector<Vec3> plane(size_t n, double size, const Vec3& normal, double moved_m, uint64_t stream,
                        double outliers = 0) {
  RandomStream random(20130, stream);
  const Vec3 up = normalized(normal), u = normalized(cross(up, {0.3, 1, 0.2})), v = cross(up, u);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) {
    const double a = size * (random.uniform() - 0.5), b = size * (random.uniform() - 0.5);
    const bool stray = random.uniform() < outliers;
    const double noise = random.normal(), anywhere = random.uniform() - 0.5;
    const double t = stray ? 2 * anywhere : moved_m + kM3c2Noise * noise;
    p = Vec3{size, size, size} * 0.5 + a * u + b * v + t * up;
  }
  return points;
}

/// A pane with strays in front and a curtain 0.3 m behind, seen through it.
std::vector<Vec3> pane_and_curtain(size_t n, uint64_t stream) {
  RandomStream random(20131, stream);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) {
    const double x = 4 * random.uniform(), z = 3 * random.uniform(),
                 noise = kM3c2Noise * random.normal();
    const bool curtain = random.uniform() < 0.45;
    p = {x, curtain ? 0.3 + noise : noise, z};
    if (random.uniform() < 0.05) p.y = 2 * random.uniform() - 1;
  }
  return points;
}

struct Errors {
  double mean = 0, rms = 0;
  size_t count = 0;
};
Errors errors(const Comparison& made, double truth, double border_m, double size) {
  const auto distance = doubles(made, "distance");
  Errors e;
  for (size_t i = 0; i < made.cloud->size(); ++i) {
    const Vec3 p = made.cloud->point(i) - Vec3{size, size, size} * 0.5;
    if (norm(p) > size / 2 - border_m || std::isnan(distance[i])) continue;
    e.mean += distance[i] - truth;
    e.rms += (distance[i] - truth) * (distance[i] - truth);
    ++e.count;
  }
  const auto n = static_cast<double>(e.count);
  e.mean /= n;
  e.rms = std::sqrt(e.rms / n);
  return e;
}

}  // namespace

TEST_CASE("m3c2__finds_planted_displacements_within_three_tenths_of_a_millimetre") {
  for (const double moved_m : {0.005, 0.010, 0.020, -0.020}) {
    const Vec3 normal{0.4, -0.3, 0.8};
    const auto reference = m3c2_cloud_of(plane(8000, 4, normal, 0, 1));
    const auto compared = m3c2_cloud_of(plane(8000, 4, normal, moved_m, 2));
    for (const auto position : {S::Position::kMedian, S::Position::kMean}) {
      S s;
      s.position = position;
      s.core_spacing_m = 0.15;
      const Comparison made = run(reference, compared, s);
      const Errors e = errors(made, moved_m, 0.3, 4);
      MESSAGE("FIGURE " << m3c2_name_of(position) << " of " << 1000 * moved_m << " mm: " << e.count
                        << " core points, mean " << 1000 * e.mean << " mm off, RMS " << 1000 * e.rms
                        << " mm");
      CHECK(e.count > 300);
      CHECK(std::fabs(e.mean) < 0.0003);
      CHECK(e.rms < 0.0015);
    }
  }
}

TEST_CASE("m3c2__equals_a_slow_independent_implementation") {
  const auto reference = pane_and_curtain(6000, 1);
  auto compared = pane_and_curtain(6000, 2);
  for (Vec3& p : compared)
    if (p.x > 1) p.y += 0.01;
  std::vector<Vec3> core;
  for (size_t i = 0; i < 300; ++i) core.push_back(reference[20 * i] + Vec3{0.01, 0.002, -0.01});
  for (const bool median : {true, false}) {
    for (const bool nearest : {true, false}) {
      S s;
      s.position = median ? S::Position::kMedian : S::Position::kMean;
      s.surfaces = nearest ? S::Surfaces::kNearest : S::Surfaces::kAll;
      s.registration_error_m = 0.001;
      Task task;
      const Comparison made = compare_m3c2_core(m3c2_cloud_of(reference), m3c2_cloud_of(compared),
                                                m3c2_cloud_of(core), s, task);
      SlowM3c2 slow;
      slow.median = median;
      slow.gap_m = nearest ? slow.cylinder_radius_m / 3 : 0;
      slow.registration_error_m = 0.001;
      const auto distance = doubles(made, "distance"), lod = doubles(made, "lod"),
                 normal = doubles(made, "normal");
      double worst = 0;
      size_t count = 0;
      for (size_t i = 0; i < core.size(); ++i) {
        const auto truth = slow.at(reference, compared, core[i]);
        REQUIRE(truth.compared == !std::isnan(distance[i]));
        if (!truth.compared) continue;
        const Vec3 n{normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]};
        CHECK(norm(truth.normal - n) < 1e-9);
        ++count;
        worst = std::max(
            {worst, std::fabs(truth.distance_m - distance[i]), std::fabs(truth.lod_m - lod[i])});
        CHECK(made.points.require("count_reference").number(i) ==
              static_cast<double>(truth.count[0]));
        CHECK(made.points.require("count_compared").number(i) ==
              static_cast<double>(truth.count[1]));
      }
      MESSAGE("FIGURE worst difference of distance and level at "
              << count << " core points: " << worst << " m");
      CHECK(worst < 1e-9);
      CHECK(count > 250);
    }
  }
}

TEST_CASE("m3c2__medians_and_surfaces_stand_outliers_and_second_surfaces_that_ruin_means") {
  const auto reference = m3c2_cloud_of(pane_and_curtain(40000, 3)),
             compared = m3c2_cloud_of(pane_and_curtain(40000, 4));
  double rms[2];
  for (const bool robust : {true, false}) {
    S s;
    s.core_spacing_m = 0.1;
    if (!robust) {
      s.surfaces = S::Surfaces::kAll;
      s.position = S::Position::kMean;
    }
    s.orientation = S::Orientation::kPoint;
    s.viewpoint = {2, -20, 1.5};
    const Comparison made = run(reference, compared, s);
    const auto distance = doubles(made, "distance");
    double sum = 0;
    size_t count = 0, far = 0;
    for (size_t i = 0; i < made.cloud->size(); ++i) {
      const Vec3 q = made.cloud->point(i);
      const bool on_surface =
          std::fabs(q.y) < 3 * kM3c2Noise || std::fabs(q.y - 0.3) < 3 * kM3c2Noise;
      if (!on_surface || std::isnan(distance[i])) continue;
      sum += distance[i] * distance[i];
      far += std::fabs(distance[i]) > 0.01;
      ++count;
    }
    rms[robust] = std::sqrt(sum / static_cast<double>(count));
    MESSAGE("FIGURE " << (robust ? "medians of surfaces" : "means of all points") << ": RMS "
                      << 1000 * rms[robust] << " mm at " << count
                      << " core points where nothing moved, " << far << " of them beyond 10 mm");
    if (robust) CHECK(static_cast<double>(far) < 0.001 * static_cast<double>(count));
  }
  CHECK(rms[true] < 0.0017);
  CHECK(rms[false] > 0.01);
}

TEST_CASE("m3c2__gives_the_same_bits_for_any_number_of_threads_and_on_the_national_grid") {
  const auto snap = [](std::vector<Vec3> points, const Vec3& by) {
    for (Vec3& p : points)
      for (int c = 0; c < 3; ++c) p[c] = std::round(p[c] * 0x1p17) * 0x1p-17 + by[c];
    return m3c2_cloud_of(points);
  };
  const auto a = pane_and_curtain(20000, 5), b = pane_and_curtain(20000, 6);
  const Vec3 far{652000, 6861000, 120};
  S s;
  const double covariance_diagonal[] = {1e-8, 1e-8, 1e-8, 1e-6, 1e-6, 1e-6};
  s.registration_covariance.assign(36, 0.0);
  for (size_t i = 0; i < 6; ++i) s.registration_covariance[7 * i] = covariance_diagonal[i];
  s.registration_centre = {2, 0, 1};
  const Comparison one = run(snap(a, {}), snap(b, {}), s, 1),
                   three = run(snap(a, {}), snap(b, {}), s, 3);
  s.registration_centre = {2 + far.x, far.y, 1 + far.z};
  const Comparison away = run(snap(a, far), snap(b, far), s, 2);
  for (const ColumnPtr& column : one.points) {
    const Column& other = three.points.require(column->info().name);
    const Column& shifted = away.points.require(column->info().name);
    CHECK_MESSAGE(std::memcmp(column->raw(), other.raw(), column->bytes()) == 0,
                  column->info().name);
    CHECK_MESSAGE(std::memcmp(column->raw(), shifted.raw(), column->bytes()) == 0,
                  column->info().name);
  }
}

TEST_CASE("m3c2__says_why_a_core_point_has_no_distance") {
  auto reference = plane(4000, 4, {0, 0, 1}, 0, 7);
  reference.push_back({100, 100, 100});  // alone: no normal
  std::vector<Vec3> compared;
  for (const Vec3& p : plane(4000, 4, {0, 0, 1}, 0, 8))
    if (p.x < 2) compared.push_back(p);
  const Comparison made = run(m3c2_cloud_of(reference), m3c2_cloud_of(compared));
  const auto distance = doubles(made, "distance");
  const auto status = made.points.require("status").values<uint8_t>();
  for (size_t i = 0; i < reference.size(); ++i) {
    CHECK((status[i] == 0) == !std::isnan(distance[i]));
    if (reference[i].x > 2.16 && reference[i].x < 50) CHECK(status[i] == 4);
  }
  CHECK(status.back() == 5);
  CHECK(std::isnan(doubles(made, "normal")[3 * (reference.size() - 1)]));
  CHECK(made.summary.require("nothing_near").number(0) > 1000);
  // No overlap at all: a success that says so.
  std::vector<Vec3> elsewhere = compared;
  for (Vec3& p : elsewhere) p.x += 1000;
  const Comparison apart = run(m3c2_cloud_of(reference), m3c2_cloud_of(elsewhere));
  CHECK(apart.summary.require("compared").number(0) == 0);
  CHECK(std::isnan(apart.summary.require("mean").number(0)));
}

TEST_CASE("m3c2__normals_follow_their_mode_and_orientation") {
  const Vec3 slope = normalized({0.6, 0, 0.8});
  const auto points = plane(6000, 4, slope, 0, 9);
  Cloud with_pose = *m3c2_cloud_of(points);
  Station station;
  station.has_pose = true;
  station.pose.m[3] = -50;  // seen from below the slope
  station.pose.m[11] = -50;
  station.count = points.size();
  with_pose.stations = {station};
  const auto reference = std::make_shared<const Cloud>(with_pose);
  const auto normal_of_middle = [&](const S& settings) {
    Task task;
    const Comparison made =
        compare_m3c2_core(reference, reference, m3c2_cloud_of({{2, 2, 2}}), settings, task);
    const auto n = doubles(made, "normal");
    return Vec3{n[0], n[1], n[2]};
  };
  S s;
  CHECK(norm(normal_of_middle(s) + slope) < 0.01);  // automatic: toward the station
  s.orientation = S::Orientation::kDirection;
  CHECK(norm(normal_of_middle(s) - slope) < 0.01);
  s.orientation = S::Orientation::kPoint;
  s.viewpoint = {0, 0, -9};
  CHECK(norm(normal_of_middle(s) + slope) < 0.01);
  s.normals = S::Normals::kHorizontal;
  CHECK(norm(normal_of_middle(s) - Vec3{-1, 0, 0}) < 0.01);
  s.normals = S::Normals::kVertical;
  CHECK(normal_of_middle(s) == Vec3{0, 0, 1});
  s.normals = S::Normals::kGiven;
  CHECK_THROWS_AS(normal_of_middle(s), Error);
}

TEST_CASE("m3c2__several_scales_take_the_flattest") {
  // A floor with a step of 0.3 m: near it a small ball is flat and a large one is not.
  RandomStream random(3, 0);
  std::vector<Vec3> points;
  for (size_t i = 0; i < 20000; ++i) {
    const double x = 4 * random.uniform(), y = 4 * random.uniform();
    points.push_back({x, y, (x > 2 ? 0.3 : 0) + 0.001 * random.normal()});
  }
  const auto cloud = m3c2_cloud_of(points);
  const auto radius_at = [&](double x) {
    S s;
    s.normal_radii_m = {0.8, 0.2};
    Task task;
    const Comparison made = compare_m3c2_core(cloud, cloud, m3c2_cloud_of({{x, 2, 0}}), s, task);
    CHECK(doubles(made, "normal")[2] > 0.999);
    return doubles(made, "normal_radius")[0];
  };
  CHECK(radius_at(1.7) == 0.2);
  CHECK(radius_at(1.0) == 0.8);
}

TEST_CASE("m3c2__refuses_core_points_closer_than_a_micrometre") {
  const auto cloud = m3c2_cloud_of(plane(500, 1, {0, 0, 1}, 0, 1));
  S s;
  s.core_spacing_m = 1e-9;
  CHECK_THROWS_AS(run(cloud, cloud, s), Error);
  s.core_spacing_m = 0;
  CHECK(run(cloud, cloud, s).cloud->size() == 500);
}

TEST_CASE("m3c2__core_points_on_one_place_but_for_roundings_are_measured_once") {
  auto points = plane(3000, 1, {0.1, 0.2, 1}, 0, 41);
  auto moved = plane(3000, 1, {0.1, 0.2, 1}, 0.01, 42);
  const Vec3 middle{0.5, 0.5, 0.5};
  RandomStream random(43, 0);
  std::vector<Vec3> cores;
  for (int i = 0; i < 100; ++i)
    cores.push_back(middle + Vec3{0x1p-51 * static_cast<double>(random.below(8)), 0, 0});
  Task task;
  const Comparison made = compare_m3c2_core(m3c2_cloud_of(points), m3c2_cloud_of(moved),
                                            m3c2_cloud_of(cores), S{}, task);
  const auto distance = doubles(made, "distance"), lod = doubles(made, "lod");
  for (size_t i = 0; i < cores.size(); ++i) {
    CHECK(distance[i] ==
          distance[0]);  // the bits of one, not those of 100 that round their own way
    CHECK(lod[i] == lod[0]);
  }
  CHECK(std::fabs(distance[0] - 0.01) < 0.002);
}
