// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The reader of CityJSON against small texts whose parts, areas and errors are known.
#include <doctest/doctest.h>

#include <map>

#include "formats/city/city.h"
#include "unit/formats/fixtures.h"
#include "unit/formats/kept_log.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// A file on the corners of a square of 2 m, numbers in decimetres, and the middle of its first side.
std::string square_city(
    const std::string& objects, const std::string& more = "",
    const std::string& vertices = "[0,0,0],[20,0,0],[20,20,0],[0,20,0],[10,0,0]") {
  return R"({"type": "CityJSON", "version": "2.0", "transform": {"scale": [0.1, 0.1, 0.1],
             "translate": [652000, 6861000, 35]}, )" +
         more + "\"CityObjects\": {" + objects + "}, \"vertices\": [" + vertices + "]}";
}

Model city_of(const std::string& text, Task& task) {
  const Folder folder;
  spill(folder.file("square.city.json"), text);
  return read_city(ByteSource(folder.file("square.city.json")), {}, task);
}

Failure city_refusal(const std::string& text) {
  Task task;
  return failure_of([&] { city_of(text, task); });
}

}  // namespace

TEST_CASE("city_reader__takes_the_finest_level_and_tells_what_it_leaves_out") {
  KeptLog log;
  const Model model = city_of(square_city(R"("a": {"type": "Building", "geometry": [
      {"type": "MultiSurface", "lod": "1.3", "boundaries": [[[0,1,2,3]]]},
      {"type": "MultiSurface", "lod": 2.2, "boundaries": [[[0,1,2]], [[0,4,1]], [[4,4,4]]]},
      {"type": "MultiPoint", "lod": "2.2", "boundaries": [0, 1]},
      {"type": "MultiSurface", "lod": "rough", "boundaries": [[[0,1,2,3]]]},
      {"type": "MultiSurface", "boundaries": [[[0,1,2,3]]]}]},
    "b": {"type": "Road", "geometry": [{"type": "MultiSurface", "boundaries": [[[0,2,3]]]}]},
    "c": {"type": "WaterBody"})"),
                              log.task());
  REQUIRE(model.faces.size() == 2);  // the only one of the road has no level
  for (const Face& face : model.faces) CHECK(face.area_m2 == doctest::Approx(2));
  REQUIRE(log.warnings().size() == 2);
  CHECK(log.warnings()[0].ends_with("square.city.json: 2 surfaces without area left out"));
  CHECK(log.warnings()[1].ends_with("square.city.json: 1 geometries of points and lines left out"));
  std::map<std::string, std::string> classes;
  for (const Part& part : model.parts) classes[part.name] = part.part_class;
  CHECK(classes ==
        std::map<std::string, std::string>{{"a", "building"}, {"b", "road"}, {"c", "water_body"}});
}

TEST_CASE("city_reader__groups_and_numbers_rebuild_the_tree_in_its_order") {
  Task task;
  const Model model = city_of(square_city(R"("house": {"type": "Building",
      "attributes": {"part": 0, "name": "house 7", "class": "building", "year": 1890, "groups": [
        {"part": 3, "part_of": 2, "class": "window", "name": "w"},
        {"part": 1, "part_of": 0, "class": "facade", "name": "street side"}, {"name": "numberless"}]},
      "geometry": [{"type": "MultiSurface", "lod": "3", "boundaries": [[[0,1,2,3]]],
        "semantics": {"surfaces": [{"type": "Door"}, {"type": "WallSurface", "part": 2, "part_of": 1,
          "class": "wall", "name": "wall", "face": 17, "sigma_m": 0.003}], "values": [1]}}]})"),
                              task);
  REQUIRE(model.parts.size() == 4);
  const char* kNames[] = {"house 7", "street side", "wall", "w"};
  const char* kClasses[] = {"building", "facade", "wall", "window"};
  for (size_t p = 0; p < 4; ++p) {
    CHECK(model.parts[p].name == kNames[p]);
    CHECK(model.parts[p].part_class == kClasses[p]);
    CHECK(model.parts[p].parent == (p == 0 ? kNoParent : p - 1));
  }
  REQUIRE(model.faces.size() == 1);
  CHECK(model.faces[0].part == 2);
  CHECK(model.faces[0].id == 17);
  CHECK(model.faces[0].sigma_m == 0.003);
}

TEST_CASE("city_reader__keeps_a_metric_system_by_its_code_and_others_as_they_are") {
  const auto system = [](const std::string& value) {
    Task task;
    const Model model = city_of(
        square_city("", "\"metadata\": {\"title\": \"t\", \"referenceSystem\": " + value + "}, "),
        task);
    CHECK(model.vertices[2] == Vec3{652002, 6861002, 35});
    return model.crs.str();
  };
  CHECK(system("\"https://www.opengis.net/def/crs/EPSG/0/2154\"") == "EPSG:2154");
  CHECK(system("\"urn:ogc:def:crs:EPSG::2154\"") == "EPSG:2154");
  CHECK(system("\"the mayor's own\"") == "the mayor's own");
  CHECK(system("2154").empty());
}

TEST_CASE("city_reader__refuses_with_the_byte_and_what_was_expected") {
  // before: the text up to the byte.
  const auto refused_behind = [](const std::string& before, const std::string& text,
                                 const std::string& reason) {
    const Failure failure = city_refusal(text);
    CHECK(failure.status == Status::kFormat);
    const std::string line =
        "offset " + std::to_string(text.find(before) + before.size()) + ": " + reason;
    CHECK_MESSAGE(failure.text.ends_with(line), failure.text, " / ", line);
  };
  const std::string expected = " was expected", json = "no CityJSON: ";
  refused_behind("[1,2]", square_city("", "", "[0,0,0],[1,2]"), json + "three numbers" + expected);
  refused_behind("[1,2,3 ,", square_city("", "", "[1,2,3 ,4]"), json + "three numbers" + expected);
  refused_behind("[1,2,", square_city("", "", "[1,2,\"3\"]"), json + "a number" + expected);
  refused_behind("\"groups\": [ ", square_city(R"("a": {"attributes": {"groups": [ 7]}})"),
                 json + "an object" + expected);
  refused_behind("\"boundaries\": 5", square_city(R"("a": {"geometry": [{"boundaries": 5?)"),
                 json + "a comma or the end of the values" + expected);
  const auto tower = [](int levels) {
    std::string out;
    for (int i = 0; i < levels; ++i)
      out += (i == 0 ? "\"o" : ", \"o") + std::to_string(i) +
             R"(": {"type": "BuildingPart", "parents": ["o)" + std::to_string(i + 1) + "\"]}";
    return square_city(out);
  };
  CHECK(city_refusal(tower(64)).status == Status::kOk);  // the uppermost names no object
  refused_behind("\"CityObjects\": ", tower(65), "the parts are no tree of at most 64 levels");
}
