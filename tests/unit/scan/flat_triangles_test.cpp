// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/flat_triangles.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/scan/plates.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// One triangle in the plane z = height + slope * x.
void add_triangle(Model& model, double height, double slope, uint32_t id) {
  const auto first = static_cast<uint32_t>(model.vertices.size());
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}})
    model.vertices.push_back({x, y, height + slope * x});
  model.triangles.push_back({first, first + 1, first + 2});
  model.triangle_faces.push_back(id);
}

}  // namespace

TEST_CASE("flat_triangles__have_planes_relative_to_an_origin_of_whole_metres") {
  Model model;
  add_plate(model, 652000.25, 652001.25, 6861000.5, 6861002.5, 99.75);
  Task task;
  const FlatTriangles flats(model, task);
  REQUIRE(flats.size() == 2);
  CHECK(flats.origin() == Vec3{652000, 6861000, 99});
  for (uint32_t t = 0; t < 2; ++t) {
    CHECK(flats.is_flat(t));
    CHECK(flats.area(t) == doctest::Approx(1).epsilon(1e-12));
    CHECK(std::abs(flats.plane(t).normal.z) == doctest::Approx(1));
    for (size_t k = 0; k < 3; ++k) {
      CHECK(std::abs(flats.plane(t).distance(flats.corner(t, k))) < 1e-12);
      CHECK(flats.box(t).contains(flats.corner(t, k)));
    }
  }
}

TEST_CASE("flat_triangles__without_area_or_without_a_face_are_not_flat") {
  Model model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  model.triangles = {{0, 1, 2}, {0, 0, 3}, {0, 1, 3}, {0, 2, 3}};
  model.triangle_faces = {7, 7, 7, 8};
  Task task;
  const FlatTriangles mesh(model, task);
  CHECK_FALSE(mesh.is_flat(0));  // three corners on a line
  CHECK_FALSE(mesh.is_flat(1));  // one corner twice
  CHECK(mesh.is_flat(2));
  CHECK(mesh.is_flat(3));  // a bare mesh needs no face
  CHECK(mesh.face(3) == nullptr);

  Face face;
  face.id = 7;
  face.plane = {{0, 0, 1}, 0};
  model.add_face(face, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  const FlatTriangles with_face(model, task);
  CHECK(with_face.is_flat(2));
  CHECK(with_face.face(2) == &model.faces[0]);
  CHECK_FALSE(with_face.is_flat(3));  // its id is no face's: a curved surface
}

TEST_CASE("flat_triangles__take_the_plane_of_their_face_only_where_they_lie_in_it") {
  Model model;
  add_triangle(model, 0, 2e-6, 1);  // within 0.01 mm of the face's plane
  add_triangle(model, 0.5, 0, 1);   // parallel to it, half a metre away
  Face face;
  face.id = 1;
  face.plane = {{0, 0, 1}, 0};
  model.add_face(face, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  Task task;
  const FlatTriangles flats(model, task);
  CHECK(flats.plane(0).normal == Vec3{0, 0, 1});
  CHECK(flats.plane(0).offset == 0);
  CHECK(flats.plane(1).offset == doctest::Approx(0.5));
}

TEST_CASE("flat_triangles__are_coplanar_within_a_thousandth_of_a_degree_and_a_tenth_of_a_mm") {
  Model model;
  add_triangle(model, 0, 0, 1);
  add_triangle(model, 0.9e-4, 0, 2);                        // 0.09 mm above
  add_triangle(model, 1.1e-4, 0, 3);                        // 0.11 mm above
  add_triangle(model, 0, 0.9 * kSamePlane_rad, 4);          // turned by 0.0009 degrees
  add_triangle(model, 0, 1.1 * kSamePlane_rad, 5);          // turned by 0.0011 degrees
  std::swap(model.triangles[3][1], model.triangles[3][2]);  // its other side: still one plane
  Task task;
  const FlatTriangles flats(model, task);
  CHECK(flats.are_coplanar(0, 1));
  CHECK_FALSE(flats.are_coplanar(0, 2));
  CHECK(flats.are_coplanar(0, 3));
  CHECK_FALSE(flats.are_coplanar(0, 4));
  for (uint32_t a = 0; a < 5; ++a)
    for (uint32_t b = 0; b < 5; ++b) CHECK(flats.are_coplanar(a, b) == flats.are_coplanar(b, a));
}

TEST_CASE("flat_triangles__of_an_empty_model_are_none") {
  Task task;
  const Model model;
  const FlatTriangles flats(model, task);
  CHECK(flats.size() == 0);
  CHECK(flats.origin() == Vec3{});
}
