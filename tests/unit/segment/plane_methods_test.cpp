// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What every method for planes must do, whatever its way to find them.
#include "unit/segment/plane_methods.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <numbers>

#include "unit/segment/method_checks.h"
#include "unit/segment/ramp.h"
#include "unit/segment/same_bits.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const char* const kPlaneMethods[] = {"ransac",   "region_growing",   "raster_growing",
                                     "profiles", "triangle_growing", "split_merge",
                                     "hough"};
constexpr double kPlaneDegree = std::numbers::pi / 180;

}  // namespace

TEST_CASE("plane_methods__refuse_clouds_without_area") {
  for (const char* method : kPlaneMethods) {
    CAPTURE(method);
    refuses_clouds_without_area([&](const CloudPtr& cloud) { segment_by(method, cloud); });
  }
}

TEST_CASE("plane_methods__survive_repeated_points_and_a_plane_without_noise") {
  for (const char* method : kPlaneMethods) {
    CAPTURE(method);
    survives_repeated_points([&](const CloudPtr& cloud) { return segment_by(method, cloud); });
  }
}

TEST_CASE("plane_methods__split_the_ramp_into_its_three_planes_exactly_without_noise") {
  const Scene scene = ramp(0, 1);
  for (const char* method : kPlaneMethods) {
    CAPTURE(method);
    const Segmentation s = segment_by(method, cloud_of(scene.points));
    const RampResult exact = judge_ramp(scene, s);
    CHECK(exact.angle_rad < 1e-6);
    CHECK(exact.wrong == 0);
    const std::array<double, 3> areas = ramp_areas(s, exact);
    CHECK(areas[0] == doctest::Approx(12).epsilon(1e-6));
    CHECK(areas[1] == doctest::Approx(6 * std::numbers::sqrt2).epsilon(1e-6));
    CHECK(areas[2] == doctest::Approx(12).epsilon(1e-6));
  }
}

TEST_CASE("plane_methods__split_the_ramp_with_5_mm_of_noise") {
  for (const char* method : kPlaneMethods) {
    CAPTURE(method);
    double angle = 0, wrong = 0;
    for (uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(seed);
      const Scene scene = ramp(0.005, seed);
      const RampResult r = judge_ramp(scene, segment_by(method, cloud_of(scene.points)));
      angle = std::max(angle, r.angle_rad);
      wrong =
          std::max(wrong, static_cast<double>(r.wrong) / static_cast<double>(scene.points.size()));
    }
    MESSAGE("FIGURE " << std::string(method) << ": ramp with 5 mm of noise, 20 seeds: "
                      << angle / kPlaneDegree << " degrees, " << 100 * wrong << " % wrong");
    CHECK(angle < 0.2 * kPlaneDegree);
    CHECK(wrong <= 0.02);
  }
}

// Twice as dense: a plane of profiles must show in three slices, and the ramp's 3 m are hardly three of its own.
TEST_CASE("plane_methods__split_the_ramp_however_it_is_turned") {
  for (const char* method : kPlaneMethods) {
    CAPTURE(method);
    RandomStream random(33, 0);
    for (int k = 0; k < 12; ++k) {
      const double yaw = 2 * std::numbers::pi * random.uniform();
      const double tilt = k % 2 == 0 ? 0 : std::numbers::pi * random.uniform();
      CAPTURE(yaw);
      CAPTURE(tilt);
      Scene scene = ramp(0.005, 100 + static_cast<uint64_t>(k), 2);
      for (Vec3& p : scene.points) {
        const Vec3 t{std::cos(tilt) * p.x + std::sin(tilt) * p.z, p.y,
                     std::cos(tilt) * p.z - std::sin(tilt) * p.x};
        p = {std::cos(yaw) * t.x - std::sin(yaw) * t.y, std::sin(yaw) * t.x + std::cos(yaw) * t.y,
             t.z};
      }
      const Segmentation s = segment_by(method, cloud_of(scene.points));
      REQUIRE(s.segments.size() == 3);
      for (int face = 1; face <= 3; ++face) CHECK(best_match(scene, s, face).share >= 0.95);
    }
  }
}

