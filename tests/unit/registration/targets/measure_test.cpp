// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/measure.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <numbers>

#include "base/distributions.h"
#include "scan/scanner.h"
#include "scan/builder/builder.h"
#include "unit/registration/target_scenes.h"

namespace jalon {
namespace {

using namespace test;

constexpr double kRadius_m = 0.0725;  // the usual scanning sphere of 145 mm
const Vec3 kCentre{8, 0.3, 1.4};
const Vec3 kGrid{652000, 6861000, 0};

constexpr int kFlatDraws = 120;
int draws() { return std::getenv("JALON_SANITIZED") != nullptr ? 60 : 1000; }

/// Points and the rays that found them.
struct Rays {
  std::vector<Vec3> points;
  Vec3 eye;
};

// A sphere on a pole before a wall, as the virtual scanner sees it without noise.
Rays sphere_scan(double turn_rad, double step_rad) {
  Transform turned = motion_about(kCentre, {0.3, 0.2, turn_rad}, {});
  SceneBuilder ball(turned), rest(Transform{});
  ball.sphere(kCentre, kRadius_m, 480);
  Model model = ball.take();
  Rays out{{}, {0.01 * turn_rad, 0, 1.5}};
  ParamSet params("scanner static", static_scanner_rows());
  params.from_json(R"({"range_noise_m": 0, "angle_noise_rad": 0, "beam_rings": 0,
                       "horizontal_from_rad": 1.51, "horizontal_to_rad": 1.56, "vertical_from_rad": -0.035,
                       "vertical_to_rad": 0.01})");
  auto settings = settings_from<StaticSettings>(params);
  settings.horizontal_step_rad = settings.vertical_step_rad = step_rad;
  const ScanStation station{"S", motion_about({}, {}, out.eye)};
  Task task;
  const Cloud cloud = scan_static(model, {&station, 1}, settings, task);
  for (size_t i = 0; i < cloud.size(); ++i) out.points.push_back(cloud.point(i));
  return out;
}

CloudPtr cloud_of(const std::vector<Vec3>& points, const std::vector<float>* intensity = nullptr) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (size_t k = 0; k < 3; ++k) xyz[3 * i + k] = points[i][static_cast<int>(k)];
  Cloud cloud = make_cloud(std::move(xyz));
  if (intensity != nullptr) cloud.fields.set(make_column<float>({.name = "intensity"}, *intensity));
  return std::make_shared<const Cloud>(std::move(cloud));
}

// Noise along the rays, a pole below and a wall behind, and points that belong to nothing.
CloudPtr noisy_scene(const Rays& rays, double noise_m, RandomStream& random) {
  std::vector<Vec3> points;
  for (const Vec3& p : rays.points)
    points.push_back(kGrid + p + noise_m * random.normal() * normalized(p - rays.eye));
  for (int i = 0; i < 150; ++i) {
    const double a = 2 * std::numbers::pi * random.uniform();
    const double below = kRadius_m + 0.2 * random.uniform();
    points.push_back(kGrid + kCentre + Vec3{0.015 * std::cos(a), 0.015 * std::sin(a), -below});
    points.push_back(kGrid + kCentre +
                     Vec3{0.15 + noise_m * random.normal(), 0.4 * random.uniform() - 0.2,
                          0.4 * random.uniform() - 0.2});
  }
  for (int i = 0; i < 30; ++i) points.push_back(kGrid + kCentre + within(0.15, random));
  return cloud_of(points);
}

MeasuringSettings settings_of(const char* json) {
  ParamSet params("target", target_rows());
  params.from_json(json);
  return settings_from<MeasuringSettings>(params);
}

FieldTable measured(const CloudPtr& cloud, const Vec3& place, const char* json) {
  Task task;
  return measure_targets(*cloud, {&place, 1}, settings_of(json), task);
}

Vec3 centre_of(const FieldTable& table) {
  const Column& c = table.require("centre");
  return {c.number(0, 0), c.number(0, 1), c.number(0, 2)};
}

double squared_miss(const FieldTable& table, const Vec3& truth) {
  const Vec3 e = centre_of(table) - truth;
  Square<3> covariance;
  for (uint32_t k = 0; k < 9; ++k) covariance[k] = table.require("covariance").number(0, k);
  return squared_length<3>(covariance, {e.x, e.y, e.z});
}

// Brightness of a pattern at a place of its plane, seen with a spot of this diameter.
using Brightness = double (*)(double u, double v);
double checker(double u, double v) { return (u > 0) == (v > 0) ? 220 : 30; }
double disc(double u, double v) { return u * u + v * v < 0.05 * 0.05 ? 200 : 60; }

CloudPtr flat_scene(Brightness brightness, double half_m, double spacing_m, double noise_m,
                    const Transform& pose, RandomStream& random) {
  std::vector<Vec3> points;
  std::vector<float> intensity;
  const double du = spacing_m * random.uniform(), dv = spacing_m * random.uniform();
  const double turn = random.uniform(), c = std::cos(turn), s = std::sin(turn);
  const int n = static_cast<int>(1.5 * half_m / spacing_m);
  for (int i = -n; i <= n; ++i)
    for (int k = -n; k <= n; ++k) {
      const double x = i * spacing_m + du, y = k * spacing_m + dv;
      const double u = c * x - s * y, v = s * x + c * y;
      if (std::max(std::fabs(u), std::fabs(v)) > half_m) continue;
      points.push_back(pose.point({u, v, noise_m * random.normal()}));
      if (brightness != nullptr)
        intensity.push_back(static_cast<float>(brightness(u, v) + 8 * random.normal()));
    }
  return cloud_of(points, brightness != nullptr ? &intensity : nullptr);
}

