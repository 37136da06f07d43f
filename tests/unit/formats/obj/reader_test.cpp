// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// OBJ files of other programs, in all the ways in which they may spell the same mesh.
#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

#include "formats/obj/obj.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model model_of(const std::string& text, Polygons polygons = Polygons::kAuto) {
  const OpenedFile file(text, "a.obj");
  Task task;
  ReadSettings settings;
  settings.polygons = polygons;
  return read_obj(file, settings, task);
}

std::string refused_text(const std::string& text) {
  const Failure failure = failure_of([&] { model_of(text); });
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

constexpr const char* kFour = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";

}  // namespace

TEST_CASE("obj_reader__spellings_of_corners_lines_and_ends_give_the_same_mesh") {
  RandomStream random(8, 2);
  for (int round = 0; round < 4; ++round) {
    std::string plain, other;
    std::vector<std::array<uint32_t, 3>> wanted;
    int vertices = 0;
    for (int i = 0; i < 150; ++i) {
      if (vertices < 3 || random.below(2) == 0) {
        ++vertices;
        const std::string number = std::to_string(vertices);
        plain += "v " + number + " 0.5 -1e-3\n";
        other += " \tv   +" + number + ".0\t.5 \\\n-0.001 1.0\r\n";  // carried on, with a weight
        continue;
      }
      std::array<uint32_t, 3> triangle;
      plain += "f";
      other += "f";
      for (uint32_t& corner : triangle) {
        corner = static_cast<uint32_t>(random.below(static_cast<uint64_t>(vertices)));
        const int back = static_cast<int>(corner) - vertices;
        plain += " " + std::to_string(corner + 1);
        const char* tails[] = {"/7", "//3", "/7/3", ""};
        other += "  " + std::to_string(random.below(2) == 0 ? back : static_cast<int>(corner) + 1);
        other += tails[random.below(4)];
      }
      plain += "\n";
      other += "\r\n# said in between\r\nvt 0 0\r\ns off\r\nusemtl red\r\n";
      wanted.push_back(triangle);
    }
    const Model a = model_of(plain), b = model_of(other);
    CHECK(a.triangles == wanted);
    CHECK(b.triangles == wanted);
    CHECK(a.vertices == b.vertices);
    CHECK(a.vertices.size() == static_cast<size_t>(vertices));
    CHECK(a.vertices[0] == Vec3{1, 0.5, -0.001});
  }
}

TEST_CASE("obj_reader__groups_are_parts_and_polygons_without_groups_are_faces_of_their_own") {
  const std::string quad = "f 1 2 3 4\n", triangle = "f 1 2 3\n";
  const Model bare = model_of(kFour + quad + triangle + quad);
  CHECK(bare.triangle_faces == std::vector<uint32_t>{0, 0, 1, 2, 2});
  CHECK(bare.parts.empty());
  const Model grouped =
      model_of(kFour + ("g a\n" + quad) + "o b c\n" + triangle + "g a\n" + triangle + "g\n" + quad);
  REQUIRE(grouped.parts.size() == 3);  // a group that comes again is the same one
  CHECK(grouped.parts[1].name == "b c");
  CHECK(grouped.parts[2].name == "default");
  CHECK(grouped.triangle_faces == std::vector<uint32_t>{0, 0, 1, 0, 2, 2});
}

TEST_CASE("obj_reader__notes_count_only_in_files_that_say_whose_they_are") {
  const std::string nonsense = "#: nothing we know\n";
  CHECK(model_of(kFour + nonsense + "f 1 2 3\n").triangles.size() == 1);
  CHECK(model_of("# Jalon\n" + nonsense + kFour, Polygons::kMesh).vertices.size() == 4);
  CHECK(has_text(refused_text("# Jalon\n" + nonsense + kFour), "line 2: a note \"#:\""));
  CHECK(has_text(refused_text(std::string("# Jalon\n") + kFour + "#: face id 1\n"),
                 "do not fit together"));
  // Triangles before the note "mesh" draw the faces; those behind it are a mesh of its own.
  const Model model = model_of(std::string("# Jalon\n") + kFour +
                               "f 1 2 3\nf 1 3 4\n#: face id 5\nl 1 2 3 4 1\n#: mesh\ng face_77\n"
                               "f 2 3 4\n");
  REQUIRE(model.faces.size() == 1);
  CHECK(model.faces[0].area_m2 == doctest::Approx(4));
  CHECK(model.triangles == std::vector<std::array<uint32_t, 3>>{{1, 2, 3}});
  CHECK(model.triangle_faces == std::vector<uint32_t>{77});
}

TEST_CASE("obj_reader__impossible_lines_are_refused_with_their_number") {
  CHECK(
      has_text(refused_text(std::string(kFour) + "f 1 2\n"), "a.obj: line 5: a face needs three"));
  CHECK(has_text(refused_text(std::string(kFour) + "f 1 2 0\n"), "line 5: a face names a vertex"));
  CHECK(has_text(refused_text(std::string(kFour) + "f 1 2 5\n"), "line 5: a face names a vertex"));
  CHECK(has_text(refused_text(std::string(kFour) + "f 1 2 -5\n"), "line 5: a face names a vertex"));
  CHECK(has_text(refused_text(std::string(kFour) + "f 1 2 3.5\n"), "line 5: a corner of a face"));
  CHECK(has_text(refused_text("v 1 2 3a\n"), "line 1: a vertex needs three numbers"));
  CHECK(has_text(refused_text("v 1 1e999 3\n"), "line 1: "));
  CHECK(has_text(refused_text("v 1 2 \\\n"),
                 "line 1: a vertex needs three numbers"));  // carried on to nothing
  CHECK(
      has_text(refused_text("v 0 0 0\n" + std::string((size_t{1} << 20) + 9, '#')), "longer than"));
  CHECK(has_text(refused_text("# empty\n"), "there are no vertices"));
}
