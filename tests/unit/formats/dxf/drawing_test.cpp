// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Layers against the names that release 12 takes, drawings against the models they show.
#include "formats/dxf/drawing.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Part drawn_part(const std::string& part_class, uint64_t parent = kNoParent) {
  Part part;
  part.part_class = part_class;
  part.parent = parent;
  return part;
}

/// An upright square of this side that looks to this horizontal direction.
Face add_square(Model& model, double side_m, const Vec3& towards, uint32_t part = 0) {
  Face face;
  face.part = part;
  face.id = static_cast<uint32_t>(100 + model.faces.size());
  face.plane.normal = towards;
  face.area_m2 = side_m * side_m;
  const Vec3 right = side_m * cross({0, 0, 1}, towards), up{0, 0, side_m}, foot{30, 40, 50};
  model.add_face(face, {{foot, foot + right, foot + right + up, foot + up}});
  return face;
}

}  // namespace

TEST_CASE("dxf_layers__a_class_has_one_layer_of_a_name_that_release_12_takes") {
  dxf::Layers layers;
  REQUIRE(layers.all().size() == 1);
  CHECK(layers.all()[0].name == "0");
  Model model;
  model.parts = {drawn_part("window"), drawn_part("window"), drawn_part("no_data")};
  model.parts[1].evidence = Evidence::kCopied;
  const uint32_t window = layers.of_part(model, 0), copy = layers.of_part(model, 1),
                 shadow = layers.of_part(model, 2);
  CHECK(window == layers.of_class("window"));
  CHECK(copy == layers.of_class("window", true));
  CHECK(layers.of_part(model, 3) == layers.of_class("element"));
  CHECK(std::set{0u, window, copy, shadow}.size() == 4);
  CHECK(layers.all()[copy].name == layers.all()[window].name + "-COPIED");
  CHECK(layers.all()[copy].colour == layers.all()[window].colour);
  CHECK_FALSE(layers.all()[window].dashed);
  CHECK(layers.all()[copy].dashed);
  CHECK(layers.all()[shadow].dashed);
  const auto colour = [&](const char* name) { return layers.all()[layers.of_class(name)].colour; };
  CHECK(colour("displacement_before") == colour("displacement"));
  CHECK(colour("displacement") != colour("appearance"));
  for (const std::string& hostile : {std::string(), std::string("a b\n<>"), std::string(90, 'y'),
                                     std::string("\xC3\xA9t\xC3\xA9")})
    for (const bool copied : {false, true}) {
      const std::string& name = layers.all()[layers.of_class(hostile, copied)].name;
      CHECK(!name.empty());
      CHECK(name.size() <= 31);
      CHECK(name.ends_with("-COPIED") == copied);
      CHECK(name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos);
    }
}

TEST_CASE("dxf_layers__no_two_have_the_same_name_also_where_a_class_is_called_like_one") {
  dxf::Layers layers;
  CHECK(layers.of_class("0") == 0);
  for (const char* part_class : {"0", "wall", "WALL", "a b", "a_b", "", "element", "wall-copied"})
    for (const bool copied : {false, true}) layers.of_class(part_class, copied);
  std::set<std::string> names;
  for (const dxf::Layer& layer : layers.all()) {
    CAPTURE(layer.name);
    CHECK(names.insert(layer.name).second);
  }
}

