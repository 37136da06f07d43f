// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Clearance of cubes from points and from each other, against distances read off their coordinates.
#include "compare/clearance/clearance.h"

#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"
#include "unit/solid/cube.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model cube_model(const Vec3& low, double edge) {
  const Cubes cube = Cubes().add(low, edge);
  Model model;
  model.vertices = cube.vertices;
  model.triangles = cube.triangles;
  model.triangle_faces.assign(cube.triangles.size(), 0);
  return model;
}

Model open_square() {
  Model model;
  model.parts = {Part{"plate", "plate"}};
  Face face;
  face.plane = {{0, 0, 1}, 0};
  model.add_face(face, {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}});
  return model;
}

ClearanceTables to_points(const Model& model, const std::vector<Vec3>& points,
                          const ClearanceSettings& settings = {}) {
  Task task;
  return clearance_to_cloud(model, kWholeModel, cloud_of(points), settings, task);
}

ClearanceTables to_model(const Model& model, const Model& other,
                         const ClearanceSettings& settings = {}) {
  Task task;
  return clearance_to_model(model, kWholeModel, other, kWholeModel, settings, task);
}

double number(const FieldTable& table, const char* name, size_t row = 0, uint32_t component = 0) {
  return table.require(name).number(row, component);
}

}  // namespace

TEST_CASE("clearance_to_cloud__tells_the_deepest_point_and_lists_what_is_near_or_inside") {
  const std::vector<Vec3> points = {
      {1, 1, 2.0625}, {1, 1, 1.75}, {9, 9, 9}, {1, 1.5, 1}, {2.125, 1, 1}};
  const ClearanceTables found = to_points(cube_model({0, 0, 0}, 2), points);
  CHECK(number(found.summary, "clearance") == -0.5);
  CHECK(number(found.summary, "depth") == 0.5);
  CHECK(number(found.summary, "point") == 3);
  CHECK(number(found.summary, "foot", 0, 1) == 2);
  CHECK(number(found.summary, "xyz", 0, 1) == 1.5);
  CHECK(number(found.summary, "interferes") == 1);
  CHECK(number(found.summary, "closed") == 1);
  CHECK(number(found.summary, "inside") == 2);
  CHECK(number(found.summary, "near") == 3);
  REQUIRE(found.near.require("point").count() == 3);
  const double clearances[] = {0.0625, -0.25, -0.5};
  for (size_t row = 0; row < 3; ++row)
    CHECK(number(found.near, "clearance", row) == clearances[row]);
  CHECK(number(found.near, "point", 2) == 3);
  CHECK(number(found.near, "triangle", 2) < 12);
}

TEST_CASE("clearance_to_cloud__of_an_open_surface_has_no_inside_and_names_its_face_and_part") {
  const ClearanceTables below = to_points(open_square(), {{1, 1, -0.25}});
  CHECK(number(below.summary, "clearance") == 0.25);
  CHECK(std::isnan(number(below.summary, "depth")));
  CHECK(number(below.summary, "closed") == 0);
  CHECK(number(below.summary, "interferes") == 0);
  CHECK(number(below.summary, "part") == 0);
  CHECK(number(below.summary, "face") == 0);
  CHECK(number(below.summary, "triangle") == static_cast<double>(kNoRow));
  CHECK(number(below.summary, "near") == 0);  // 0.1 m by default
  ClearanceSettings wide;
  wide.margin_m = 0.25;
  CHECK(number(to_points(open_square(), {{1, 1, -0.25}}, wide).summary, "near") == 1);
  CHECK(number(to_points(open_square(), {{1, 1, 0}}).summary, "interferes") == 1);
}

TEST_CASE("clearance_to_model__of_cubes_apart_touching_overlapping_and_one_in_the_other") {
  struct {
    Vec3 low;
    double edge, clearance, depth, interferes;
  } const rows[] = {{{2.5, 0.5, 0.5}, 1, 0.5, 0, 0},  // apart along x
                    {{2.75, 3, 1}, 1, 1.25, 0, 0},    // edge to edge: 3, 4, 5
                    {{2, 0.5, 0.5}, 1, 0, 0, 1},      // they share a piece of side
                    {{1.75, 0.5, 0.5}, 1, -0.25, 0.25, 1},
                    {{0.25, 0.5, 0.5}, 1, -0.75, 0.75, 1}};  // the middle of its far side
  for (const auto& row : rows) {
    const ClearanceTables found = to_model(cube_model({0, 0, 0}, 2), cube_model(row.low, row.edge));
    CHECK(number(found.summary, "interferes") == row.interferes);
    // In a convex body depth is exact to 1e-9 m.
    CHECK(number(found.summary, "clearance") == doctest::Approx(row.clearance).epsilon(1e-9));
    CHECK(number(found.summary, "depth") == doctest::Approx(row.depth).epsilon(1e-9));
    CHECK(number(found.summary, "closed") == 1);
    CHECK(number(found.summary, "other_closed") == 1);
  }
  const ClearanceTables apart = to_model(cube_model({0, 0, 0}, 2), cube_model({2.5, 0.5, 0.5}, 1));
  CHECK(number(apart.summary, "foot") == 2);
  CHECK(number(apart.summary, "xyz") == 2.5);
  CHECK(apart.near.require("clearance").count() == 0);
  CHECK(number(to_model(open_square(), cube_model({0, 0, 1}, 1)).summary, "closed") == 0);
}

TEST_CASE("clearance__refuses_an_empty_cloud_and_two_reference_systems") {
  Model here = open_square(), there = open_square();
  CHECK(refuses([&] { to_points(here, {}); }, Status::kInsufficientData, "no points"));
  here.crs = "EPSG:2154";
  CHECK(number(to_model(here, there).summary, "clearance") == 0);  // one does not tell its own
  there.crs = "EPSG:25832";
  const auto says = [&](const char* words) {
    return refuses([&] { to_model(here, there); }, Status::kInvalidArgument, words);
  };
  CHECK(says("EPSG:2154"));
  CHECK(says("EPSG:25832"));
  CHECK_NOTHROW(require_one_crs("a", "a"));
  CHECK(refuses([] { require_one_crs("a", "b"); }, Status::kInvalidArgument, "a and b"));
}
