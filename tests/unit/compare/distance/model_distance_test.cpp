// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "compare/distance/model_distance.h"

using namespace jalon;

namespace {

CloudPtr points_cloud_of(const std::vector<Vec3>& points) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int a = 0; a < 3; ++a) xyz[3 * i + static_cast<size_t>(a)] = points[i][a];
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

Comparison compared(const Model& model, const std::vector<Vec3>& points,
                    const DistanceSettings& settings = {}, unsigned threads = 0) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return compare_with_model(std::make_shared<const Model>(model), points_cloud_of(points), settings,
                            task);
}

std::vector<double> distances(const Comparison& made) {
  const auto values = made.points.require("distance").values<double>();
  return {values.begin(), values.end()};
}

double cell(const Comparison& made, const char* column, size_t row) {
  return made.points.require(column).number(row);
}

/// A wall of 10 x 3 m in the plane y = 0 that looks to -y, with a window of 2 x 1 m whose head is a half circle, and
/// the pane 0.2 m behind it as a part of its own.
Model wall() {
  Model model;
  model.parts = {Part{"wall", "wall"}, Part{"pane", "glass", 0}};
  Face face;
  face.plane = {{0, -1, 0}, 0};
  model.add_face(face, {{{0, 0, 0}, {10, 0, 0}, {10, 0, 3}, {0, 0, 3}},
                        {{4, 0, 1}, {4, 0, 1.5}, {6, 0, 1.5}, {6, 0, 1}}});
  model.sagittas.assign(model.corners.size(), 0);
  model.sagittas[5] = -1;  // clockwise over the head: the arc bulges upward, out of the window
  face.part = 1;
  face.plane.offset = -0.2;
  model.add_face(face, {{{4, 0.2, 1}, {6, 0.2, 1}, {6, 0.2, 2.5}, {4, 0.2, 2.5}}});
  return model;
}

Vec3 on_grid(RandomStream& random, double size) {
  const auto next = [&] { return std::nearbyint(random.uniform() * size * 0x1p20) * 0x1p-20; };
  const double x = next(), y = next(), z = next();
  return {x, y, z};
}

}  // namespace

TEST_CASE("model_distance__is_signed_names_face_and_part_and_sees_through_openings") {
  const std::vector<Vec3> points = {{1, -0.25, 1}, {1, 0.5, 1}, {5, -0.3, 1.2},
                                    {5, 0.1, 1.2}, {12, 0, 1},  {5, -2, 2.5}};
  const Comparison made = compared(wall(), points);
  const std::vector<double> d = distances(made);
  CHECK(d[0] == 0.25);
  CHECK(d[1] == -0.5);
  CHECK(
      d[2] ==
      doctest::Approx(std::hypot(0.3, 0.2)).epsilon(1e-14));  // the sill; the pane is 0.5 m behind
  CHECK(d[3] == doctest::Approx(0.1).epsilon(1e-14).scale(0));  // before the pane
  CHECK(d[4] == 2);
  CHECK(d[5] ==
        doctest::Approx(2).epsilon(1e-7).scale(0));  // at the crown of the arc, which is chords
  CHECK(cell(made, "face", 0) == 0);
  CHECK(cell(made, "face", 3) == 1);
  CHECK(cell(made, "part", 0) == 0);
  CHECK(cell(made, "part", 3) == 1);
  CHECK(cell(made, "side", 0) == 0);
  CHECK(cell(made, "side", 2) == 1);
  CHECK(cell(made, "triangle", 0) == kNoFace);
  DistanceSettings settings;
  settings.is_signed = false;
  settings.differences = true;
  const Comparison plain = compared(wall(), {{1, 0.5, 1}}, settings);
  CHECK(distances(plain)[0] == 0.5);
  CHECK(plain.points.find("side") == nullptr);
  CHECK(cell(plain, "difference_x", 0) == 0);
  CHECK(cell(plain, "difference_y", 0) == 0.5);
}

TEST_CASE("model_distance__takes_arcs_to_the_chord_error") {
  Model disc;  // two half circles of radius 2 m
  Face face;
  face.plane = {{0, 0, 1}, 0};
  disc.parts = {Part{"disc", "plate"}};
  disc.add_face(face, {{{-2, 0, 0}, {2, 0, 0}}});
  disc.sagittas = {2, 2};
  DistanceSettings settings;
  std::vector<Vec3> around;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * std::numbers::pi / 180;
    around.push_back({3 * std::cos(angle), 3 * std::sin(angle), 0});
  }
  for (const double error_m : {1e-4, 1e-3}) {
    settings.chord_error_m = error_m;
    double worst = 0;
    for (const double d : distances(compared(disc, around, settings)))
      worst = std::max(worst, std::abs(d) - 1);
    CHECK(worst <= error_m);
    CHECK(worst > error_m / 8);
  }
}

