// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Written OBJ files as a viewer reads them, that passes over the notes, and as the model that they were.
#include <doctest/doctest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "formats/obj/obj.h"
#include "unit/formats/house.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string obj_of(const Model& model, double chord_error_m = 0.001) {
  const Folder folder;
  Task task;
  WriteSettings settings;
  settings.chord_error_m = chord_error_m;
  write_obj(model, folder.file("a.obj"), settings, task);
  return slurp(folder.file("a.obj"));
}

Model back_from(const std::string& text) {
  const OpenedFile file(text);
  Task task;
  return read_obj(file, {}, task);
}

// What a viewer draws: vertices and the polygons of "f", without any of the library's readers.
struct Drawn {
  std::vector<Vec3> vertices;
  std::vector<std::vector<size_t>> polygons;

  explicit Drawn(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "v") {
        Vec3 p;
        words >> p.x >> p.y >> p.z;
        vertices.push_back(p);
      } else if (keyword == "f") {
        polygons.emplace_back();
        for (size_t corner = 0; words >> corner;) polygons.back().push_back(corner - 1);
      }
    }
  }
  // Twice the vector area of a polygon.
  Vec3 twice(size_t polygon) const {
    const std::vector<size_t>& ring = polygons[polygon];
    Vec3 sum;
    for (size_t i = 2; i < ring.size(); ++i)
      sum +=
          cross(vertices[ring[i - 1]] - vertices[ring[0]], vertices[ring[i]] - vertices[ring[0]]);
    return sum;
  }
};

Model flat_face(const std::vector<Vec3>& ring) {
  Model model;
  model.add_face({}, {ring});
  return model;
}

}  // namespace

TEST_CASE("obj_writer__convex_quadrangles_stay_and_others_become_triangles_of_the_same_area") {
  const Drawn square(obj_of(flat_face({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}})));
  REQUIRE(square.polygons.size() == 1);
  CHECK(square.polygons[0].size() == 4);
  const Drawn arrow(obj_of(flat_face({{0, 0, 0}, {4, 2, 0}, {0, 4, 0}, {1, 2, 0}})));
  REQUIRE(arrow.polygons.size() == 2);  // a reflex corner: fans of viewers would leave the polygon
  CHECK((arrow.twice(0) + arrow.twice(1)).z / 2 == doctest::Approx(6));
  CHECK(arrow.twice(0).z > 0);
  CHECK(arrow.twice(1).z > 0);
  std::vector<Vec3> star;  // turns left at every corner, and crosses itself
  for (int i = 0; i < 5; ++i) star.push_back({std::cos(2.5132741 * i), std::sin(2.5132741 * i), 0});
  CHECK(Drawn(obj_of(flat_face(star))).polygons.size() == 3);
}

TEST_CASE("obj_writer__a_viewer_draws_the_area_of_the_model_with_openings_open") {
  const Model house = House().model();
  double drawn = 0;
  const Drawn seen(obj_of(house, 1e-5));
  for (size_t f = 0; f < seen.polygons.size(); ++f) drawn += norm(seen.twice(f)) / 2;
  // Chords 1e-5 m from their arcs leave out at most that times their length: below 12 m of arcs in all.
  CHECK(std::fabs(drawn - face_area(house)) <= 12 * 1e-5);
  CHECK(seen.vertices[0] == house.vertices[0]);  // to the last bit
}

TEST_CASE(
    "obj_writer__solids_count_the_faces_that_stand_in_the_file_and_loose_triangles_keep_ids") {
  Model model = House().model();
  Face empty;
  empty.first_ring = model.rings.size();
  model.faces.insert(model.faces.begin() + 1, empty);  // a face without rings is not written
  model.solids[0].first_face += 1;
  model.triangles = {{0, 1, 2}, {1, 2, 3}, {2, 3, 0}};
  model.triangle_faces = {4000000000u, 5,
                          90};  // 5 is the roof's: its triangles are drawn as a face
  const Model back = back_from(obj_of(model));
  REQUIRE(back.faces.size() == model.faces.size() - 1);
  REQUIRE(back.solids.size() == 1);
  CHECK(back.solids[0].first_face == model.solids[0].first_face - 1);
  CHECK(back.solids[0].face_count == 6);
  for (uint64_t f = 0; f < 6; ++f)
    CHECK(back.parts[back.faces[back.solids[0].first_face + f].part].name == "sill 1");
  CHECK(back.triangles == std::vector<std::array<uint32_t, 3>>{{0, 1, 2}, {2, 3, 0}});
  CHECK(back.triangle_faces == std::vector<uint32_t>{4000000000u, 90});
}

TEST_CASE("obj_writer__names_are_one_word_and_an_impossible_model_leaves_the_old_file") {
  Model mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 0}};
  mesh.triangle_faces = {1, 0};
  mesh.parts.resize(2);
  mesh.parts[1].name = "a\nb #c\\";
  const std::string text = obj_of(mesh);
  CHECK(has_text(text, "g a_b__c_\nf 1 2 3\ng part_0\nf 3 2 1\n"));
  const Model back = back_from(text);
  CHECK(back.parts[back.triangle_faces[0]].name == "a_b__c_");

  const Folder folder;
  spill(folder.file("a.obj"), "old");
  Task task;
  mesh.triangles[1][2] = 3;
  const Failure failure = failure_of([&] { write_obj(mesh, folder.file("a.obj"), {}, task); });
  CHECK(failure.status == Status::kInvalidArgument);
  CHECK(has_text(failure.text, "triangle 1 names vertex 3 of 3"));
  CHECK(slurp(folder.file("a.obj")) == "old");
  CHECK(folder.entries() == 1);
}
