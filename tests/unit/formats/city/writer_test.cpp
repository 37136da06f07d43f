// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Files of CityJSON, read by another JSON library: areas and volumes of bodies that are known, names, refusals.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "formats/city/city.h"
#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"
#include "unit/formats/kept_log.h"

using namespace jalon;
using namespace jalon::test;

namespace {

nlohmann::json city_file(const Model& model, double scale_m, Task& task) {
  const Folder folder;
  WriteSettings settings;
  settings.city_scale_m = scale_m;
  write_city(model, folder.file("out"), settings, task);
  return nlohmann::json::parse(slurp(folder.file("out")));
}

/// Twice the vector area of a ring of the file, about its own origin.
Vec3 ring_area(const nlohmann::json& file, const nlohmann::json& ring, double& volume) {
  const auto step = [&](size_t i) {
    const nlohmann::json& v = file.at("vertices").at(ring.at(i % ring.size()).get<size_t>());
    const nlohmann::json& scale = file.at("transform").at("scale");
    return Vec3{v.at(0).get<double>() * scale.at(0).get<double>(),
                v.at(1).get<double>() * scale.at(1).get<double>(),
                v.at(2).get<double>() * scale.at(2).get<double>()};
  };
  Vec3 sum;
  for (size_t i = 0; i < ring.size(); ++i) sum += cross(step(i), step(i + 1));
  volume += dot(step(0), sum) / 6;
  return sum;
}

Model buildings(const std::vector<std::pair<const char*, uint64_t>>& names_and_parents) {
  Model model;
  for (const auto& [name, parent] : names_and_parents) {
    Part part;
    part.name = name;
    part.part_class = part_class::kBuilding;
    part.parent = parent;
    model.parts.push_back(part);
    Face face;
    face.part = static_cast<uint32_t>(model.parts.size() - 1);
    model.add_face(face, {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}});
  }
  return model;
}

}  // namespace

TEST_CASE("city_writer__surfaces_have_their_area_and_a_solid_its_volume") {
  constexpr double kStep_m = 1e-6, kChord_m = 0.001;
  const Model model = House().model();
  Task task;
  const nlohmann::json file = city_file(model, kStep_m, task);
  double area_m2 = 0, closed_m2 = 0, solid_m3 = 0, nothing = 0;
  for (const nlohmann::json& geometry : file["CityObjects"]["house"]["geometry"]) {
    const bool solid = geometry["type"] == "Solid";
    const nlohmann::json& surfaces = solid ? geometry["boundaries"][0] : geometry["boundaries"];
    const nlohmann::json& values =
        solid ? geometry["semantics"]["values"][0] : geometry["semantics"]["values"];
    REQUIRE(values.size() == surfaces.size());
    for (size_t s = 0; s < surfaces.size(); ++s) {
      Vec3 twice;
      for (const nlohmann::json& ring : surfaces[s])
        twice += ring_area(file, ring, solid ? solid_m3 : nothing);
      const nlohmann::json& meaning = geometry["semantics"]["surfaces"][values[s].get<size_t>()];
      (meaning.contains("closes_opening") ? closed_m2 : area_m2) += norm(twice) / 2;
    }
  }
  // Chords cut at most their error times the length of the arcs; the steps half a micrometre of 200 m of edges.
  const double heads_m = 3 * 1.9, round_m = 2.6, edges_m = 200;
  const double bound_m2 = kChord_m * (heads_m + 2 * round_m) + edges_m * kStep_m;
  CHECK(std::fabs(area_m2 - face_area(model)) <= bound_m2);
  CHECK(std::fabs(closed_m2 - (House::arch_area() + House::round_area() + 1.0 * 2.2)) <= bound_m2);
  CHECK(std::fabs(solid_m3 - 1.4 * 0.1 * 0.1) <= kStep_m);  // half a step on 0.6 m2; outward
}

TEST_CASE("city_writer__buildings_have_names_of_their_own_and_know_each_other") {
  const Model model = buildings({{"a", kNoParent}, {"a", 0}, {"", 1}, {"a_2", kNoParent}});
  Task task;
  const nlohmann::json file = city_file(model, 0.001, task);
  std::map<uint32_t, std::string> id_of_part;
  for (const auto& [id, object] : file["CityObjects"].items())
    id_of_part[object["attributes"]["part"].get<uint32_t>()] = id;
  REQUIRE(id_of_part.size() == 4);  // none took the place of another
  CHECK(id_of_part[0] == "a");
  CHECK(id_of_part[2] == "building");
  for (uint32_t p = 0; p < 4; ++p) {
    const nlohmann::json& object = file["CityObjects"][id_of_part[p]];
    const bool below = p == 1 || p == 2;
    CHECK(object["type"] == (below ? "BuildingPart" : "Building"));
    CHECK(object.contains("parents") == below);
    if (!below) continue;
    CHECK(object["parents"] == nlohmann::json::array({id_of_part[p - 1]}));
    CHECK(file["CityObjects"][id_of_part[p - 1]]["children"] ==
          nlohmann::json::array({id_of_part[p]}));
    CHECK(object["geometry"][0]["lod"] == "2");  // no openings
  }
  CHECK_FALSE(file["CityObjects"][id_of_part[3]].contains("children"));
  CHECK(file["vertices"].size() == 3);  // each place once
}

