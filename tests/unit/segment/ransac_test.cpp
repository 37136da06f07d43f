// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <numbers>

#include "base/error.h"
#include "unit/segment/method_checks.h"
#include "unit/segment/same_bits.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("ransac refuses clouds without area") {
  refuses_clouds_without_area([](const CloudPtr& cloud) { run(cloud, ransac_params()); });
}

TEST_CASE("ransac takes three points as a plane when asked, and no fewer than it was asked for") {
  const CloudPtr three = cloud_of({{0, 0, 2}, {1, 0, 2}, {0, 1, 2}});
  const auto planes = [&](const char* min_points) {
    const std::string json = std::string("{\"min_points\": ") + min_points +
                             ", \"min_area_m2\": 0, \"connectivity\": false}";
    return run(three, ransac_params(json.c_str()));
  };
  const Segmentation s = planes("3");
  REQUIRE(s.segments.size() == 1);
  CHECK(s.segments[0].fit.n == 3);
  CHECK(std::fabs(s.segments[0].fit.plane.normal.z) == doctest::Approx(1));
  CHECK(std::fabs(s.segments[0].fit.plane.offset) == doctest::Approx(2));
  for (const uint32_t label : s.labels->values<uint32_t>()) CHECK(label == 1);
  CHECK(planes("4").segments.empty());
}

TEST_CASE("ransac finds nothing in points scattered through a volume") {
  Scene scene;
  RandomStream random(11, 0);
  scene.outliers({0, 0, 0}, {10, 10, 10}, 50000, random);
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const Segmentation s = run(cloud_of(scene.points), ransac_params("{}", seed));
    CHECK(s.segments.empty());
    for (const uint32_t label : s.labels->values<uint32_t>()) REQUIRE(label == 0);
    CHECK(std::isnan(s.residuals->values<float>()[0]));
  }
}

TEST_CASE("ransac survives repeated points and a plane without noise") {
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 60; ++k)
      for (int copy = 0; copy < 3; ++copy) points.push_back({0.05 * i, 0.05 * k, 1});
  const Segmentation s = run(cloud_of(points), ransac_params());
  REQUIRE(s.segments.size() == 1);
  CHECK(s.segments[0].fit.n == points.size());
  CHECK(s.segments[0].fit.sigma < 1e-9);
  CHECK(s.segments[0].orientation == Orientation::kHorizontal);
}

TEST_CASE("ransac gives the same bits with 1, 2 and 7 threads") {
  const Scene scene = facade_scene(400, 3);
  const CloudPtr cloud = cloud_of(scene.points);
  const Segmentation one = run(cloud, ransac_params(), 1);
  CHECK(one.segments.size() >= 10);
  check_same(one, run(cloud, ransac_params(), 2), false);
  check_same(one, run(cloud, ransac_params(), 7), false);
}

TEST_CASE("ransac gives the same bits on a national grid") {
  const auto points = snapped(facade_scene(400, 4).points);
  const Vec3 shift{652000, 6861000, 35};
  const Segmentation here = run(cloud_of(points), ransac_params());
  const Segmentation there = run(cloud_of(points, shift), ransac_params());
  check_same(here, there, true);
  for (size_t i = 0; i < std::min(here.segments.size(), there.segments.size()); ++i) {
    const PlaneFit &a = here.segments[i].fit, &b = there.segments[i].fit;
    CHECK(norm(b.centroid - shift - a.centroid) < 2e-9);  // rounding of the world coordinate itself
    CHECK(std::fabs(b.plane.offset - dot(b.plane.normal, shift) - a.plane.offset) < 1e-8);
  }
}

