// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <doctest/doctest.h>

#include "base/error.h"
#include "base/random.h"
#include "compare/changes/diagnosis.h"
#include "compare/changes/regions.h"
#include "report/pages/change_outlines.h"

using namespace jalon;

namespace {

// 10 x 10 m on a plane that rises towards x by 30 degrees; changed: a square of 3 m with a square hole of 1 m in it,
// and a thin line of points.
struct Scene {
  Comparison comparison;
  FieldTable points;
};

Vec3 on_plane(double u, double v, const Vec3& shift) {
  return shift + Vec3{u * std::cos(0.5), v, u * std::sin(0.5)};
}

Scene scene(const Vec3& shift = {}) {
  RandomStream random(3, 0);
  std::vector<double> distance;
  std::vector<Vec3> xyz;
  for (int i = 0; i < 60000; ++i) {
    const double u = 10 * random.uniform(), v = 10 * random.uniform();
    const bool in_hole = u > 3 && u < 4 && v > 3 && v < 4;
    xyz.push_back(on_plane(u, v, shift));
    distance.push_back(u > 2 && u < 5 && v > 2 && v < 5 && !in_hole ? 0.2 : 0);
  }
  for (int i = 0; i < 40; ++i) {
    xyz.push_back(on_plane(8, 6 + 0.02 * i, shift));
    distance.push_back(-0.1);
  }
  Buffer<double> buffer(3 * xyz.size());
  for (size_t i = 0; i < xyz.size(); ++i)
    for (int a = 0; a < 3; ++a) buffer[3 * i + static_cast<size_t>(a)] = xyz[i][a];
  Scene out;
  out.comparison.cloud = std::make_shared<const Cloud>(make_cloud(std::move(buffer)));
  out.comparison.points.set(
      make_column<double>({"distance", ElementType::kFloat64, 1, "m", ""}, distance));
  Task task;
  out.points = region_points_table(change_regions(out.comparison, {}, task));
  return out;
}

Model outlined(const Scene& s, const FieldTable* changes = nullptr) {
  Task task;
  return change_outlines({&s.comparison, &s.points}, {}, changes, {}, task);
}

}  // namespace

TEST_CASE("change_outlines__a_square_with_a_hole_is_one_face_with_two_rings") {
  const Model model = outlined(scene());
  validate(model);
  REQUIRE(model.faces.size() == 2);
  REQUIRE(model.parts.size() == 3);
  CHECK(model.parts[1].name == "region 1");
  CHECK(model.parts[1].part_class == "region");
  const Face& face = model.faces[0];
  CHECK(face.id == 1);
  CHECK(face.ring_count == 2);
  MESSAGE("FIGURE outline of a square of 9 m2 with a hole of 1 m2: " << face.area_m2 << " m2");
  CHECK(std::abs(face.area_m2 - 8) <
        0.4);  // it runs through the outermost points, and the hole through its rim
  CHECK(std::abs(std::abs(face.plane.normal.z) - std::cos(0.5)) < 1e-6);
  CHECK(face.plane.normal.z > 0);
  for (uint64_t c = 0; c < model.rings[0].count; ++c) {
    const Vec3& p = model.vertices[model.corners[c]];
    CHECK(std::abs(face.plane.distance(p)) < 1e-9);
  }
}

TEST_CASE("change_outlines__a_line_of_points_gets_the_box_around_it") {
  const Model model = outlined(scene());
  REQUIRE(model.faces.size() == 2);
  const Face& line = model.faces[1];
  CHECK(line.id == 2);
  CHECK(line.ring_count == 1);
  CHECK(line.area_m2 > 0.78 * 0.01);
  CHECK(line.area_m2 < 0.9 * 0.2);
}

TEST_CASE("change_outlines__on_a_national_grid_are_the_same_to_a_micrometre") {
  const Vec3 shift{652000, 6861000, 100};
  const Model here = outlined(scene()), there = outlined(scene(shift));
  REQUIRE(here.vertices.size() == there.vertices.size());
  double worst = 0;
  for (size_t i = 0; i < here.vertices.size(); ++i)
    worst = std::max(worst, norm(there.vertices[i] - shift - here.vertices[i]));
  CHECK(worst < 1e-6);
}

TEST_CASE("change_outlines__classes_come_from_the_changes_and_wrong_tables_are_refused") {
  Scene s = scene();
  const auto labels = s.points.require("region").values<uint32_t>();
  s.points.set(make_column<uint32_t>({"change", ElementType::kUint32, 1, "", ""},
                                     std::vector<uint32_t>(labels.begin(), labels.end())));
  FieldTable changes;
  changes.set(
      make_column<uint8_t>({"class", ElementType::kUint8, 1, "", ""}, std::vector<uint8_t>{1, 4}));
  const Model model = outlined(s, &changes);
  REQUIRE(model.parts.size() == 3);
  CHECK(model.parts[1].part_class == "appearance");
  CHECK(model.parts[1].name == "change 1 region 1");
  CHECK(model.parts[2].part_class == "displacement_after");
  FieldTable short_table;
  short_table.set(
      make_column<uint8_t>({"class", ElementType::kUint8, 1, "", ""}, std::vector<uint8_t>{1}));
  CHECK_THROWS_AS(outlined(s, &short_table), Error);
  s.points.set(make_column<uint32_t>({"region", ElementType::kUint32, 1, "", ""},
                                     std::vector<uint32_t>{1, 2}));
  CHECK_THROWS_AS(outlined(s), Error);
  s.points = {};
  CHECK_THROWS_AS(outlined(s), Error);
}
