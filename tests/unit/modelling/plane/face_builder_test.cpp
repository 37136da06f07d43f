// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Vertices, rings and faces of a model, from places in a plane.
#include <doctest/doctest.h>

#include <numbers>

#include "modelling/plane/face_builder.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

TEST_CASE("face_builder__equal_places_are_one_vertex_and_depth_is_along_the_normal") {
  Model model;
  SharedVertices shared;
  PlaneVertices vertices(model, shared, street_frame(0.5));
  CHECK(vertices.find({1, 2}, 0) == kNoVertex);
  const uint32_t a = vertices.at({1, 2}), behind = vertices.at({1, 2}, -0.3);
  CHECK(a != behind);
  CHECK(vertices.at({1, 2}) == a);
  CHECK(vertices.find({1, 2}, -0.3) == behind);
  REQUIRE(model.vertices.size() == 2);
  CHECK(model.vertices[a] == Vec3{1, -0.5, 2});
  CHECK(norm(model.vertices[behind] - Vec3{1, -0.2, 2}) < 1e-15);
}

TEST_CASE("face_builder__a_shared_vertex_comes_once_with_the_first_plane_that_uses_it") {
  Model model;
  SharedVertices shared{{{1, 2, 3}, {4, 5, 6}}, {kNoVertex, kNoVertex}};
  PlaneVertices front(model, shared, street_frame()), side(model, shared, street_frame(1));
  front.share({0, 0}, 0);
  front.share({9, 9}, 1);
  side.share({7, 7}, 0);
  CHECK(model.vertices.empty());
  CHECK(front.find({0, 0}, 0) == kNoVertex);
  const uint32_t a = front.at({0, 0});
  CHECK(side.at({7, 7}) == a);
  CHECK(side.find({7, 7}, 0) == a);
  CHECK(model.vertices == std::vector<Vec3>{{1, 2, 3}});
  CHECK(front.at({0, 0}, -1) != a);  // only in the plane itself
  CHECK(shared.vertices[1] == kNoVertex);
}

TEST_CASE("face_builder__a_ring_turned_twice_is_itself_and_arcs_stay_between_their_corners") {
  Model model;
  SharedVertices shared;
  PlaneVertices vertices(model, shared, street_frame());
  VectorRing ring = rectangle({0, 0}, {2, 1});
  ring.edges[1].sagitta_m = 0.25;  // from (2, 0) to (2, 1)
  PartRing part = part_ring(vertices, ring);
  part.part = 5;
  const PartRing back = turned(part), again = turned(back);
  CHECK(back.part == 5);
  REQUIRE(back.corners.size() == 4);
  for (size_t i = 0; i < 4; ++i) {
    CHECK(again.corners[i].vertex == part.corners[i].vertex);
    CHECK(again.corners[i].sagitta_m == part.corners[i].sagitta_m);
    const bool is_arc = model.vertices[back.corners[i].vertex] == Vec3{2, 0, 1} &&
                        model.vertices[back.corners[(i + 1) % 4].vertex] == Vec3{2, 0, 0};
    CHECK(back.corners[i].sagitta_m == (is_arc ? 0.25 : 0));
  }
}

TEST_CASE("face_builder__a_faces_area_is_that_of_its_rings_with_their_arcs") {
  Model model;
  SharedVertices shared;
  PlaneVertices vertices(model, shared, street_frame());
  VectorRing outline = rectangle({0, 0}, {4, 3}), opening = hole({1, 1}, {2, 2});
  outline.edges[1].sagitta_m = 1.5;  // half a disc beside it
  Face front;
  front.plane = {{0, -1, 0}, 0};
  append_face(model, front, {part_ring(vertices, outline), part_ring(vertices, opening)});
  REQUIRE(model.faces.size() == 1);
  CHECK(model.faces[0].ring_count == 2);
  CHECK(model.faces[0].area_m2 == doctest::Approx(12 + std::numbers::pi * 2.25 / 2 - 1));
  Face back = front;
  back.plane = {{0, 1, 0}, 0};
  append_face(model, back,
              {turned(part_ring(vertices, outline)), turned(part_ring(vertices, opening))});
  CHECK(model.faces[1].area_m2 == doctest::Approx(model.faces[0].area_m2));
  CHECK(model.vertices.size() == 8);

  const uint32_t part = append_part(model, "wall", "wall", kNoParent, Evidence::kMeasured);
  append_polygon(model, part, {0, 1, 2, 3}, {0, -1, 0});
  CHECK(model.faces[2].area_m2 == doctest::Approx(12));
  CHECK(model.faces[2].plane.offset == 0);
  CHECK(model.parts[part].name == "wall");
  validate(model);
}
