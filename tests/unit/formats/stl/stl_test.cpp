// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <nlohmann/json.hpp>

#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model there_and_back(const Model& model, const char* name, StlForm form = StlForm::kBinary) {
  const Folder folder;
  Task task;
  WriteSettings settings;
  settings.stl_format = form;
  write_model(model, folder.file(name), settings, task);
  return read_model(folder.file(name), {}, task);
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

TEST_CASE("stl__both_forms_come_back_with_their_area_and_place") {
  const Model model = House().model();
  Box3 box, found;
  for (const Vec3& p : model.vertices) box.add(p);
  for (const StlForm form : {StlForm::kAscii, StlForm::kBinary}) {
    const Model back = there_and_back(model, "a.stl", form);
    CHECK(mesh_area(back) == doctest::Approx(face_area(model)).epsilon(2e-5));
    found = {};
    for (const Vec3& p : back.vertices) found.add(p);
    const double step_m =
        form == StlForm::kAscii ? 0 : 1e-6;  // float32 after whole metres are taken off
    CHECK(norm(found.min - box.min) <= step_m);
    CHECK(norm(found.max - box.max) <= step_m);
  }
}

TEST_CASE("stl__ascii_keeps_parts_and_binary_shared_vertices") {
  const Model back = there_and_back(House().model(), "a.stl", StlForm::kAscii);
  REQUIRE(back.parts.size() == 6);
  CHECK(back.parts[0].name == "wall \xC3\xA9t\xC3\xA9");
  CHECK(back.parts[5].name == "sill 1");
  Model cube;
  for (int i = 0; i < 8; ++i)
    cube.vertices.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  cube.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}};
  cube.triangle_faces = {0, 0, 0};
  const Model mesh = there_and_back(cube, "b.stl");
  CHECK(mesh.vertices.size() == 7);
  CHECK(mesh.triangles == cube.triangles);
}

TEST_CASE("stl__what_is_none_is_refused_with_its_place") {
  const auto failure = [](const std::string& bytes) {
    const Folder folder;
    spill(folder.file("a.stl"), bytes);
    Task task;
    return failure_of([&] { read_model(folder.file("a.stl"), {}, task); }).text;
  };
  CHECK(failure("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n").find("line 4") !=
        std::string::npos);
  CHECK(failure("solid a\nvertex 0 0 nan\n").find("not finite") != std::string::npos);
  CHECK(failure("solid a\nvertex 0 0 0\nendloop\n").find("three vertices") != std::string::npos);
  CHECK(failure("solid a\nendsolid a\n").find("no triangles") != std::string::npos);
  CHECK(failure(std::string(100, 'x')).find("fits the size") != std::string::npos);
}

TEST_CASE("obj__a_model_comes_back_with_faces_holes_parts_and_solids") {
  const Model model = House().model();
  const Model back = there_and_back(model, "a.obj");
  REQUIRE(back.parts.size() == model.parts.size());
  for (size_t p = 0; p < model.parts.size(); ++p) {
    CHECK(back.parts[p].name == model.parts[p].name);
    CHECK(back.parts[p].part_class == model.parts[p].part_class);
    CHECK(back.parts[p].parent == model.parts[p].parent);
    CHECK(back.parts[p].evidence == model.parts[p].evidence);
    CHECK(back.parts[p].copied_from == model.parts[p].copied_from);
  }
  REQUIRE(back.faces.size() == model.faces.size());
  REQUIRE(back.rings.size() == model.rings.size());
  for (size_t r = 0; r < model.rings.size(); ++r) CHECK(back.rings[r].part == model.rings[r].part);
  for (size_t f = 0; f < model.faces.size(); ++f) {
    CHECK(back.faces[f].part == model.faces[f].part);
    CHECK(back.faces[f].id == model.faces[f].id);
    CHECK(back.faces[f].area_m2 == doctest::Approx(model.faces[f].area_m2).epsilon(2e-3).scale(0));
    CHECK(dot(back.faces[f].plane.normal, model.faces[f].plane.normal) > 1 - 1e-12);
  }
  for (size_t v = 0; v < model.vertices.size(); ++v) CHECK(back.vertices[v] == model.vertices[v]);
  CHECK(back.triangles.empty());
  CHECK(back.crs == "EPSG:2154");
  REQUIRE(back.solids.size() == 1);
  CHECK(back.solids[0].first_face == model.solids[0].first_face);
  CHECK(back.solids[0].face_count == 6);
}

TEST_CASE("obj__polygons_of_other_programs_become_faces_when_asked") {
  const Folder folder;
  spill(folder.file("a.obj"),
        "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\ng roof\nf 1 2 3 4\nf 1 1 2\n#: part one\nl 1 2\n");
  Task task;
  ReadSettings settings;
  CHECK(read_model(folder.file("a.obj"), settings, task).triangles.size() == 3);
  settings.polygons = Polygons::kFaces;
  const Model model = read_model(folder.file("a.obj"), settings, task);
  REQUIRE(model.faces.size() == 1);
  CHECK(model.faces[0].area_m2 == doctest::Approx(4));
  CHECK(model.parts[model.faces[0].part].name == "roof");
  CHECK(model.triangles.empty());
}

TEST_CASE("geojson__a_feature_a_face_with_closed_rings_and_an_honest_system") {
  const Folder folder;
  Task task;
  Model model = House().model();
  model.parts[model.faces.back().part].evidence = Evidence::kCopied;
  const auto written = [&] {
    write_model(model, folder.file("a.geojson"), {}, task);
    return nlohmann::json::parse(slurp(folder.file("a.geojson")));
  };
  const auto json = written();
  CHECK(json["crs"]["properties"]["name"] == "urn:ogc:def:crs:EPSG::2154");
  REQUIRE(json["features"].size() >= model.faces.size());  // those of openings behind
  size_t copied = 0;
  for (size_t f = 0; f < model.faces.size(); ++f) {
    const auto& feature = json["features"][f];
    CHECK(feature["properties"].contains("class"));
    for (const auto& ring : feature["geometry"]["coordinates"]) CHECK(ring.front() == ring.back());
    copied += feature["properties"]["copied"].get<bool>() ? 1 : 0;
  }
  size_t of_copies = 0;
  for (const Face& face : model.faces)
    of_copies += model.parts[face.part].evidence == Evidence::kCopied ? 1 : 0;
  REQUIRE(of_copies > 0);
  CHECK(copied == of_copies);
  CHECK(json["features"][0]["geometry"]["coordinates"].size() == 5);
  CHECK(json["features"][0]["geometry"]["coordinates"][0][0][0] == model.vertices[0].x);
  CHECK(!json["features"][1]["properties"].contains("depth_m"));  // not known
  model.crs = "PROJCS[\"a\",UNIT[\"US survey foot\",0.3048006096],AUTHORITY[\"EPSG\",\"2263\"]]";
  CHECK(written()["crs"]["properties"]["name"].get<std::string>().starts_with(
      "LOCAL_CS"));  // metres, no feet
  model.crs =
      "PROJCS[\"a\",UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]],AUTHORITY[\"EPSG\",\"25832\"]]";
  CHECK(written()["crs"]["properties"]["name"] == "urn:ogc:def:crs:EPSG::25832");
}