TEST_CASE("plane_methods__give_the_same_bits_with_1_2_and_7_threads") {
  const CloudPtr cloud = cloud_of(facade_scene(400, 3).points);
  for (const char* method : kPlaneMethods) {
    CAPTURE(method);
    const Segmentation one = segment_by(method, cloud, "{}", 1);
    CHECK(one.segments.size() >= 8);
    check_same(one, segment_by(method, cloud, "{}", 2), false);
    check_same(one, segment_by(method, cloud, "{}", 7), false);
  }
}

TEST_CASE("plane_methods__give_the_same_bits_on_a_national_grid") {
  const auto points = snapped(facade_scene(400, 4).points);
  for (const char* method : kPlaneMethods) {
    CAPTURE(method);
    check_same(segment_by(method, cloud_of(points)),
               segment_by(method, cloud_of(points, {652000, 6861000, 35})), true);
  }
}

TEST_CASE("plane_methods__find_the_planes_of_a_facade") {
  for (const char* method : kPlaneMethods) {
    size_t found = 0, planes = 0;
    for (uint64_t seed = 1; seed <= 3; ++seed) {
      const Scene scene = facade_scene(400, seed);
      const Segmentation s = segment_by(method, cloud_of(scene.points));
      planes += s.segments.size();
      for (int face = 1; face <= 18; ++face) found += best_match(scene, s, face).share > 0.7;
    }
    MESSAGE("FIGURE " << std::string(method) << ": " << found
                      << " of 54 planes of three facades, of " << planes << " found");
    CHECK(found >= 40);
    CHECK(planes <= 66);
  }
}

TEST_CASE("plane_methods__find_the_planes_of_a_facade_though_points_stray_kilometres_away") {
  Scene scene = spec_facade(0.05, 12);
  RandomStream random(12, 22);
  for (const double away_m : {1200.0, 5000.0, 5000.0, 20000.0}) {
    const Vec3 to = normalized({random.normal(), random.normal(), random.normal()});
    scene.points.push_back(to * away_m);
    scene.faces.push_back(0);
  }
  const CloudPtr cloud = cloud_of(scene.points);
  for (const char* method : kPlaneMethods) {
    INFO(std::string(method));
    const Segmentation s = segment_by(method, cloud);
    for (const int face : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})
      CHECK(best_match(scene, s, face).share > 0.8);
  }
}

TEST_CASE("plane_methods__find_the_planes_of_a_small_house_far_from_a_large_one") {
  Scene scene = spec_facade(0.04, 13);
  RandomStream random(13, 22);
  const Vec3 far{3000, 1000, 0};
  scene.rectangle(12, far, {2, 0, 0}, {0, 0, 1}, 1250, 0.003, random);
  scene.rectangle(13, far, {0, 2, 0}, {0, 0, 1}, 1250, 0.003, random);
  const CloudPtr cloud = cloud_of(scene.points);
  for (const char* method : kPlaneMethods) {
    INFO(std::string(method));
    const Segmentation s = segment_by(method, cloud);
    for (const int face : {1, 2, 7, 8, 9, 10, 11, 12, 13})
      CHECK(best_match(scene, s, face).share > 0.8);
  }
}

TEST_CASE("plane_methods__find_nothing_in_points_scattered_through_a_volume") {
  Scene scene;
  RandomStream random(11, 0);
  scene.outliers({0, 0, 0}, {10, 10, 10}, 50000, random);
  for (const char* method : kPlaneMethods) {
    CAPTURE(method);
    CHECK(segment_by(method, cloud_of(scene.points)).segments.empty());
  }
}

TEST_CASE("plane_methods__are_cancelled_from_outside") {
  const CloudPtr cloud = cloud_of(facade_scene(100, 3).points);
  for (const SegmentMethod& method : segment_methods()) {
    std::atomic<bool> cancel{true};
    Task::Hooks hooks;
    hooks.cancel = &cancel;
    Task task(hooks);
    CAPTURE(method.name);
    CHECK_THROWS_AS(method.run(cloud, ParamSet(method.owner, method.rows()), task), Error);
  }
}
