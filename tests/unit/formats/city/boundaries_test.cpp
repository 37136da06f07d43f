// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Boundaries of geometries: cubes whose volume is known, a wall whose hole has known edges, lists with errors.
#include "formats/city/boundaries.h"

#include <doctest/doctest.h>

#include "unit/formats/city/json_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct BoundaryScene {
  Model model;
  city::Tree tree;
  city::Boundaries boundaries{model, tree};
  std::vector<uint32_t> surfaces = {};

  uint32_t add_draft(bool is_opening = false, bool is_closing = false) {
    city::Draft draft;
    draft.is_opening = is_opening;
    draft.is_closing = is_closing;
    surfaces.push_back(tree.add(std::move(draft)));
    return surfaces.back();
  }
  void add_box(double low, double high) {
    for (const double z : {low, high})
      for (const Vec3& p :
           {Vec3{low, low, z}, Vec3{high, low, z}, Vec3{high, high, z}, Vec3{low, high, z}})
        model.vertices.push_back(p);
  }
  /// The first draft is the object's.
  void take(const std::string& lists, int depth, const std::string& numbers = "") {
    JsonFile list_file(lists), number_file(numbers);
    const city::Piece list_piece = list_file.piece(), number_piece = number_file.piece();
    JsonCursor list_cursor = list_piece.cursor(), number_cursor = number_piece.cursor();
    boundaries.read(list_cursor, numbers.empty() ? nullptr : &number_cursor, depth, surfaces.at(0),
                    surfaces);
  }
  /// Gauss: a third of the flux of the position through the faces.
  double volume(const Solid& solid) const {
    double sum = 0;
    for (uint64_t f = 0; f < solid.face_count; ++f) {
      const Face& face = model.faces[solid.first_face + f];
      sum += face.plane.offset * face.area_m2 / 3;
    }
    return sum;
  }
};

/// The six sides of a box of eight vertices, seen from outside or from inside.
std::string shell(int first, bool inward = false) {
  constexpr int kSides[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::string out;
  for (const auto& side : kSides) {
    std::string ring;
    for (size_t k = 0; k < 4; ++k)
      ring += (k == 0 ? "" : ",") + std::to_string(first + side[inward ? 3 - k : k]);
    out += (out.empty() ? "[[" : ",[[") + ring + "]]";
  }
  return "[" + out + "]";
}

}  // namespace

TEST_CASE("boundaries__shells_of_a_solid_enclose_its_volume_and_it_belongs_to_what_they_share") {
  BoundaryScene scene;
  for (int d = 0; d < 4; ++d) scene.add_draft();
  scene.add_box(0, 1);
  scene.add_box(0.25, 0.75);
  scene.add_box(2, 4);
  scene.take("[" + shell(0) + "," + shell(8, true) + "]", 1, "[[1,1,1,1,1,2],null]");
  scene.take("[[" + shell(16) + "],[" + shell(8) + "]]", 2, "[[[1,1,1,1,1,2]],[[3,1,1,1,1,2]]]");
  scene.take(shell(16), 0);
  REQUIRE(scene.model.solids.size() == 3);  // a list of surfaces is none
  CHECK(scene.model.faces.size() == 30);
  const double volumes[] = {1 - 0.125, 8, 0.125};  // with its cavity, and two more
  for (size_t s = 0; s < 3; ++s)
    CHECK(scene.volume(scene.model.solids[s]) == doctest::Approx(volumes[s]).epsilon(1e-12));
  scene.model.parts.resize(4);  // building; wall with a window; roof
  for (const size_t child : {1, 3}) scene.model.parts[child].parent = 0;
  scene.model.parts[2].parent = 1;
  scene.boundaries.finish({0, 1, 2, 3});
  CHECK(scene.model.solids[0].part == 0);  // the cavity belongs to the object
  CHECK(scene.model.solids[1].part == 1);  // wall and window
  CHECK(scene.model.solids[2].part == 0);  // roof, wall and window
}