TEST_CASE("dxf_drawing__shows_every_ring_once_and_the_triangles_that_no_face_stands_for") {
  Model model = House().model();
  const auto far = static_cast<uint32_t>(model.vertices.size());
  model.vertices.push_back(model.vertices[0] + Vec3{0, 0, 500});
  model.vertices.push_back(model.vertices[0] + Vec3{0, 0, 900});  // nothing is there
  model.triangles = {{0, 1, 2}, {0, 1, far}};
  model.triangle_faces = {model.faces[0].id, 999};
  Task task;
  const dxf::Drawing drawing = dxf::draw_world(model, task);
  REQUIRE(drawing.polylines.size() == model.rings.size());
  for (const Face& face : model.faces)
    for (uint64_t r = 0; r < face.ring_count; ++r) {
      const Ring& ring = model.rings[face.first_ring + r];
      const dxf::Polyline& line = drawing.polylines[face.first_ring + r];
      CHECK(line.face_id == face.id);
      CHECK(line.part == (r == 0 ? face.part : ring.part));
      REQUIRE(line.corners.size() == ring.count);
      for (uint64_t c = 0; c < ring.count; ++c) {
        CHECK(line.corners[c] == model.vertices[model.corners[ring.first + c]]);
        if (!line.sagittas_m.empty()) CHECK(line.sagittas_m[c] == model.sagitta(ring.first + c));
        else CHECK(model.sagitta(ring.first + c) == 0);
      }
    }
  CHECK(drawing.triangles == std::vector<std::array<uint32_t, 3>>{{0, 1, far}});
  CHECK(drawing.layers.all()[drawing.triangle_layers.at(0)].name == "MESH");
  Box3 box;
  for (size_t v = 0; v <= far; ++v) box.add(model.vertices[v]);
  CHECK(drawing.box.min == box.min);
  CHECK(drawing.box.max == box.max);
}

TEST_CASE("dxf_drawing__looks_at_the_largest_upright_face_and_numbers_change_regions") {
  const Vec3 towards = normalized({3, -4, 0});
  Model model;
  model.parts = {drawn_part("wall"), drawn_part("changes"), drawn_part("displacement", 1)};
  add_square(model, 2, {1, 0, 0});
  const Face region = add_square(model, 4, towards, 2);
  add_square(model, 3, {0, 1, 0});
  Face ground;
  ground.area_m2 = 1000;
  ground.plane.normal = {0, 0, 1};
  model.add_face(ground, {{{0, 0, 0}, {40, 0, 0}, {40, 25, 0}, {0, 25, 0}}});
  Task task;
  const dxf::Drawing drawing = dxf::draw_world(model, task);
  CHECK(norm(drawing.view_direction - towards) < 1e-15);
  REQUIRE(drawing.labels.size() == 1);  // the wall and the ground are no changes
  CHECK(drawing.labels[0].text == std::to_string(region.id));
  CHECK(norm(drawing.labels[0].normal - towards) < 1e-15);
  CHECK(drawing.labels[0].height_m == doctest::Approx(1));  // three digits fit in a square of 4 m
  Vec3 middle;
  for (size_t c = 4; c < 8; ++c) middle += 0.25 * model.vertices[c];
  CHECK(norm(drawing.labels[0].at - middle) < 1e-12);
  Model flat;
  flat.add_face(ground, {{{0, 0, 0}, {40, 0, 0}, {40, 25, 0}}});
  CHECK(dxf::draw_world(flat, task).view_direction == Vec3{0, 0, 1});
  CHECK(dxf::draw_world(Model{}, task).box.empty());
}

TEST_CASE("dxf_drawing__rings_without_extent_or_normal_are_left_out") {
  Model model;
  Face face;
  face.plane.normal = {0, 0, 1};
  model.add_face(face, {{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {}});
  const auto lines = [&](uint64_t ring, const Vec3& normal) {
    dxf::Drawing drawing;
    dxf::add_ring(drawing, model, model.faces[0], ring, normal);
    return drawing.polylines;
  };
  CHECK(lines(0, {0, 0, 1}).empty());
  CHECK(lines(1, {0, 0, 1}).size() == 1);
  CHECK(lines(1, {0, 0, 0}).empty());
  CHECK(lines(2, {0, 0, 1}).empty());
  model.sagittas = {0.5, 0.5, NAN, 0, 0};
  REQUIRE(lines(0, {0, 0, 1}).size() == 1);  // two arcs make a circle
  CHECK(lines(0, {0, 0, 1})[0].sagittas_m == std::vector<double>{0.5, 0.5});
  CHECK(lines(1, {0, 0, 1})[0].sagittas_m.empty());  // a sagitta that is not known is straight
}
