// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/cloud_ellipsoids.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"

using namespace jalon;

TEST_CASE("cloud_ellipsoids__one_every_three_points__stand_around_them") {
  Buffer<double> xyz(3 * 7);
  std::fill(xyz.begin(), xyz.end(), 0);
  xyz[9] = 3, xyz[10] = 5, xyz[11] = 7;
  Cloud cloud = make_cloud(std::move(xyz));
  std::vector<float> c(6 * 7, 0);
  for (size_t i = 0; i < 7; ++i) c[6 * i] = 0.04f, c[6 * i + 3] = 0.01f, c[6 * i + 5] = 0.01f;
  c[6 * 6] = static_cast<float>(kNaN);  // the last of them has none
  cloud.fields.set(make_column<float>({"covariance", ElementType::kFloat32, 6, "m2", ""}, c));
  EllipsoidSettings settings;
  settings.every = 3, settings.fineness = 0, settings.scale = 2, settings.confidence = 0.95;
  Task task;
  const Model model = cloud_ellipsoids(cloud, settings, task);
  validate(model);
  CHECK(model.triangles.size() == 40);
  CHECK(model.triangle_faces[0] == 0);
  CHECK(model.triangle_faces[39] == 3);
  for (size_t v = 12; v < 24; ++v) {
    const Vec3 d = model.vertices[v] - Vec3{3, 5, 7};
    const double size = d.x * d.x / 0.04 + (d.y * d.y + d.z * d.z) / 0.01;
    CHECK(size == doctest::Approx(4 * 7.814728).epsilon(1e-5));  // chi-square of 3, 95 %
  }
  CHECK_THROWS_AS(cloud_ellipsoids(Cloud{}, settings, task), Error);
}
