// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "region_growing": degenerate clouds, bits, normals of the caller, cancel.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>

#include "base/error.h"
#include "unit/segment/method_checks.h"
#include "unit/segment/same_bits.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// The cloud with a field "normal": value(i) for point i.
template <class F>
CloudPtr with_normals(const std::vector<Vec3>& points, ElementType type, uint32_t components,
                      F&& value) {
  auto cloud = std::make_shared<Cloud>(*cloud_of(points));
  auto column =
      std::make_shared<Column>(FieldInfo{"normal", type, components, "", ""}, points.size());
  if (type == ElementType::kFloat64)
    for (size_t i = 0; i < points.size(); ++i)
      for (uint32_t k = 0; k < components; ++k)
        column->values<double>()[components * i + k] = value(i)[static_cast<int>(k)];
  cloud->fields.set(column);
  return cloud;
}

}  // namespace

TEST_CASE("growing refuses clouds without area") {
  refuses_clouds_without_area([](const CloudPtr& cloud) { grow(cloud); });
}

TEST_CASE("growing finds nothing in points scattered through a volume") {
  Scene scene;
  RandomStream random(11, 0);
  scene.outliers({0, 0, 0}, {10, 10, 10}, 50000, random);
  const Segmentation s = grow(cloud_of(scene.points));
  CHECK(s.segments.empty());
  for (const uint32_t label : s.labels->values<uint32_t>()) REQUIRE(label == 0);
  CHECK(std::isnan(s.residuals->values<float>()[0]));
}

TEST_CASE("growing survives repeated points and a plane without noise") {
  survives_repeated_points([](const CloudPtr& cloud) { return grow(cloud); });
}

TEST_CASE("growing gives the same bits with 1, 2 and 7 threads") {
  for (const size_t density : {400, 12000}) {  // the second is thinned
    const Scene scene = facade_scene(density, 3);
    const CloudPtr cloud = cloud_of(scene.points);
    const Segmentation one = grow(cloud, "{}", 1);
    CHECK(one.segments.size() >= 10);
    check_same(one, grow(cloud, "{}", 2), false);
    check_same(one, grow(cloud, "{}", 7), false);
  }
}

TEST_CASE("growing gives the same bits on a national grid") {
  const auto points = snapped(facade_scene(400, 4).points);
  check_same(grow(cloud_of(points)), grow(cloud_of(points, {652000, 6861000, 35})), true);
}

TEST_CASE("growing takes the caller's normals when told to, and refuses what is none") {
  Scene scene;
  RandomStream random(15, 0);
  scene.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, 4000, 0.002, random);
  const char* json = "{\"normals\": \"field\"}";
  const auto true_normal = [](size_t) { return Vec3{0, -2, 0}; };  // any length will do
  const auto wrong_normal = [](size_t) { return Vec3{1, 0, 0}; };
  const auto f64 = ElementType::kFloat64;
  CHECK(grow(with_normals(scene.points, f64, 3, true_normal), json).segments.size() == 1);
  CHECK(grow(with_normals(scene.points, f64, 3, wrong_normal), json).segments.empty());
  CHECK_THROWS_AS(grow(cloud_of(scene.points), json), Error);
  CHECK_THROWS_AS(grow(with_normals(scene.points, f64, 2, true_normal), json), Error);
  CHECK_THROWS_AS(grow(with_normals(scene.points, ElementType::kUint8, 3, true_normal), json),
                  Error);
}

TEST_CASE("growing is cancelled from outside") {
  const Scene scene = facade_scene(400, 3);
  std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  CHECK_THROWS_AS(segment_region_growing(cloud_of(scene.points), GrowingSettings{}, task), Error);
}
