// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <nlohmann/json.hpp>

#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;
using Json = nlohmann::json;

namespace {

std::string written(const Model& model, double scale_m = 0.0001) {
  const Folder folder;
  Task task;
  WriteSettings settings;
  settings.city_scale_m = scale_m;
  write_model(model, folder.file("a.city.json"), settings, task);
  return slurp(folder.file("a.city.json"));
}

Model read_text(const std::string& text) {
  const Folder folder;
  spill(folder.file("a.city.json"), text);
  Task task;
  return read_model(folder.file("a.city.json"), {}, task);
}

// A cube of side 1 at the origin, scaled by 0.001: what other programs write.
Json cube() {
  return Json::parse(R"({
    "type": "CityJSON", "version": "2.0", "transform": {"scale": [0.001, 0.001, 0.001], "translate": [10, 20, 30]},
    "CityObjects": {
      "b": {"type": "Building", "attributes": {"class": "1000", "part": "no number"}, "children": ["p"], "geometry": [
        {"type": "MultiSurface", "lod": "1", "boundaries": [[[0,1,2,3]]]},
        {"type": "Solid", "lod": "2.2",
         "boundaries": [[[[0,3,2,1]],[[4,5,6,7]],[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]]]],
         "semantics": {
           "surfaces": [{"type": "GroundSurface"}, {"type": "RoofSurface"}, {"type": "WallSurface", "children": [3]},
                        {"type": "Window", "parent": 2}, {"type": "Door"}],
           "values": [[0,1,2,3,null,2]]}}]},
      "p": {"type": "BuildingPart", "parents": ["b"],
            "geometry": [{"type": "MultiLineString", "lod": "2.2", "boundaries": [[0,1]]}]}},
    "vertices": [[0,0,0],[1000,0,0],[1000,1000,0],[0,1000,0],[0,0,1000],[1000,0,1000],[1000,1000,1000],[0,1000,1000]]
  })");
}

}  // namespace

TEST_CASE("city__windows_and_doors_are_children_of_the_wall_and_fill_its_holes") {
  const Json city = Json::parse(written(House().model()));
  CHECK(city["version"] == "2.0");
  CHECK(city["metadata"]["referenceSystem"] == "https://www.opengis.net/def/crs/EPSG/0/2154");
  const Json& house = city["CityObjects"]["house"];
  CHECK(house["type"] == "Building");
  const Json* surfaces = nullptr;
  for (const Json& geometry : house["geometry"]) {
    CHECK(geometry["lod"] == "3");
    if (geometry["type"] == "MultiSurface") surfaces = &geometry;
    else CHECK(geometry["boundaries"][0].size() == 6);
  }
  REQUIRE(surfaces != nullptr);
  const Json& semantics = (*surfaces)["semantics"]["surfaces"];
  CHECK((*surfaces)["semantics"]["values"].size() == (*surfaces)["boundaries"].size());
  std::map<std::string, int> types;
  int wall = -1, closing = 0;
  for (size_t i = 0; i < semantics.size(); ++i) {
    ++types[semantics[i]["type"].get<std::string>()];
    if (semantics[i]["class"] == "wall") wall = static_cast<int>(i);
    closing += semantics[i].contains("closes_opening") ? 1 : 0;
  }
  CHECK(types["Window"] == 2);  // the pane of the first, and the copy
  CHECK(types["Door"] == 1);
  CHECK(types["ClosureSurface"] == 1);
  CHECK(types["GroundSurface"] == 1);
  CHECK(types["RoofSurface"] == 1);
  CHECK(types["WallSurface"] == 2);  // the area without data is wall too
  CHECK(closing == 3);
  REQUIRE(wall >= 0);
  CHECK(semantics[static_cast<size_t>(wall)]["children"].size() == 3);
  for (const Json& surface : semantics)
    if (surface["type"] == "Window" || surface["type"] == "Door") CHECK(surface["parent"] == wall);
  CHECK((*surfaces)["boundaries"][0].size() == 5);
}

TEST_CASE("city__a_model_comes_back_with_faces_holes_parts_and_solids") {
  const Model model = House().model();
  const Model back = read_text(written(model));
  CHECK(back.crs == "EPSG:2154");
  REQUIRE(back.parts.size() == model.parts.size());
  for (size_t p = 0; p < model.parts.size(); ++p) {
    CHECK(back.parts[p].name == model.parts[p].name);
    CHECK(back.parts[p].part_class == model.parts[p].part_class);
    CHECK(back.parts[p].parent == model.parts[p].parent);
    CHECK(back.parts[p].evidence == model.parts[p].evidence);
    CHECK(back.parts[p].copied_from == model.parts[p].copied_from);
  }
  CHECK(back.parts[3].width_m == 1.2);
  CHECK(std::isnan(back.parts[4].width_m));
  REQUIRE(back.faces.size() == model.faces.size());
  CHECK(back.rings.size() == model.rings.size());
  REQUIRE(back.solids.size() == 1);
  CHECK(back.solids[0].part == model.solids[0].part);
  CHECK(back.solids[0].face_count == 6);
  std::map<std::string, int> holes;
  for (const Ring& ring : back.rings)
    if (ring.part < back.parts.size()) ++holes[back.parts[ring.part].name];
  CHECK(holes == std::map<std::string, int>{{"door", 1}, {"window 2", 1}, {"round", 1}});
  double worst = 0;
  for (const Face& face : back.faces)
    for (const Face& given : model.faces)
      if (face.id == given.id && face.id != 6) {
        worst = std::max(worst, std::fabs(face.area_m2 - given.area_m2));
        CHECK(face.part == given.part);
        CHECK(face.sigma_m == given.sigma_m);
        CHECK(dot(face.plane.normal, given.plane.normal) > 1 - 1e-8);
      }
  MESSAGE("FIGURE city: areas of faces come back within ", worst,
          " m2 (chords of 1 mm, steps of 0.1 mm)");
  CHECK(worst < 0.01);
}

