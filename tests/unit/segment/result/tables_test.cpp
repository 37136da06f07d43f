// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/result/tables.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace jalon;

TEST_CASE("segment_table__each_type_has_its_own_columns_and_NaN_in_the_others") {
  Segmentation s;
  s.segments.resize(3);
  Segment &plane = s.segments[0], &sphere = s.segments[1], &cylinder = s.segments[2];
  plane.label = 1;
  plane.source_label = 42;
  plane.orientation = Orientation::kVertical;
  plane.fit.plane = {{0, 1, 0}, 7};
  plane.fit.n = 100;
  plane.front_source = FrontSource::kEvidence;
  plane.front_confidence = 0.75;
  plane.fit.covariance[15] = 0.25;
  sphere.label = 2;
  sphere.type = PrimitiveType::kSphere;
  sphere.sphere.sphere = {{1, 2, 3}, 0.5};
  sphere.sphere.n = 80;
  sphere.sphere.covariance[15] = 0.125;
  cylinder.label = 3;
  cylinder.type = PrimitiveType::kCylinder;
  cylinder.cylinder.cylinder = {{4, 5, 6}, {0, 0, 1}, 0.3};
  cylinder.cylinder.covariance[48] = 0.5;
  CHECK(plane_count(s.segments) == 1);
  const FieldTable t = segment_table(s);
  const auto at = [&](const char* name, size_t row, uint32_t component = 0) {
    return t.require(name).number(row, component);
  };
  CHECK(at("source_label", 0) == 42);
  CHECK(at("source_label", 1) == 2);  // found by a method: its label
  CHECK(at("type", 2) == 3);
  CHECK(at("orientation", 0) == 2);
  CHECK(at("front_source", 0) == 2);
  CHECK(at("front_source", 1) == 0);
  CHECK(at("front_confidence", 0) == 0.75);
  CHECK(std::isnan(at("front_confidence", 2)));
  CHECK(at("inliers", 1) == 80);
  CHECK(at("normal", 0, 1) == 1);
  CHECK(std::isnan(at("normal", 1, 1)));
  CHECK(at("normal", 2, 2) == 1);
  CHECK(at("offset", 0) == 7);
  CHECK(std::isnan(at("offset", 2)));
  CHECK(at("centroid", 1, 2) == 3);
  CHECK(at("centroid", 2, 0) == 4);
  CHECK(std::isnan(at("radius", 0)));
  CHECK(at("radius", 1) == 0.5);
  CHECK(at("radius", 2) == 0.3);
  CHECK(at("covariance", 0, 15) == 0.25);
  CHECK(at("covariance", 1, 15) == 0.125);
  CHECK(std::isnan(at("covariance", 2, 15)));
  CHECK(at("cylinder_covariance", 2, 48) == 0.5);
  CHECK(std::isnan(at("cylinder_covariance", 0, 48)));
}

TEST_CASE("point_table__has_the_three_columns_of_the_points_without_copying_them") {
  Segmentation s;
  s.labels = make_column<uint32_t>({"label"}, std::vector<uint32_t>{0, 1});
  s.residuals = make_column<float>({"residual"}, std::vector<float>{0, 0.5f});
  s.orientations = make_column<uint8_t>({"orientation"}, std::vector<uint8_t>{0, 3});
  const FieldTable t = point_table(s);
  CHECK(&t.require("label") == s.labels.get());
  CHECK(&t.require("residual") == s.residuals.get());
  CHECK(&t.require("orientation") == s.orientations.get());
}