double figure_of(const char* what, int covered, int all, double squares_m2) {
  const double share = static_cast<double>(covered) / all;
  MESSAGE("FIGURE measured " << std::string(what) << ": 95 % ellipsoid covers " << 100 * share
                             << " %, rms " << 1000 * std::sqrt(squares_m2 / all) << " mm");
  return share;
}

}  // namespace

TEST_CASE("target_measure__spheres_of_the_virtual_scanner_lie_within_their_ellipsoids") {
  std::vector<Rays> scans;
  for (int i = 0; i < 4; ++i) scans.push_back(sphere_scan(0.4 * i, 0.0006 + 0.00003 * i));
  const double limit = chi_square_quantile(3, 0.95);
  for (const char* json : {R"({"radius_m": 0.0725})", R"({"search_m": 0.2})"}) {
    int covered = 0;
    double squares = 0;
    for (int draw = 0; draw < draws(); ++draw) {
      RandomStream random(51, static_cast<uint64_t>(draw));
      const CloudPtr cloud = noisy_scene(scans[static_cast<size_t>(draw % 4)], 0.002, random);
      const FieldTable found = measured(cloud, kGrid + kCentre + within(0.04, random), json);
      REQUIRE(found.require("status").number(0) == 0);
      covered += squared_miss(found, kGrid + kCentre) <= limit;
      squares += squared_norm(centre_of(found) - kGrid - kCentre);
    }
    const double share =
        figure_of(json[2] == 'r' ? "spheres, radius given" : "spheres, radius free", covered,
                  draws(), squares);
    CHECK(share >= (draws() == 1000 ? 0.93 : 0.85));
    CHECK(share <= (draws() == 1000 ? 0.97 : 1.0));
  }
}

TEST_CASE("target_measure__finds_checkers_and_discs_by_their_brightness") {
  const double limit = chi_square_quantile(3, 0.95);
  for (const Brightness brightness : {checker, disc}) {
    const bool is_checker = brightness == checker;
    int covered = 0;
    double squares = 0;
    for (int draw = 0; draw < kFlatDraws; ++draw) {
      RandomStream random(52, static_cast<uint64_t>(draw));
      Transform pose = any_motion(random);
      const CloudPtr cloud = flat_scene(brightness, 0.2, 0.004, 0.002, pose, random);
      const FieldTable found =
          measured(cloud, pose.point(within(0.03, random)),
                   is_checker ? R"({"kind": "flat", "size_m": 0.3, "search_m": 0.2})"
                              : R"({"kind": "flat", "size_m": 0.1})");
      REQUIRE(found.require("status").number(0) == 0);
      REQUIRE(found.require("kind").number(0) == (is_checker ? 2 : 3));
      covered += squared_miss(found, pose.translation()) <= limit;
      squares += squared_norm(centre_of(found) - pose.translation());
    }
    // A grid of points tells a sharp edge better than points at random, which the covariance takes them for: on the
    // safe side.
    CHECK(figure_of(is_checker ? "checkers" : "discs", covered, kFlatDraws, squares) >= 0.93);
    CHECK(squares / kFlatDraws < 0.0004 * 0.0004);  // a tenth of the spacing
  }
}

TEST_CASE("target_measure__takes_the_middle_of_a_plate_without_a_pattern") {
  for (uint64_t draw = 0; draw < 30; ++draw) {
    RandomStream random(53, draw);
    const Transform pose = any_motion(random);
    const CloudPtr cloud = flat_scene(nullptr, 0.1, 0.004, 0.001, pose, random);
    const FieldTable found =
        measured(cloud, pose.point(within(0.05, random)), R"({"kind": "flat", "size_m": 0.2})");
    REQUIRE(found.require("status").number(0) == 0);
    CHECK(found.require("kind").number(0) == 4);
    CHECK(norm(centre_of(found) - pose.translation()) < 0.002);
    CHECK(squared_miss(found, pose.translation()) < 16);
  }
}

TEST_CASE("target_measure__says_where_there_is_no_target") {
  RandomStream random(54, 0);
  const CloudPtr wall =
      flat_scene(nullptr, 0.6, 0.008, 0.002, motion_about({}, {0.4, 0, 0}, kGrid), random);
  for (const char* json : {R"({"radius_m": 0.0725})", "{}", R"({"kind": "flat"})",
                           R"({"kind": "flat", "pattern": "checker"})"}) {
    const FieldTable found = measured(wall, kGrid, json);
    CHECK(found.require("status").number(0) == static_cast<double>(Status::kDegenerate));
    CHECK(found.require("kind").number(0) == 0);
    CHECK(std::isnan(centre_of(found).x));
    CHECK(measured(wall, kGrid + Vec3{5, 5, 5}, json).require("status").number(0) ==
          static_cast<double>(Status::kInsufficientData));
  }
}

}  // namespace jalon