TEST_CASE("city__coordinates_keep_to_half_a_step_and_a_second_round_changes_nothing") {
  const Model model = House().model();
  for (const double scale_m : {0.001, 0.0001, 1e-6}) {
    const Model once = read_text(written(model, scale_m));
    double worst = 0;
    for (const Vec3& p : model.vertices) {
      double nearest = INFINITY;
      for (const Vec3& q : once.vertices) nearest = std::min(nearest, norm(p - q));
      worst = std::max(worst, nearest);
    }
    CHECK(worst <= 0.5 * std::sqrt(3.0) * scale_m + 2e-9);
    CHECK(written(read_text(written(once, scale_m)), scale_m) == written(once, scale_m));
  }
}

TEST_CASE("city__files_of_others_are_read_by_their_semantics") {
  const Model model = read_text(cube().dump());
  CHECK(model.faces.size() == 6);  // the highest level of detail
  CHECK(face_area(model) == doctest::Approx(6));
  CHECK(model.vertices[6] == Vec3{11, 21, 31});
  REQUIRE(model.solids.size() == 1);
  std::map<std::string, int> classes;
  for (const Face& face : model.faces) ++classes[model.parts[face.part].part_class];
  CHECK(classes == std::map<std::string, int>{
                       {"building", 1}, {"ground", 1}, {"roof", 1}, {"wall", 2}, {"window", 1}});
  uint32_t window = 0, building_part = 0;  // the latter has the name of its object
  for (uint32_t p = 0; p < model.parts.size(); ++p) {
    if (model.parts[p].part_class == "window") window = p;
    if (model.parts[p].name == "p") building_part = p;
  }
  CHECK(model.parts[model.parts[window].parent].part_class == "wall");
  CHECK(model.parts[building_part].part_class == "building");
  CHECK(model.parts[model.parts[building_part].parent].name == "b");
  for (const Part& part : model.parts) CHECK(part.part_class != "door");  // no polygon has it
  Json relief = cube();
  relief["CityObjects"]["p"]["type"] = "+TINRelief";
  for (const Part& part : read_text(relief.dump()).parts)
    if (part.name == "p") CHECK(part.part_class == "tin_relief");
  Json old = cube();
  old["version"] = "1.0";
  old.erase("transform");
  old["vertices"][0] = {0.25, 0.5, 0.75};
  CHECK(read_text(old.dump()).vertices[0] == Vec3{0.25, 0.5, 0.75});
}

TEST_CASE("city__what_cannot_be_read_is_refused_with_file_and_reason") {
  const auto refused = [](const Json& json) {
    const Failure failure = failure_of([&] { read_text(json.dump()); });
    CHECK(failure.text.find("a.city.json") != std::string::npos);
    return failure.status;
  };
  Json bad = cube();
  bad["CityObjects"]["b"]["geometry"][1]["type"] = "GeometryInstance";
  CHECK(refused(bad) == Status::kUnsupported);
  bad = cube();
  bad["version"] = "3.0";
  CHECK(refused(bad) == Status::kUnsupported);
  bad = cube();
  bad["type"] = "CityJSONFeature";
  CHECK(refused(bad) == Status::kUnsupported);
  bad = cube();
  bad["CityObjects"]["b"]["geometry"][1]["boundaries"][0][0][0][0] = 8;
  CHECK(refused(bad) == Status::kFormat);
  bad = cube();
  bad["CityObjects"]["b"]["geometry"][1]["semantics"]["values"][0].push_back(0);
  CHECK(refused(bad) == Status::kFormat);
  bad = cube();
  bad["CityObjects"]["b"]["geometry"][1]["semantics"]["values"][0][0] = 17;
  CHECK(refused(bad) == Status::kFormat);
  bad = cube();
  bad["vertices"][2] = {1, 2};
  CHECK(refused(bad) == Status::kFormat);
  bad = cube();
  bad["transform"]["scale"][0] = 1e308;
  CHECK(refused(bad) == Status::kFormat);
  bad = cube();
  bad["CityObjects"]["b"]["parents"] = {"p"};  // a ring of parents
  CHECK(refused(bad) == Status::kFormat);
  CHECK(refused(Json::object()) == Status::kFormat);
}

TEST_CASE("city__a_mesh_and_an_empty_model_are_written") {
  Model mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_faces = {0, 0};
  mesh.parts.push_back({"mesh", "mesh", kNoParent});
  const Model back = read_text(written(mesh));
  CHECK(back.faces.size() == 2);
  CHECK(face_area(back) == doctest::Approx(1));
  CHECK(read_text(written(Model{})).faces.empty());
}
