// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The triangles of parts, by their area and sources, and the bodies of a gauge, by their distances.
#include "compare/clearance/part_triangles.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "unit/compare/refusal.h"
#include "unit/solid/cube.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double area_of(const PartTriangles& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += norm(cross(surface.vertices[b] - surface.vertices[a],
                      surface.vertices[c] - surface.vertices[a])) /
           2;
  return sum;
}

void add_rectangle(Model& model, uint32_t part, double x, double width, double height) {
  Face face;
  face.part = part;
  face.id = 1000 + part;
  face.plane = {{0, 0, 1}, 0};
  model.add_face(face, {{{x, 0, 0}, {x + width, 0, 0}, {x + width, height, 0}, {x, height, 0}}});
}

/// Parts that stand before their parents: leaf 0 below 2, 2 below 3; 1 alone; and a loose triangle of 0.5 m2.
Model tree() {
  Model model;
  model.parts = {Part{"leaf", "w", 2}, Part{"other", "w"}, Part{"branch", "w", 3},
                 Part{"root", "w"}, Part{"bare", "w"}};
  add_rectangle(model, 0, 0, 1, 1);
  add_rectangle(model, 1, 2, 2, 1);
  add_rectangle(model, 2, 5, 4, 1);
  add_rectangle(model, 3, 10, 8, 1);
  const auto first = static_cast<uint32_t>(model.vertices.size());
  model.vertices.insert(model.vertices.end(), {{0, 5, 0}, {1, 5, 0}, {0, 6, 0}});
  model.triangles = {{first, first + 1, first + 2}};
  model.triangle_faces = {7};
  return model;
}

/// Cubes of 1 m, one a part, 2 m apart along x, as a mesh by part.
Model cubes(uint32_t count) {
  Cubes all;
  Model model;
  for (uint32_t i = 0; i < count; ++i) {
    all.add({2.0 * i, 0, 0}, 1);
    model.triangle_faces.resize(12 * (i + 1), i);
    model.parts.push_back(Part{"cube " + std::to_string(i), "w"});
  }
  model.vertices = all.vertices;
  model.triangles = all.triangles;
  return model;
}

}  // namespace

TEST_CASE("triangles_of_part__are_those_of_the_part_and_all_below_it_with_their_sources") {
  const Model model = tree();
  const double areas[] = {1, 2, 5, 13};
  for (uint32_t part = 0; part < 4; ++part) {
    const PartTriangles found = triangles_of_part(model, part, 0.001);
    CHECK(area_of(found) == doctest::Approx(areas[part]).epsilon(1e-15));
    REQUIRE(found.sources.size() == found.triangles.size());
    std::set<uint32_t> used;
    for (const auto& t : found.triangles) used.insert(t.begin(), t.end());
    CHECK(used.size() == found.vertices.size());
  }
  const PartTriangles branch = triangles_of_part(model, 2, 0.001);
  for (size_t t = 0; t < branch.triangles.size(); ++t) {
    const TriangleSource& source = branch.sources[t];
    const bool is_leaf = branch.vertices[branch.triangles[t][0]].x < 2;
    CHECK(source.part == (is_leaf ? 0U : 2U));
    CHECK(source.face == (is_leaf ? 0U : 2U));
    CHECK(source.triangle == kNoRow);
  }
  // The loose triangle belongs to the whole alone.
  const PartTriangles whole = triangles_of_part(model, kWholeModel, 0.001);
  CHECK(area_of(whole) == doctest::Approx(15.5).epsilon(1e-15));
  CHECK(whole.sources.back().triangle == 0);
  CHECK(whole.sources.back().face == kNoRow);
  CHECK(whole.sources.back().part == kNoRow);
}

TEST_CASE("triangles_of_part__take_arcs_to_the_chord_error_and_meshes_by_part") {
  Model disc;
  disc.parts = {Part{"disc", "plate"}};
  Face face;
  face.plane = {{0, 0, 1}, 0};
  disc.add_face(face, {{{-2, 0, 0}, {2, 0, 0}}});
  disc.sagittas = {2, 2};  // two half circles
  const double circle = 4 * std::numbers::pi;
  for (const double chord_m : {0.01, 0.0001}) {
    const double area = area_of(triangles_of_part(disc, 0, chord_m));
    CHECK(area < circle);
    CHECK(area > circle - 2 * 2 * std::numbers::pi * chord_m);  // the ring that chords leave
  }
  const PartTriangles one = triangles_of_part(cubes(3), 1, 0.001);
  CHECK(one.triangles.size() == 12);
  CHECK(one.vertices.size() == 8);
  for (size_t t = 0; t < 12; ++t) {
    CHECK(one.sources[t].part == 1);
    CHECK(one.sources[t].triangle == 12 + t);
  }
}

TEST_CASE("triangles_of_part__names_the_part_that_is_not_there_and_refuses_one_without_surface") {
  const Model model = tree();
  CHECK(refuses([&] { triangles_of_part(model, 5, 0.001); }, Status::kInvalidArgument,
                "no part 5; the model has 5"));
  CHECK(refuses([&] { triangles_of_part(model, 4, 0.001); }, Status::kInsufficientData,
                "no surface"));
  CHECK(refuses([&] { triangles_of_part(Model{}, kWholeModel, 0.001); }, Status::kInsufficientData,
                "no surface"));
  Model circle = model;  // parts that are below each other end
  circle.parts[3].parent = 0;
  CHECK(area_of(triangles_of_part(circle, 0, 0.001)) == doctest::Approx(13).epsilon(1e-15));
}

TEST_CASE("gauge_corners__are_those_of_each_part") {
  const auto corners = gauge_corners(cubes(3), 0.001);
  REQUIRE(corners.size() == 3);
  for (size_t i = 0; i < 3; ++i) {
    CHECK(corners[i].size() == 8);
    for (const Vec3& p : corners[i])
      CHECK(std::abs(p.x - 2.0 * static_cast<double>(i) - 0.5) == 0.5);
  }
  CHECK(gauge_corners(Model{}, 0.001).empty());
}

TEST_CASE("gauge_of_model__has_a_body_for_each_convex_part_and_names_one_that_is_not") {
  const auto pieces = gauge_of_model(cubes(3), 0.001);
  REQUIRE(pieces.size() == 3);
  for (uint32_t i = 0; i < 3; ++i) {
    CHECK(pieces[i].distance({2.0 * i + 0.5, 0.5, 0.5}).value == doctest::Approx(-0.5));
    CHECK(pieces[i].distance({2.0 * i + 0.5, 0.5, 3}).value == doctest::Approx(2));
  }
  Model two = cubes(2);
  for (uint32_t& part : two.triangle_faces) part = 1;  // both cubes are one part
  CHECK(refuses([&] { gauge_of_model(two, 0.001); }, Status::kInvalidArgument,
                "part 1 (cube 1) of the gauge is not convex"));
  Model mesh = cubes(1);
  mesh.parts.clear();
  CHECK(gauge_of_model(mesh, 0.001).size() == 1);
  Model flat;
  flat.parts = {Part{"plate", "w"}};
  add_rectangle(flat, 0, 0, 1, 1);
  CHECK(refuses([&] { gauge_of_model(flat, 0.001); }, Status::kDegenerate, ""));
  CHECK(refuses([&] { gauge_of_model(Model{}, 0.001); }, Status::kInsufficientData,
                "the gauge has no surface"));
}
