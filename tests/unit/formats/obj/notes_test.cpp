// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Notes of OBJ files: what was written comes back, and what does not fit together is refused.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "formats/face_geometry.h"
#include "formats/obj/notes.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr size_t kNoTriangles = 0;

// What stands behind "#:" in a line that was written.
std::string behind_mark(const std::string& line) {
  REQUIRE(line.starts_with(obj::kNote));
  REQUIRE(line.ends_with("\n"));
  REQUIRE(line.find('\n') + 1 == line.size());
  return line.substr(obj::kNote.size(), line.size() - obj::kNote.size() - 1);
}

// A part alone, there and back.
Part back_of(const Part& part) {
  Model model, back;
  model.parts = {part};
  std::string line;
  obj::append_part_note(line, model, 0);
  obj::Notes notes;
  REQUIRE(notes.read(behind_mark(line), kNoTriangles));
  REQUIRE(notes.build(back));
  return back.parts[0];
}

Model unit_square() {
  Model model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  return model;
}

// False when one of the notes is refused, or all of them together.
bool is_accepted(const std::vector<std::string>& lines) {
  obj::Notes notes;
  Model model = unit_square();
  const uint32_t ring[] = {0, 1, 2, 3, 0};
  for (const std::string& line : lines)
    if (line == "l") notes.line(ring);
    else if (!notes.read(line, kNoTriangles)) return false;
  return notes.build(model);
}

std::vector<std::string> chain_of_parts(size_t count) {
  std::vector<std::string> lines{"part 0 class a name a"};
  for (size_t i = 1; i < count; ++i)
    lines.push_back("part " + std::to_string(i) + " of " + std::to_string(i - 1));
  return lines;
}

}  // namespace

TEST_CASE("obj_notes__parts_come_back_with_every_number_to_the_last_bit") {
  const Model house = House().model();
  obj::Notes notes;
  for (uint32_t p = 0; p < house.parts.size(); ++p) {
    std::string line;
    obj::append_part_note(line, house, p);
    REQUIRE(notes.read(behind_mark(line), kNoTriangles));
  }
  Model back;
  REQUIRE(notes.build(back));
  REQUIRE(back.parts.size() == house.parts.size());
  for (size_t p = 0; p < house.parts.size(); ++p) {
    const Part &a = house.parts[p], &b = back.parts[p];
    CHECK(b.name == a.name);
    CHECK(b.part_class == a.part_class);
    CHECK(b.parent == a.parent);
    CHECK(b.copied_from == a.copied_from);
    CHECK(b.evidence == a.evidence);
    CHECK((b.width_m == a.width_m || (std::isnan(a.width_m) && std::isnan(b.width_m))));
  }
  Part part;
  part.height_m = 1.0 / 3;
  part.depth_m = -1e-17;
  part.level_of_detail = 255;
  part.evidence = Evidence::kDerived;
  const Part same = back_of(part);
  CHECK(same.height_m == 1.0 / 3);
  CHECK(same.depth_m == -1e-17);
  CHECK(same.level_of_detail == 255);
  CHECK(same.evidence == Evidence::kDerived);
  CHECK(std::isnan(same.width_m));
}

TEST_CASE("obj_notes__names_stay_in_their_line_whatever_they_hold") {
  for (const char* name :
       {"", "-", "_", "name", "two words", "name of width 7", "#: mesh", "\xC3\xA9t\xC3\xA9"}) {
    Part part;
    part.name = name;
    part.part_class = "wall";
    CHECK(back_of(part).name == name);
    CHECK(back_of(part).part_class == "wall");
  }
  for (const char* part_class : {"", "-", "_", "name", "of"}) {
    Part part;
    part.part_class = part_class;
    CHECK(back_of(part).part_class == part_class);
    CHECK(back_of(part).name.empty());
  }
  Part hostile;
  hostile.name = "a\nf 1 2 3\r\x01";
  hostile.part_class = "two words";
  CHECK(back_of(hostile).name == "a f 1 2 3");
  CHECK(back_of(hostile).part_class == "two_words");
  std::string line;
  obj::append_crs_note(line, "");
  obj::append_crs_note(line, "EPSG:2154\nv 0 0 0");
  obj::append_crs_note(line, std::string(70000, 'x'));
  CHECK(line.empty());
  obj::append_crs_note(line, "COMPD_CS[\"a b\"]");
  obj::Notes notes;
  Model model;
  CHECK(notes.read(behind_mark(line), kNoTriangles));
  CHECK(notes.build(model));
  CHECK(model.crs == "COMPD_CS[\"a b\"]");
}