TEST_CASE("an arbitrary shift changes next to nothing") {
  const Scene scene = facade_scene(600, 5);
  const Vec3 shift{652000.1234, 6861000.7071, 35.4321};
  const Segmentation here = run(cloud_of(scene.points), ransac_params());
  const Segmentation there = run(cloud_of(scene.points, shift), ransac_params());
  REQUIRE(here.segments.size() == there.segments.size());
  const auto a = here.labels->values<uint32_t>(), b = there.labels->values<uint32_t>();
  // Planes of the same size (the two panes) may change places in the table: follow each by its points.
  const size_t planes = here.segments.size();
  std::vector<std::vector<size_t>> shared(planes + 1, std::vector<size_t>(planes + 1, 0));
  for (size_t i = 0; i < a.size(); ++i) ++shared[a[i]][b[i]];
  size_t same = shared[0][0];
  double offset = 0, angle = 0;
  for (size_t i = 0; i < planes; ++i) {
    const auto& row = shared[i + 1];
    const auto twin =
        static_cast<size_t>(std::max_element(row.begin() + 1, row.end()) - row.begin());
    same += row[twin];
    const PlaneFit &p = here.segments[i].fit, &q = there.segments[twin - 1].fit;
    offset = std::max(offset, std::fabs(p.plane.distance(q.centroid - shift)));
    angle = std::max(angle, norm(cross(p.plane.normal, q.plane.normal)));
  }
  const size_t differ = a.size() - same;
  MESSAGE("labels that differ: " << differ << " of " << a.size() << ", offsets " << offset
                                 << " m, angles " << angle);
  CHECK(static_cast<double>(differ) <= 1e-4 * static_cast<double>(a.size()));
  CHECK(offset <= 1e-5);
}

TEST_CASE("ransac stops when cancelled") {
  const Scene scene = facade_scene(400, 3);
  std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  CHECK_THROWS_AS(segment_ransac(cloud_of(scene.points), ransac_params(), task), Error);
}

TEST_CASE("the facade frame puts the main facade parallel to OXZ, the station side at -Y") {
  const double angle = 37 * std::numbers::pi / 180;
  Scene scene = facade_scene(400, 6);
  for (Vec3& p : scene.points)
    p = {std::cos(angle) * p.x - std::sin(angle) * p.y + 1000,
         std::sin(angle) * p.x + std::cos(angle) * p.y + 500, p.z + 40};
  const Segmentation s = run(cloud_of(scene.points), ransac_params());
  // Without stations: what lies behind the wall (the panes) tells the front.
  uint32_t wall = 0;
  for (uint32_t label = 1; label <= s.segments.size(); ++label)
    if (overlap(scene, s, 1, label) > overlap(scene, s, 1, wall + 1)) wall = label - 1;
  const Vec3 n = s.T_facade_world.direction(s.segments[wall].fit.plane.normal);
  CHECK(n.y == doctest::Approx(-1).epsilon(1e-6));
  CHECK(s.T_facade_world.determinant() == doctest::Approx(1));
  CHECK(s.segments[wall].orientation == Orientation::kParallel);
  size_t classes[5] = {};
  for (const Segment& segment : s.segments) ++classes[static_cast<size_t>(segment.orientation)];
  MESSAGE("parallel " << classes[1] << ", vertical " << classes[2] << ", horizontal " << classes[3]
                      << ", inclined " << classes[4]);
  CHECK(classes[1] >= 5);  // wall, two panes, cornice, box
  CHECK(classes[2] >= 4);
  CHECK(classes[3] >= 4);
  // A station in front decides where there is one.
  auto posed = std::make_shared<Cloud>(*s.cloud);
  Station station;
  station.has_pose = true;
  station.pose.m[3] = 1000 + std::cos(angle) * 5 + std::sin(angle) * 20;
  station.pose.m[7] = 500 + std::sin(angle) * 5 - std::cos(angle) * 20;
  station.pose.m[11] = 41.7;
  station.count = posed->size();
  posed->stations = {station};
  const Segmentation seen = run(posed, ransac_params());
  for (const Segment& segment : seen.segments)
    CHECK(segment.fit.plane.distance(station.pose.translation()) > 0);
}