TEST_CASE("model_distance__judges_by_tolerance_in_all_and_part_by_part") {
  DistanceSettings settings;
  settings.tolerance_m = 0.05;
  settings.max_distance_m = 1;
  const Comparison made = compared(
      wall(), {{1, -0.05, 1}, {2, 0.03, 1}, {3, -0.5, 1}, {5, 0.19, 1.4}, {5, 40, 1}}, settings);
  const uint8_t expected[] = {1, 1, 0, 1, 2};
  for (size_t i = 0; i < 5; ++i) CHECK(cell(made, "within_tolerance", i) == expected[i]);
  CHECK(cell(made, "status", 4) == 4);
  CHECK(std::isnan(cell(made, "distance", 4)));
  CHECK(made.summary.require("compared").number(0) == 4);
  CHECK(made.summary.require("nothing_near").number(0) == 1);
  CHECK(made.summary.require("within_tolerance").number(0) == 3);
  CHECK(made.summary.require("tolerance_share").number(0) == 0.75);
  CHECK(made.summary.require("maximum_absolute").number(0) == 0.5);
  const FieldTable& parts = made.parts;
  CHECK(parts.require("points").number(0) == 3);
  CHECK(parts.require("points").number(1) == 1);
  CHECK(parts.require("minimum").number(0) == -0.03);
  CHECK(parts.require("maximum").number(0) == 0.5);
  CHECK(parts.require("mean").number(0) == doctest::Approx(0.52 / 3).epsilon(1e-14).scale(0));
  CHECK(parts.require("tolerance_share").number(0) == doctest::Approx(2.0 / 3).epsilon(1e-15));
  CHECK(std::isnan(parts.require("sigma").number(1)));
}

TEST_CASE("model_distance__counts_triangles_that_stand_for_no_face_and_not_those_that_do") {
  Model model = wall();
  const auto first = static_cast<uint32_t>(model.vertices.size());
  model.vertices.insert(model.vertices.end(),
                        {{0, -5, 0}, {10, -5, 0}, {0, -5, 3}, {0, 2, 0}, {10, 2, 0}, {0, 2, 3}});
  model.triangles = {{first, first + 1, first + 2}, {first + 3, first + 4, first + 5}};
  model.triangle_faces = {
      77, 0};  // the second says that it is the first face's; it is no surface of its own
  const Comparison made = compared(model, {{1, -4.5, 0.5}, {1, 1.9, 0.5}});
  CHECK(cell(made, "triangle", 0) == 0);
  CHECK(cell(made, "face", 0) == kNoFace);
  CHECK(cell(made, "part", 0) == kNoPart);
  CHECK(cell(made, "face", 1) == 0);
}

TEST_CASE("model_distance__without_surface_or_points_is_told") {
  CHECK_THROWS_AS(compared(Model{}, {{0, 0, 0}}), Error);
  CHECK_THROWS_AS(compared(wall(), {}), Error);
}

TEST_CASE("model_distance__same_bits_for_any_threads_and_whole_metre_shifts") {
  Model mesh;
  std::vector<Vec3> points;
  RandomStream random(3, 1);
  for (uint32_t t = 0; t < 20000; ++t) {
    const Vec3 a = on_grid(random, 32);
    mesh.vertices.insert(mesh.vertices.end(),
                         {a, a + on_grid(random, 0.5), a + on_grid(random, 0.5)});
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    mesh.triangle_faces.push_back(t);
    points.push_back(on_grid(random, 32));
  }
  const Comparison one = compared(mesh, points, {}, 1);
  const Vec3 by{652000, 6861000, 35};
  Model far_mesh = mesh;
  for (Vec3& v : far_mesh.vertices) v += by;
  std::vector<Vec3> far_points = points;
  for (Vec3& p : far_points) p += by;
  const Comparison others[] = {compared(mesh, points, {}, 2), compared(mesh, points, {}, 4),
                               compared(far_mesh, far_points)};
  for (const Comparison& other : others)
    for (const ColumnPtr& column : one.points) {
      const Column& again = other.points.require(column->info().name);
      REQUIRE(again.bytes() == column->bytes());
      CHECK(std::memcmp(again.raw(), column->raw(), column->bytes()) == 0);
    }
}