TEST_CASE("city_writer__tells_what_each_part_knows_and_nothing_that_is_no_number") {
  KeptLog log;
  Model model = House().model();
  model.faces[2].sigma_m = INFINITY;
  Face speck;
  speck.part = 2;
  model.add_face(
      speck, {{{652417, 6861005, 142}, {652417.001, 6861005, 142}, {652417, 6861005, 142.001}}});
  const nlohmann::json file = city_file(model, 0.01, log.task());
  CHECK(log.warnings() ==
        std::vector<std::string>{
            "CityJSON: 1 faces smaller than the step of the coordinates left out"});
  std::set<uint32_t> told;
  const nlohmann::json& house = file["CityObjects"]["house"];
  for (const nlohmann::json& group : house["attributes"]["groups"])
    told.insert(group["part"].get<uint32_t>());
  told.insert(house["attributes"]["part"].get<uint32_t>());
  for (const nlohmann::json& geometry : house["geometry"])
    for (const nlohmann::json& surface : geometry["semantics"]["surfaces"]) {
      told.insert(surface["part"].get<uint32_t>());
      const Part& part = model.parts[surface["part"].get<size_t>()];
      CHECK(surface["name"] == part.name);
      CHECK(surface.contains("width_m") == std::isfinite(part.width_m));
      CHECK(surface.contains("copied_from") == (part.copied_from != kNoParent));
      if (part.part_class == part_class::kSill) CHECK(surface["face"].size() == 6);
    }
  CHECK(told.size() == model.parts.size());  // surface, object or group: no part is lost
}

TEST_CASE("city_writer__with_attributes__tells_them_of_objects_surfaces_and_groups") {
  const Folder folder;
  const Model model = House().model();
  PartAttributes attributes;
  attributes.of_part.resize(model.parts.size());
  for (uint32_t p = 0; p < model.parts.size(); ++p) {
    attributes.add_whole(p, "strip_matches", 7 + p);
    attributes.add(p, "strip_offset_m", 0.125 * p);
    attributes.add(p, "strip_distance_before_m", NAN);
  }
  Task task;
  write_city_attributes(model, attributes, folder.file("out"), {}, task);
  const nlohmann::json file = nlohmann::json::parse(slurp(folder.file("out")));
  std::set<uint32_t> told;
  const auto tells = [&](const nlohmann::json& of) {
    const auto part = of.at("part").get<uint32_t>();
    told.insert(part);
    CHECK(of.at("strip_matches").is_number_integer());
    CHECK(of.at("strip_matches") == 7 + part);
    CHECK(of.at("strip_offset_m") == 0.125 * part);
    CHECK(!of.contains("strip_distance_before_m"));
  };
  for (const auto& [id, object] : file["CityObjects"].items()) {
    if (object["attributes"].contains("part")) tells(object["attributes"]);
    if (object["attributes"].contains("groups"))
      for (const nlohmann::json& group : object["attributes"]["groups"]) tells(group);
    for (const nlohmann::json& geometry : object["geometry"])
      for (const nlohmann::json& surface : geometry["semantics"]["surfaces"]) tells(surface);
  }
  CHECK(told.size() == model.parts.size());
  // They change nothing of what is read again.
  write_city(model, folder.file("bare"), {}, task);
  const Model with = read_city(ByteSource(folder.file("out")), {}, task),
              bare = read_city(ByteSource(folder.file("bare")), {}, task);
  REQUIRE(with.parts.size() == bare.parts.size());
  for (size_t p = 0; p < bare.parts.size(); ++p) {
    CHECK(with.parts[p].name == bare.parts[p].name);
    CHECK(with.parts[p].part_class == bare.parts[p].part_class);
    CHECK(with.parts[p].parent == bare.parts[p].parent);
  }
  CHECK(with.vertices == bare.vertices);
}

TEST_CASE("city_writer__refused_models_leave_no_file") {
  const Folder folder;
  const auto refusal = [&](const Model& model, double scale_m) {
    Task task;
    WriteSettings settings;
    settings.city_scale_m = scale_m;
    const Failure failure =
        failure_of([&] { write_city(model, folder.file("out"), settings, task); });
    CHECK(folder.entries() == 0);
    return failure;
  };
  Model model = buildings({{"a", kNoParent}});
  model.vertices[1].x = 1e13;
  CHECK(refusal(model, 0.0001).status == Status::kLimit);
  model.vertices[1].x = NAN;
  const Failure failure = refusal(model, 0.0001);
  CHECK(failure.status == Status::kInvalidArgument);
  CHECK(failure.text.find("vertex 1") != std::string::npos);
}
