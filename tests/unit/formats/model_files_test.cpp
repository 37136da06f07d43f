// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "formats/drawings/svg_writer.h"
#include "model/polygon_triangles.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model read_obj_text(const std::string& text) {
  const Folder folder;
  spill(folder.file("a.obj"), text);
  Task task;
  return read_model(folder.file("a.obj"), {}, task);
}

double area(const std::vector<std::vector<Vec2>>& rings,
            const std::vector<std::array<uint32_t, 3>>& triangles) {
  std::vector<Vec2> all;
  for (const auto& ring : rings) all.insert(all.end(), ring.begin(), ring.end());
  double sum = 0;
  for (const auto& t : triangles) {
    const double twice = cross(all[t[1]] - all[t[0]], all[t[2]] - all[t[0]]);
    CHECK(twice >= -1e-12);
    sum += twice / 2;
  }
  return sum;
}

std::vector<Vec2> box(double u, double v, double width, double height) {
  return {{u, v}, {u + width, v}, {u + width, v + height}, {u, v + height}};
}

// A facade in the plane y = 0 with openings; normal towards -y.
Model facade(bool with_openings) {
  Model model;
  model.parts.push_back({"wall 1", "wall", kNoParent});
  const auto ring = [](double x, double z, double w, double h, bool opening) {
    std::vector<Vec3> out{{x, 0, z}, {x + w, 0, z}, {x + w, 0, z + h}, {x, 0, z + h}};
    if (opening) std::swap(out[1], out[3]);
    return out;
  };
  Face face;
  face.id = 5;
  face.plane.normal = {0, -1, 0};
  std::vector<std::vector<Vec3>> rings{ring(0, 0, 10, 8, false)};
  if (with_openings)
    for (int i = 0; i < 6; ++i)
      rings.push_back(ring(1 + 3 * (i % 3), 1 + 4 * (i / 3), 1.2, 1.5, true));
  model.add_face(face, rings);
  return model;
}

double mesh_area(const Model& model) {
  double sum = 0;
  for (const auto& t : model.triangles)
    sum += norm(cross(model.vertices[t[1]] - model.vertices[t[0]],
                      model.vertices[t[2]] - model.vertices[t[0]])) /
           2;
  return sum;
}

}  // namespace

TEST_CASE("triangulate__keeps_openings_open_and_covers_the_rest") {
  std::vector<std::vector<Vec2>> rings{box(0, 0, 100, 60)};
  double holes = 0;
  RandomStream random(1, 1);
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 5; ++j) {
      const double w = 2 + 5 * random.uniform(), h = 3 + 5 * random.uniform();
      rings.push_back(box(3 + 10.5 * i, 2 + 11.5 * j, w, h));
      if ((i + j) % 2 == 0) std::reverse(rings.back().begin(), rings.back().end());
      holes += w * h;
    }
  const auto triangles = triangulate(rings);
  CHECK(area(rings, triangles) == doctest::Approx(6000 - holes).epsilon(1e-9));
  CHECK(triangles.size() == 4 + 45 * 4 + 2 * 45 - 2);
  const std::vector<std::vector<Vec2>> aligned{box(0, 0, 10, 10), box(1, 1, 1, 1), box(3, 1, 1, 1),
                                               box(5, 1, 1, 1), box(1, 3, 1, 1)};
  CHECK(area(aligned, triangulate(aligned)) == doctest::Approx(96));
}

TEST_CASE("triangulate__openings_may_touch_the_outline_and_each_other_in_a_corner") {
  const std::vector<std::vector<Vec2>> rings{{{0, 0}, {10, 0}, {10, 10}, {5, 8}, {0, 10}},
                                             {{5, 8}, {6, 5}, {4, 5}},
                                             {{4, 5}, {3, 2}, {2, 4}},
                                             {{6, 5}, {8, 4}, {7, 2}},
                                             {{3, 2}, {7, 2}, {5, 1}}};
  for (int turns = 0; turns < 24; ++turns) {
    const double c = std::cos(0.26 * turns), s = std::sin(0.26 * turns);
    auto turned = rings;
    for (auto& ring : turned)
      for (Vec2& p : ring) p = {c * p.u - s * p.v, s * p.u + c * p.v};
    CHECK(area(turned, triangulate(turned)) ==
          doctest::Approx(90 - 3 - 2.5 - 2.5 - 2).epsilon(1e-9));
  }
}

TEST_CASE("triangulate__stars_and_combs_have_their_area_and_crossed_polygons_end") {
  std::vector<std::vector<Vec2>> comb(1);
  for (int i = 0; i < 200; ++i) {
    comb[0].push_back({double(i), 0});
    comb[0].push_back({i + 0.25, -5});
    comb[0].push_back({i + 0.5, 0});
  }
  comb[0].push_back({200, 1});
  comb[0].push_back({0, 1});
  double twice = 0;
  for (size_t i = 0; i < comb[0].size(); ++i)
    twice += cross(comb[0][i], comb[0][(i + 1) % comb[0].size()]);
  CHECK(area(comb, triangulate(comb)) == doctest::Approx(twice / 2).epsilon(1e-9));
  RandomStream random(2, 2);
  for (int round = 0; round < 50; ++round) {
    std::vector<std::vector<Vec2>> tangle(1 + random.below(4));
    for (auto& ring : tangle)
      for (uint64_t i = random.below(40); i > 0; --i)
        ring.push_back({std::floor(random.uniform() * 8), std::floor(random.uniform() * 8)});
    (void)triangulate(tangle);
  }
  CHECK(triangulate({}).empty());
  CHECK(triangulate({{}}).empty());
}

