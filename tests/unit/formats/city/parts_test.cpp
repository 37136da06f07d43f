// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Parts and semantic surfaces against the names of CityJSON 2.0 and a house whose openings are known.
#include "formats/city/parts.h"

#include <doctest/doctest.h>

#include "model/part_classes.h"
#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Parts of these classes, each below the one before it.
Model chain_of(const std::vector<std::string>& classes) {
  Model model;
  for (size_t i = 0; i < classes.size(); ++i) {
    Part part;
    part.part_class = classes[i];
    part.parent = i == 0 ? kNoParent : i - 1;
    model.parts.push_back(part);
  }
  return model;
}

}  // namespace

TEST_CASE("city_parts__surface_types_lead_back_to_the_class_and_joinery_takes_its_opening's") {
  using namespace part_class;
  for (const char* known : {kWall, kWindow, kDoor, kOpening, kRoof, kGround})
    CHECK(city::class_of_surface(city::surface_type(chain_of({known}), 0)) == std::string(known));
  for (const char* type : {"OuterCeilingSurface", "FloorSurface", "", "wallsurface"})
    CHECK(city::class_of_surface(type) == std::string(kElement));
  const auto type_of_last = [](const std::vector<std::string>& classes) {
    return std::string(
        city::surface_type(chain_of(classes), static_cast<uint32_t>(classes.size() - 1)));
  };
  CHECK(type_of_last({kWall, kDoor, kJoinery}) == "Door");
  CHECK(type_of_last({kWall, kOpening, kJoinery}) == "ClosureSurface");
  CHECK(type_of_last({kWall, kJoinery}) == "Window");
  CHECK(type_of_last({kJoinery}) == "Window");
  for (const char* other : {kSill, kCornice, kReveal, kNoData, "gargoyle"})
    CHECK(type_of_last({kDoor, other}) == "WallSurface");
  CHECK(city::surface_type(chain_of({kRoof}), kNoPart) == std::string("WallSurface"));
}

TEST_CASE("city_parts__names_of_objects_become_words") {
  // Types of the specification, and one of an extension.
  const std::pair<const char*, const char*> kNames[] = {
      {"Building", "building"},
      {"BuildingPart", "building"},
      {"TINRelief", "tin_relief"},
      {"GenericCityObject", "generic_city_object"},
      {"SolitaryVegetationObject", "solitary_vegetation_object"},
      {"LandUse", "land_use"},
      {"+NoiseCityFurnitureSegment", "noise_city_furniture_segment"},
      {"", ""},
      {"+", ""},
      {"X", "x"},
      {"ABC", "abc"},
  };
  for (const auto& [type, word] : kNames) CHECK(city::class_of_object(type) == word);
}

TEST_CASE("city_parts__nearest_walks_up_and_ends_in_a_ring_of_parents") {
  const Model model = chain_of({"building", "facade", "building", "wall", "window"});
  CHECK(city::nearest(model, 4, "building") == 2);
  CHECK(city::nearest(model, 2, "building") == 2);
  CHECK(city::nearest(model, 1, "building") == 0);
  CHECK(city::nearest(model, 4, "facade") == 1);
  CHECK(city::nearest(model, 1, "wall") == kNoPart);  // never down
  CHECK(city::nearest(model, 99, "building") == kNoPart);
  Model ring = chain_of({"wall", "wall", "wall"});
  ring.parts[0].parent = 2;
  CHECK(city::nearest(ring, 1, "building") == kNoPart);
}

TEST_CASE("city_parts__joinery_fills_an_opening_and_reveals_do_not") {
  Model model = House().model();
  const auto index_of = [&](const std::string& name) {
    for (uint32_t p = 0; p < model.parts.size(); ++p)
      if (model.parts[p].name == name) return p;
    return kNoPart;
  };
  Part reveal;
  reveal.part_class = part_class::kReveal;
  reveal.parent = index_of("door");
  Face face;
  face.part = static_cast<uint32_t>(model.parts.size());
  model.parts.push_back(reveal);
  model.faces.push_back(face);
  const city::Openings openings = city::find_openings(model);
  for (const char* name : {"window 1", "door", "window 2", "round"}) {
    CHECK(openings.wall[index_of(name)] == index_of("wall \xC3\xA9t\xC3\xA9"));
    CHECK((openings.filled[index_of(name)] != 0) == (name == std::string("window 1")));
  }
  for (const char* name : {"facade A", "joinery 1", "sill 1", "roof"})
    CHECK(openings.wall[index_of(name)] == kNoPart);
}
