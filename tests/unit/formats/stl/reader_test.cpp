// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// STL files put together by hand after the specification of 3D Systems, 1989.
#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "formats/files/endian.h"
#include "formats/stl/stl.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Corners = std::array<float, 9>;

std::string binary_stl(const std::string& header, const std::vector<Corners>& triangles) {
  std::string bytes = header;
  bytes.resize(84, ' ');
  store<uint32_t>(bytes.data() + 80, static_cast<uint32_t>(triangles.size()));
  for (const Corners& corners : triangles) {
    std::string record(50, '\x7f');  // normal and spare bytes: whatever they are
    for (size_t k = 0; k < 9; ++k) store<float>(record.data() + 12 + 4 * k, corners[k]);
    bytes += record;
  }
  return bytes;
}

Model stl_model(const std::string& bytes) {
  const OpenedFile file(bytes, "a.stl");
  Task task;
  return read_stl(file, {}, task);
}

std::string refused_stl(const std::string& bytes) {
  const Failure failure = failure_of([&] { stl_model(bytes); });
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

bool binary_by_size(const std::string& bytes) {
  const OpenedFile file(bytes);
  return is_binary_stl(file);
}

constexpr Corners kFirst{0, 0, 0, 1, 0, 0, 1, 1, 0}, kSecond{0, 0, 0, 1, 1, 0, -0.0f, 1, 0};

}  // namespace

TEST_CASE("stl_reader__the_size_alone_tells_a_binary_file_also_when_it_begins_with_solid") {
  const std::string bytes = binary_stl("solid of another program", {kFirst, kSecond});
  CHECK(binary_by_size(bytes));
  CHECK_FALSE(binary_by_size(bytes + "x"));
  CHECK_FALSE(binary_by_size(bytes.substr(0, bytes.size() - 1)));
  CHECK_FALSE(binary_by_size(bytes.substr(0, 83)));
  const Model model = stl_model(bytes);
  CHECK(model.vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(model.triangles == std::vector<std::array<uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
  CHECK(model.triangle_faces == std::vector<uint32_t>{0, 0});
  REQUIRE(model.parts.size() == 1);
  const Model empty = stl_model(binary_stl("", {}));
  CHECK(empty.triangles.empty());
}

TEST_CASE("stl_reader__corners_at_one_place_are_one_vertex_and_a_shift_of_our_own_is_added") {
  const Model zeros = stl_model(binary_stl("", {kFirst, {-0.0f, 0, -0.0f, 0, 1, 0, 1, 0, -0.0f}}));
  CHECK(zeros.vertices.size() == 4);
  CHECK(zeros.triangles[1] == std::array<uint32_t, 3>{0, 3, 1});
  const auto first_vertex = [](const std::string& header) {
    return stl_model(binary_stl(header, {kFirst})).vertices[1];
  };
  CHECK(first_vertex("Jalon, metres, add 652000 6861000 -12") == Vec3{652001, 6861000, -12});
  CHECK(first_vertex("Jalon, metres, add 1 2") == Vec3{1, 0, 0});  // not whole: none
  CHECK(first_vertex("Jalon, metres, add 1 2 nan") == Vec3{1, 0, 0});
  CHECK(first_vertex("metres, add 1 2 3") == Vec3{1, 0, 0});
  std::vector<Corners> many(9000);  // several blocks of 4096
  for (size_t i = 0; i < many.size(); ++i) {
    many[i] = kFirst;
    many[i][2] = static_cast<float>(i);
  }
  const Model model = stl_model(binary_stl("", many));
  REQUIRE(model.triangles.size() == many.size());
  size_t wrong = 0;
  for (size_t i = 0; i < many.size(); ++i)
    wrong += model.vertices[model.triangles[i][0]] == Vec3{0, 0, double(i)} ? 0 : 1;
  CHECK(wrong == 0);
  CHECK(model.vertices.size() == many.size() + 2);
  many[5000][4] = std::numeric_limits<float>::infinity();
  const std::string message = refused_stl(binary_stl("", many));
  CHECK(has_text(message, "a.stl: offset 250084: triangle 5000 is not finite"));  // 84 + 50 * 5000
}

TEST_CASE("stl_reader__text_in_any_case_and_spacing_gives_a_part_for_each_solid_with_triangles") {
  const std::string facet =
      " FACET normal 0 0 1\r\n\touter LOOP\nvertex 0 0 0\n  Vertex\t1e0 0 0\nVERTEX +1 1 0 9\n"
      "EndLoop\nendfacet\n";
  const Model model = stl_model("Solid a b\n" + facet + facet +
                                "endsolid a b\nsolid none\nendsolid\n"
                                "solid\n" +
                                facet + "endsolid\n");
  CHECK(model.triangles.size() == 3);
  CHECK(model.vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  REQUIRE(model.parts.size() == 2);
  CHECK(model.parts[0].name == "a b");
  CHECK(model.parts[1].name == "mesh");
  CHECK(model.triangle_faces == std::vector<uint32_t>{0, 0, 1});
  const Model signs =
      stl_model("solid\nfacet\nvertex -0 0 0\nvertex 0 -0 0\nvertex 0 0 1\nendfacet\nendsolid\n");
  CHECK(signs.vertices.size() == 2);  // zeros of both signs are one place
}

TEST_CASE("stl_reader__what_breaks_off_or_is_out_of_turn_is_refused_with_its_line") {
  const std::string two = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  const std::string whole = two + "vertex 1 1 0\nendloop\nendfacet\n";
  CHECK(has_text(refused_stl(two + "endloop\n"), "a.stl: line 6: a facet needs three vertices"));
  CHECK(has_text(refused_stl(two + "facet normal 0 0 1\n"), "line 6: a facet inside a facet"));
  CHECK(has_text(refused_stl(whole + "vertex 2 2 2\n"), "line 9: the file ends inside a facet"));
  CHECK(has_text(refused_stl(whole + "triangle 1\n"), "line 9: this is no statement"));
  CHECK(has_text(refused_stl(two + "vertex 1 1\n"), "line 6: a vertex needs three numbers"));
  CHECK(has_text(refused_stl(two + "vertex 1 1 inf\n"), "line 6: a vertex is not finite"));
  CHECK(has_text(refused_stl("solid a\nendsolid a\n"), "there are no triangles"));
  CHECK(has_text(refused_stl("soli"), "neither \"solid\" nor a number of triangles"));
  std::string lying = binary_stl("", {kFirst});
  store<uint32_t>(lying.data() + 80, 0xFFFFFFFFu);
  CHECK(has_text(refused_stl(lying), "offset 80: neither"));
}