TEST_CASE("obj_notes__a_face_has_the_rings_that_its_notes_announce_and_their_geometry") {
  obj::Notes notes;
  const uint32_t outline[] = {0, 1, 2, 3, 0}, hole[] = {4, 5, 6, 7, 4};
  notes.line(outline);  // nobody asked for it
  std::string line;
  Face written;
  written.id = 17;
  written.face_class = 2;
  written.sigma_m = 0.003;
  obj::append_face_note(line, written);
  REQUIRE(notes.read("part 0 class wall name w", kNoTriangles));
  REQUIRE(notes.read("part 1 of 0 class window name v", kNoTriangles));
  REQUIRE(notes.read(behind_mark(line), kNoTriangles));
  CHECK(notes.wants_ring());
  notes.line(outline);
  CHECK_FALSE(notes.wants_ring());
  line.clear();
  obj::append_hole_note(line, {0, 4, 1});
  REQUIRE(notes.read(behind_mark(line), kNoTriangles));
  notes.line(hole);
  line.clear();
  obj::append_solid_note(line, {1, 0, 1});
  REQUIRE(notes.read(behind_mark(line), kNoTriangles));
  CHECK(notes.own_triangles(9) == 9);
  REQUIRE(notes.read(" mesh", 5));
  CHECK(notes.own_triangles(9) == 5);
  Model model = unit_square();
  const std::vector<Vec3> corners{{0.2, 0.2, 0}, {0.6, 0.2, 0}, {0.6, 0.7, 0}, {0.2, 0.7, 0}};
  model.vertices.insert(model.vertices.end(), corners.begin(), corners.end());
  REQUIRE(notes.build(model));
  REQUIRE(model.faces.size() == 1);
  const Face& face = model.faces[0];
  CHECK(face.id == 17);
  CHECK(face.face_class == 2);
  CHECK(face.sigma_m == 0.003);
  CHECK(face.ring_count == 2);
  CHECK(model.rings[1].part == 1);
  CHECK(model.corners == std::vector<uint32_t>{0, 1, 2, 3, 7, 6, 5, 4});  // holes run clockwise
  CHECK(face.area_m2 == doctest::Approx(1 - 0.4 * 0.5));
  CHECK(norm(face.plane.normal - Vec3{0, 0, 1}) <= 1e-15);
  REQUIRE(model.solids.size() == 1);
  CHECK(model.solids[0].part == 1);
  CHECK(model.solids[0].face_count == 1);
}

TEST_CASE("obj_notes__what_does_not_fit_together_is_refused") {
  CHECK(is_accepted({"part 0 name a", "face part 0 id 1", "l", "solid part 0 first 0 count 1"}));
  CHECK(is_accepted({"face part 7 id 1", "l"}));  // no parts: the number means nothing
  CHECK_FALSE(is_accepted({"part 0 name a", "face part 1 id 1", "l"}));
  CHECK_FALSE(is_accepted({"part 1 name a"}));  // parts stand in order
  CHECK_FALSE(is_accepted({"part 0 of x name a"}));
  CHECK_FALSE(is_accepted({"part 0 width inf name a"}));
  CHECK_FALSE(is_accepted({"face id 1"}));         // without its outline
  CHECK_FALSE(is_accepted({"hole part 0", "l"}));  // of no face
  CHECK_FALSE(is_accepted({"face id -1", "l"}));
  CHECK_FALSE(is_accepted({"face id 1", "l", "solid first 0 count 2"}));
  CHECK_FALSE(is_accepted({"face id 1", "l", "solid first 1 count 18446744073709551615"}));
  CHECK_FALSE(is_accepted({"nothing 1"}));
  CHECK_FALSE(is_accepted({"part 0 of 1 name a", "part 1 of 0 name b"}));  // a walk upward must end
  CHECK(is_accepted(chain_of_parts(kMaxPartLevels)));
  CHECK_FALSE(is_accepted(chain_of_parts(2 * kMaxPartLevels)));
}
