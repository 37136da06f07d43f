// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("local_surface__normals_and_spacing_of_a_plane_and_none_among_scatter") {
  Scene scene;
  RandomStream random(1, 7);
  const Vec3 normal = normalized(Vec3{0, 3, 4});
  scene.rectangle(1, {0, 0, 0}, {4, 0, 0}, 3 * normalized(Vec3{0, 4, -3}), 12000, 0.003, random);
  scene.outliers({10, 0, 0}, {12, 2, 2}, 500, random);
  const MadeScene made(scene.points);
  size_t right = 0, known = 0;
  for (size_t p = 0; p < made.scene.size(); ++p) {
    const float* n = &made.scene.normals[3 * p];
    const bool has = !std::isnan(n[0]);
    if (scene.faces[made.point(p)] == 0) {
      known += has;
      continue;
    }
    right += has && std::fabs(dot({n[0], n[1], n[2]}, normal)) > 0.97;
    const auto spacing = static_cast<double>(made.scene.spacing[p]);
    CHECK(spacing > 0.3 * std::sqrt(1e-3));  // 1 000 points a square metre
    CHECK(spacing < 4 * std::sqrt(1e-3));
  }
  CHECK(right > 11000);
  CHECK(known < 50);
}

TEST_CASE("local_surface__field_normals_are_taken_as_they_are_and_nothing_else_is") {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  Cloud cloud = *cloud_of(points);
  const std::vector<double> normals{0, 0, 5, 3, 0, 4, 0, 0, 0, kNaN, 0, 1};
  cloud.fields.set(make_column<double>({"normal", ElementType::kFloat64, 3}, normals));
  Task task;
  SegmentScene scene = indexed_scene(cloud, {}, task);
  take_field_normals(scene, task);
  for (size_t p = 0; p < 4; ++p) {
    const uint32_t i = scene.order[p];
    const float* n = &scene.normals[3 * p];
    if (i == 0) CHECK(n[2] == 1);  // made a unit vector
    if (i == 1) CHECK(n[0] == doctest::Approx(0.6));
    if (i >= 2) CHECK(std::isnan(n[0]));  // zero and NaN are unknown
  }
  cloud.fields.set(make_column<double>({"normal"}, std::vector<double>{1, 2, 3, 4}));
  SegmentScene other = indexed_scene(cloud, {}, task);
  CHECK_THROWS_AS(take_field_normals(other, task), Error);
}