TEST_CASE("obj__reads_polygons_negative_indices_groups_and_continued_lines") {
  const Model model = read_obj_text(
      "# c\nmtllib x\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0 1.0\nvt 0 0\nvn 0 0 1\no house\ng wall\nf "
      "1/1/1 2//1 3/1 4\ng roof\nf -4 \\\n -3 -2\nl 1 2 3\n");
  CHECK(model.vertices.size() == 4);
  REQUIRE(model.triangles.size() == 3);
  CHECK(model.triangles[2] == std::array<uint32_t, 3>{0, 1, 2});
  REQUIRE(model.parts.size() == 3);
  CHECK(model.parts[1].name == "wall");
  CHECK(model.triangle_faces == std::vector<uint32_t>{1, 1, 2});
  CHECK(mesh_area(model) == doctest::Approx(1.5));
}

TEST_CASE("obj__errors_name_the_line") {
  const auto text_of_failure = [](const char* text) {
    return failure_of([&] { read_obj_text(text); }).text;
  };
  CHECK(text_of_failure("v 0 0\n").find("line 1: a vertex needs three numbers") !=
        std::string::npos);
  CHECK(text_of_failure("v 0 0 0\nf 1 1 2\n")
            .find("line 2: a face names a vertex that is not there") != std::string::npos);
  CHECK(text_of_failure("v 0 0 0\nf 1 1 -9223372036854775808\n").find("line 2") !=
        std::string::npos);
  CHECK(text_of_failure("v 0 0 nan\n").find("line 1: a vertex is not finite") != std::string::npos);
  CHECK(text_of_failure("hello\n").find("no vertices") != std::string::npos);
}

TEST_CASE("obj__a_face_with_openings_comes_back_with_its_area") {
  const Folder folder;
  for (const bool openings : {false, true}) {
    Task task;
    write_model(facade(openings), folder.file("a.obj"), {}, task);
    const std::string text = slurp(folder.file("a.obj"));
    CHECK(text.find("o wall_1\ng plane_5\nf") != std::string::npos);
    CHECK(text.find("\ng outline_5\nl 1 2 3 4 1\n") != std::string::npos);
    ReadSettings as_mesh;
    as_mesh.polygons = Polygons::kMesh;
    const Model back = read_model(folder.file("a.obj"), as_mesh, task);
    CHECK(mesh_area(back) == doctest::Approx(80 - (openings ? 6 * 1.2 * 1.5 : 0)));
    for (const auto& t : back.triangles) {  // towards the normal
      const Vec3 n = cross(back.vertices[t[1]] - back.vertices[t[0]],
                           back.vertices[t[2]] - back.vertices[t[0]]);
      CHECK(n.y < 0);
    }
    write_model(facade(openings), folder.file("a.ply"), {}, task);
    CHECK(mesh_area(read_model(folder.file("a.ply"), {}, task)) ==
          doctest::Approx(80 - (openings ? 6 * 1.2 * 1.5 : 0)));
  }
}

TEST_CASE("obj__coordinates_round_trip_exactly") {
  const Folder folder;
  RandomStream random(4, 4);
  Model model;
  for (int i = 0; i < 300; ++i)
    model.vertices.push_back(
        {652000 + random.uniform(), 6861000 + random.uniform(), random.normal()});
  for (uint32_t i = 0; i + 2 < 300; ++i) model.triangles.push_back({i, i + 1, i + 2});
  model.triangle_faces.assign(model.triangles.size(), 3);
  Task task;
  write_model(model, folder.file("a.obj"), {}, task);
  const Model back = read_model(folder.file("a.obj"), {}, task);
  CHECK(back.vertices == model.vertices);
  CHECK(back.triangles == model.triangles);
}

TEST_CASE("svg__hostile_text_never_leaves_its_place") {
  SvgWriter svg;
  svg.open("svg", {{"width", 10}, {"title", "\"><script>alert(1)</script>"}});
  svg.element("text", {{"x", 0.5}}, "</text><script>&\x01\xff\x00");
  const std::string text = svg.take();
  CHECK(text.find("<script") == std::string::npos);
  CHECK(text.find('\x01') == std::string::npos);
  CHECK(text.ends_with("</svg>\n"));
  CHECK(svg_number(1.50001, 3) == "1.5");
  CHECK(svg_number(-0.0001, 3) == "0");
  CHECK(svg_number(100, 0) == "100");
}
