// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Written STL files record by record after the specification of 3D Systems, 1989, without the reader.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "formats/files/endian.h"
#include "formats/stl/stl.h"
#include "unit/formats/house.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string stl_of(const Model& model, StlForm form = StlForm::kBinary) {
  const Folder folder;
  Task task;
  WriteSettings settings;
  settings.stl_format = form;
  write_stl(model, folder.file("a.stl"), settings, task);
  return slurp(folder.file("a.stl"));
}

// The k-th vector of record i: the normal, then the corners.
Vec3 vector_in(const std::string& bytes, size_t i, size_t k) {
  const char* at = bytes.data() + 84 + 50 * i + 12 * k;
  return {load<float>(at), load<float>(at + 4), load<float>(at + 8)};
}

Model random_triangles(size_t n, const Vec3& centre, double extent_m) {
  Model model;
  RandomStream random(17, n);
  for (uint32_t i = 0; i < 3 * n; ++i)
    model.vertices.push_back(
        centre +
        Vec3{random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5} * extent_m);
  for (uint32_t i = 0; i < n; ++i) model.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  model.triangle_faces.assign(n, 0);
  return model;
}

// The shift that the header of 80 bytes tells.
Vec3 stated_shift(const std::string& bytes) {
  std::istringstream words(bytes.substr(0, 80));
  std::string jalon, metres, add;
  Vec3 shift;
  words >> jalon >> metres >> add >> shift.x >> shift.y >> shift.z;
  CHECK(add == "add");
  return shift;
}

}  // namespace

TEST_CASE("stl_writer__records_hold_right_handed_unit_normals_and_corners_to_half_a_float_step") {
  const Vec3 far{652417.3, 6861005.7, 142.5};
  for (const Vec3& centre : {Vec3{}, far}) {
    const Model model = random_triangles(500, centre, 100);
    const std::string bytes = stl_of(model);
    REQUIRE(bytes.size() == 84 + 50 * 500);
    CHECK(load<uint32_t>(bytes.data() + 80) == 500);
    const Vec3 shift = stated_shift(bytes);
    for (int k = 0; k < 3; ++k) CHECK(shift[k] == std::floor(shift[k]));
    CHECK((norm(shift) == 0) == (norm(centre) == 0));
    // Beyond 4096 m the smallest corner is taken off: what is left is below 128, whose half step is 2^-18.
    const double half_step = 0x1p-18;
    for (size_t i = 0; i < 500; ++i) {
      const Vec3 a = model.vertices[3 * i], b = model.vertices[3 * i + 1],
                 c = model.vertices[3 * i + 2];
      const Vec3 normal = vector_in(bytes, i, 0);
      CHECK(std::fabs(norm(normal) - 1) <= 2e-7);  // three floats, each rounded to 2^-25 of 1
      CHECK(dot(normal, cross(b - a, c - a)) > 0);
      for (size_t k = 0; k < 3; ++k) {
        const Vec3 rest = vector_in(bytes, i, k + 1) + shift - model.vertices[3 * i + k];
        for (int axis = 0; axis < 3; ++axis) CHECK(std::fabs(rest[axis]) <= half_step + 1e-9);
      }
      CHECK(load<uint16_t>(bytes.data() + 84 + 50 * i + 48) == 0);  // the spare bytes
    }
  }
  CHECK(stated_shift(stl_of(random_triangles(5, {4000, 0, 0}, 100))) == Vec3{});
  CHECK(stl_of(Model{}).size() == 84);
}

TEST_CASE(
    "stl_writer__faces_come_with_their_openings_open_and_degenerate_triangles_without_normal") {
  const Model house = House().model();
  const std::string bytes = stl_of(house);
  const size_t n = (bytes.size() - 84) / 50;
  double area_m2 = 0;
  for (size_t i = 0; i < n; ++i) {
    const Vec3 a = vector_in(bytes, i, 1);
    area_m2 += norm(cross(vector_in(bytes, i, 2) - a, vector_in(bytes, i, 3) - a)) / 2;
  }
  // Chords 0.001 m from 9 m of arcs; the rounding to floats is far below.
  CHECK(std::fabs(area_m2 - face_area(house)) <= 9 * 0.001);
  Model line;
  line.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  line.triangle_faces = {0};
  CHECK(vector_in(stl_of(line), 0, 0) == Vec3{});
}

TEST_CASE("stl_writer__text_has_a_solid_for_each_part_and_coordinates_to_the_last_bit") {
  Model mesh = random_triangles(3, {652417, 6861005, 142}, 10);
  mesh.parts.resize(2);
  mesh.parts[0].name = "first one";
  mesh.parts[1].name = "second\nvertex 9 9 9";
  mesh.triangle_faces = {0, 0, 1};
  std::istringstream lines(stl_of(mesh, StlForm::kAscii));
  std::vector<std::string> solids;
  std::vector<Vec3> corners;
  size_t facets = 0, ends = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "solid") solids.push_back(line);
    if (keyword == "facet") ++facets;
    if (keyword == "endsolid") ++ends;
    if (keyword == "vertex") {
      corners.emplace_back();
      words >> corners.back().x >> corners.back().y >> corners.back().z;
    }
  }
  CHECK(solids == std::vector<std::string>{"solid first one", "solid second vertex 9 9 9"});
  CHECK(ends == 2);
  CHECK(facets == 3);
  CHECK(corners == mesh.vertices);
  CHECK(stl_of(Model{}, StlForm::kAscii) == "solid model\nendsolid model\n");
}

TEST_CASE("stl_writer__an_impossible_model_leaves_the_old_file") {
  const Folder folder;
  spill(folder.file("a.stl"), "old");
  Model model = random_triangles(1, {}, 1);
  model.vertices[2].y = std::nan("");
  Task task;
  const Failure failure = failure_of([&] { write_stl(model, folder.file("a.stl"), {}, task); });
  CHECK(failure.status == Status::kInvalidArgument);
  CHECK(has_text(failure.text, "vertex 2 is not finite"));
  CHECK(slurp(folder.file("a.stl")) == "old");
  CHECK(folder.entries() == 1);
}
