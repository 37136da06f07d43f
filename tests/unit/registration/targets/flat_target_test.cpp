// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// One flat target, directly: what is asked for decides, and the centre stands relative to the place.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/targets/flat_target.h"
#include "unit/cloud/clouds.h"
#include "unit/registration/target_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kAcross_m = 0.2, kDisc_m = 0.05, kNoise_m = 0.001;

// A plate with a bright disc of 5 cm in its middle, 41 x 41 points.
Cloud plate_with_disc(const Transform& pose, const char* field, uint64_t seed) {
  RandomStream random(151, seed);
  std::vector<Vec3> points;
  std::vector<float> brightness;
  for (int i = -20; i <= 20; ++i)
    for (int k = -20; k <= 20; ++k) {
      const double u = (i + random.uniform() - 0.5) * kAcross_m / 41,
                   v = (k + random.uniform() - 0.5) * kAcross_m / 41;
      points.push_back(pose.point({u, v, kNoise_m * random.normal()}));
      const double value = std::hypot(u, v) < kDisc_m ? 180 : 50;
      brightness.push_back(static_cast<float>(value + 5 * random.normal()));
    }
  Cloud out = cloud_of(points);
  out.fields.set(make_column<float>({.name = field}, brightness));
  return out;
}

MeasuredTarget flat_at(const Cloud& cloud, const Vec3& place, const MeasuringSettings& settings) {
  Task task;
  return measure_flat(cloud, *cloud.octree(task), place, settings, task);
}

MeasuringSettings disc_settings(TargetPattern pattern = TargetPattern::kAutomatic) {
  MeasuringSettings out;
  out.size_m = 2 * kDisc_m;
  out.search_m = 0.14;
  out.tolerance_m = 0.005;
  out.pattern = pattern;
  return out;
}

}  // namespace

TEST_CASE("measure_flat__finds_a_disc_on_its_plate_wherever_it_was_looked_for") {
  for (uint64_t draw = 0; draw < 2; ++draw) {
    RandomStream random(152, draw);
    const Transform pose = any_motion(random);
    const Cloud cloud = plate_with_disc(pose, "intensity", draw);
    const Vec3 place = pose.point(within(0.02, random));
    const MeasuredTarget found = flat_at(cloud, place, disc_settings());
    REQUIRE(found.status == Status::kOk);
    CHECK(found.kind == TargetKind::kDisc);
    const Vec3 off = place + found.centre - pose.translation();
    // Three dimensions: 21.1 is passed once in ten thousand.
    CHECK(squared_length<3>(found.covariance, {off.x, off.y, off.z}) < 21.1);
    CHECK(std::abs(found.radius_m - kDisc_m) < 4 * found.radius_sigma_m);
    const Vec3 normal = pose.direction({0, 0, 1});
    // A plane of 10 cm through some 1300 points of 1 mm is level to 1e-3 / 0.05 / sqrt(1300).
    CHECK(norm(cross(found.normal, normal)) < 4 * kNoise_m / 0.05 / std::sqrt(1300.0));
    CHECK(found.sigma_m == doctest::Approx(kNoise_m).scale(0).epsilon(0.1));  // 4 / sqrt(2 n)
    const auto& c = found.covariance;
    const double along = normal.x * (c[0] * normal.x + 2 * c[1] * normal.y + 2 * c[2] * normal.z) +
                         normal.y * (c[4] * normal.y + 2 * c[5] * normal.z) +
                         c[8] * normal.z * normal.z;
    // The plane at its middle: the variance of a mean of as many points as lie around, 1000 to 1681.
    CHECK(along > 0.8 * kNoise_m * kNoise_m / 1681);
    CHECK(along < 1.5 * kNoise_m * kNoise_m / 1000);
  }
}

TEST_CASE("measure_flat__takes_the_pattern_that_was_asked_for_or_none") {
  const Transform pose = motion_about({}, {0.3, 0.2, 0.1}, {5, 6, 7});
  const Cloud cloud = plate_with_disc(pose, "intensity", 1);
  const Vec3 place = pose.translation();
  CHECK(flat_at(cloud, place, disc_settings(TargetPattern::kDisc)).status == Status::kOk);
  CHECK(flat_at(cloud, place, disc_settings(TargetPattern::kChecker)).status ==
        Status::kDegenerate);
  MeasuringSettings plate = disc_settings(TargetPattern::kPatch);
  plate.size_m = kAcross_m;
  plate.search_m = 0.2;
  const MeasuredTarget whole = flat_at(cloud, place, plate);
  REQUIRE(whole.status == Status::kOk);
  CHECK(whole.kind == TargetKind::kPatch);
  CHECK(static_cast<double>(whole.points) > 0.99 * 41 * 41);  // tips of its corners may come off
  CHECK(std::isnan(whole.radius_m));
  CHECK(norm(whole.centre) < kAcross_m / 41);  // its border is known to half the spacing either way
  plate.size_m = 3 * kAcross_m;                // too small for that by more than half
  CHECK(flat_at(cloud, place, plate).status == Status::kDegenerate);
}

TEST_CASE("measure_flat__reads_the_field_that_is_named") {
  const Cloud cloud = plate_with_disc({}, "reflectance", 2);
  MeasuringSettings settings = disc_settings(TargetPattern::kDisc);
  CHECK(flat_at(cloud, {}, settings).status == Status::kDegenerate);
  settings.intensity_field = "reflectance";
  const MeasuredTarget found = flat_at(cloud, {}, settings);
  REQUIRE(found.status == Status::kOk);
  const MeasuredTarget again = flat_at(cloud, {}, settings);
  CHECK(again.centre == found.centre);
  CHECK(again.covariance == found.covariance);
}

TEST_CASE("measure_flat__counts_the_points_where_there_are_too_few_and_needs_a_plane") {
  const Cloud cloud = plate_with_disc({}, "intensity", 3);
  MeasuringSettings settings = disc_settings();
  settings.search_m = 0.02;
  settings.min_points = 200;
  const MeasuredTarget few = flat_at(cloud, {}, settings);
  CHECK(few.status == Status::kInsufficientData);
  uint64_t near = 0;
  for (size_t i = 0; i < cloud.size(); ++i) near += norm(cloud.point(i)) <= 0.02;
  CHECK(few.points == near);
  std::vector<Vec3> line;
  for (int i = 0; i < 100; ++i) line.push_back({0.001 * i, 0.002 * i, 0});
  CHECK(flat_at(cloud_of(line), {0.05, 0.1, 0}, disc_settings()).status == Status::kDegenerate);
}
