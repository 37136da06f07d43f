// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

template <class T>
Cloud with_field(size_t points, const char* name, const std::vector<T>& values,
                 const char* unit = "") {
  Cloud cloud = cloud_of(std::vector<Vec3>(points));
  const auto components = static_cast<uint32_t>(values.size() / points);
  cloud.fields.set(
      make_column<T>({name, element_type_of<T>(), components, unit, ""}, std::span(values)));
  return cloud;
}

ElementType appended_type(const Cloud& a, const Cloud& b) {
  Task task;
  return append(a, b, task).fields.require("f").info().type;
}

TEST_CASE("combine__appended_types_hold_the_values_of_both") {
  const Cloud u8 = with_field<uint8_t>(1, "f", {200}), i16 = with_field<int16_t>(1, "f", {-5}),
              f32 = with_field<float>(1, "f", {0.5f}), f64 = with_field<double>(1, "f", {1e300});
  CHECK(appended_type(u8, u8) == ElementType::kUint8);
  CHECK(appended_type(u8, i16) == ElementType::kInt64);
  CHECK(appended_type(f32, f32) == ElementType::kFloat32);
  CHECK(appended_type(i16, f32) == ElementType::kFloat64);
  CHECK(appended_type(f64, f32) == ElementType::kFloat64);
  Task task;
  const Cloud both = append(u8, i16, task);
  CHECK(both.fields.require("f").number(0) == 200);
  CHECK(both.fields.require("f").number(1) == -5);
}

TEST_CASE("combine__values_that_one_cloud_lacks_are_nan_or_0_on_either_side") {
  Task task;
  const Cloud real = with_field<float>(2, "r", {1, 2}), whole = with_field<int32_t>(1, "w", {7});
  const Cloud out = append(real, whole, task);
  const Column &r = out.fields.require("r"), &w = out.fields.require("w");
  CHECK(r.number(0) == 1);
  CHECK(r.number(1) == 2);
  CHECK(std::isnan(r.number(2)));
  CHECK(w.number(0) == 0);
  CHECK(w.number(1) == 0);
  CHECK(w.number(2) == 7);
}

TEST_CASE("combine__refuses_fields_of_two_shapes_or_units_and_takes_a_missing_unit") {
  Task task;
  const Cloud metres = with_field<float>(1, "f", {1}, "m"),
              feet = with_field<float>(1, "f", {1}, "ft"), bare = with_field<float>(1, "f", {1}),
              three = with_field<float>(1, "f", {1, 2, 3});
  CHECK(status_of([&] { append(metres, feet, task); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { append(bare, three, task); }) == Status::kInvalidArgument);
  CHECK(append(bare, metres, task).fields.require("f").info().unit == "m");
}

TEST_CASE("combine__normals_stay_square_to_their_surface_under_a_shear") {
  // Tangents of a plane, carried by the map, give the normal to expect.
  const Vec3 t1 = normalized(Vec3{1, 2, 0.5}), t2 = normalized(Vec3{-2, 1, 1});
  const Vec3 n = normalized(cross(t1, t2));
  const Transform shear{{2, 0.5, 0, 10, 0, 0.5, 0.25, 20, 0.125, 0, 3, 30}};
  const Cloud cloud = with_field<double>(1, "normal", {n.x, n.y, n.z});
  Task task;
  const Cloud moved = transformed(cloud, shear, task);
  const Column& out = moved.fields.require("normal");
  const Vec3 turned{out.number(0, 0), out.number(0, 1), out.number(0, 2)};
  CHECK(norm(turned) == doctest::Approx(1).epsilon(1e-12));
  CHECK(std::abs(dot(turned, shear.direction(t1))) < 1e-12);
  CHECK(std::abs(dot(turned, shear.direction(t2))) < 1e-12);
  CHECK(dot(turned, shear.direction(n)) > 0);
}

TEST_CASE("combine__refuses_maps_that_flatten_space_or_leave_it") {
  Task task;
  const Cloud cloud = cloud_of({{1, 2, 3}, {1e308, 0, 0}});
  const Transform flat{{1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0}},
      twice{{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}}, nothing{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}};
  CHECK(status_of([&] { transformed(cloud, flat, task); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { transformed(cloud, nothing, task); }) == Status::kInvalidArgument);
  try {
    transformed(cloud, twice, task);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(std::string(error.what()).find("point 1 ") != std::string::npos);
  }
}

}  // namespace
}  // namespace jalon
