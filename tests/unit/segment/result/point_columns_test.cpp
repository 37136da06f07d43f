// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/result/point_columns.h"

#include <doctest/doctest.h>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("point_columns__signed_distance_and_class_of_the_own_surface_NaN_for_noise") {
  const Vec3 origin{652000, 6861000, 0};
  Segmentation s;
  s.cloud = cloud_of({{1, 2, 0.5}, {9, 9, 9}, {3, 0, 0}, {1, 2, -0.5}}, origin);
  const auto labels = make_label_column(4);
  const uint32_t wanted[] = {1, 0, 2, 1};
  std::copy(wanted, wanted + 4, labels->values<uint32_t>().begin());
  s.labels = labels;
  s.segments.resize(2);
  s.segments[0].fit.plane = {{0, 0, 1}, 0.25};
  s.segments[0].orientation = Orientation::kHorizontal;
  s.segments[1].type = PrimitiveType::kSphere;
  s.segments[1].sphere.sphere = {{0, 0, 0}, 2};
  Task task;
  add_point_columns(s, origin, task);
  const auto residual = s.residuals->values<float>();
  CHECK(residual[0] == 0.25f);
  CHECK(std::isnan(residual[1]));
  CHECK(residual[2] == 1);  // outside the sphere
  CHECK(residual[3] == -0.75f);
  const auto orientation = s.orientations->values<uint8_t>();
  const uint8_t expected[] = {3, 0, 0, 3};
  for (size_t i = 0; i < 4; ++i) CHECK(orientation[i] == expected[i]);
}