TEST_CASE("boundaries__a_closing_surface_gives_the_hole_its_part_and_is_a_face_where_none_is") {
  BoundaryScene scene;
  const uint32_t wall = scene.add_draft(), window = scene.add_draft(true, true),
                 door = scene.add_draft(true, true), pane = scene.add_draft(true, false);
  for (const double at : {1.0, 3.0, 6.0})  // squares of side 1 from (at, at)
    for (const Vec3& p :
         {Vec3{at, 0, at}, Vec3{at + 1, 0, at}, Vec3{at + 1, 0, at + 1}, Vec3{at, 0, at + 1}})
      scene.model.vertices.push_back(p);
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{5, 0, 0}, Vec3{5, 0, 5}, Vec3{0, 0, 5}})
    scene.model.vertices.push_back(p);
  // The window's surface starts at another corner and runs the other way round than its hole.
  scene.take("[[[12,13,14,15],[0,3,2,1],[4,7,6,5]],[[2,3,0,1]],[[8,9,10,11]],[[4,5,6,7]]]", 0,
             "[0,1,2,3]");
  CHECK(scene.model.faces.size() == 2);  // the pane is a face as well as what fills its hole
  scene.boundaries.finish({10, 11, 12, 13});
  REQUIRE(scene.model.faces.size() == 3);
  CHECK(scene.model.faces[0].part == 10 + wall);
  CHECK(scene.model.faces[0].area_m2 == doctest::Approx(25 - 1 - 1));
  CHECK(scene.model.faces[1].part == 10 + pane);
  CHECK(scene.model.faces[2].part == 10 + door);  // it closes nothing
  CHECK(scene.model.rings[0].part == kNoPart);
  CHECK(scene.model.rings[1].part == 10 + window);
  CHECK(scene.model.rings[2].part == 10 + pane);
  CHECK(scene.boundaries.dropped() == 0);
}

TEST_CASE("boundaries__surfaces_without_area_are_counted_and_leave_nothing_behind") {
  BoundaryScene scene;
  scene.add_draft();
  scene.add_box(0, 1);
  scene.model.vertices.push_back({0.5, 0, 0});  // 8: on the edge from 0 to 1
  scene.take(
      "[[[0,1]], [[0,8,1]], [[0,0,1,1,0]], [[0,1,0,1]], [], [[4],[5,6,7]], "
      "[[0,0,1,2,2,3,0],[4,5]]]",
      0);
  CHECK(scene.boundaries.dropped() == 6);
  REQUIRE(scene.model.faces.size() == 1);
  CHECK(scene.model.faces[0].area_m2 == 1);
  CHECK(scene.model.faces[0].ring_count == 1);  // a hole of two corners is none
  CHECK(scene.model.rings.size() == 1);
  CHECK(scene.model.corners == std::vector<uint32_t>{0, 1, 2, 3});
}

TEST_CASE("boundaries__refuses_numbers_of_nothing_and_lists_of_other_lengths") {
  const auto refusal = [](const std::string& lists, int depth, const std::string& numbers) {
    BoundaryScene scene;
    scene.add_draft();
    scene.add_box(0, 1);
    const Failure failure = failure_of([&] { scene.take(lists, depth, numbers); });
    CHECK(failure.status == Status::kFormat);
    CHECK(failure.text.find("piece.json: offset ") != std::string::npos);
    return failure.text.substr(failure.text.rfind("CityJSON: "));
  };
  const std::string vertex = "CityJSON: the number of a vertex was expected";
  CHECK(refusal("[[[0,1,8]]]", 0, "") == vertex);
  CHECK(refusal("[[[0,1,-1]]]", 0, "") == vertex);
  const std::string surface = "CityJSON: the number of a semantic surface was expected";
  CHECK(refusal("[[[0,1,2]]]", 0, "[1]") == surface);
  CHECK(refusal("[[[0,1,2]]]", 0, "[-1]") == surface);
  CHECK(refusal("[[[0,1,2]],[[0,1,3]]]", 0, "[0]") ==
        "CityJSON: a semantic value for each surface was expected");
  CHECK(refusal("[[[0,1,2]]]", 0, "[0,null]") ==
        "CityJSON: no more semantic values than surfaces was expected");
  CHECK(refusal("[" + shell(0) + "," + shell(0) + "]", 1, "[null]") ==
        "CityJSON: a semantic value for each shell was expected");
  CHECK(refusal("[" + shell(0) + "]", 1, "[null,[]]") ==
        "CityJSON: no more semantic values than shells was expected");
}
