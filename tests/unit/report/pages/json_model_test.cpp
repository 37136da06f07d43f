// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Parts and openings as JSON, read by another reader, against the facade that was built by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "report/pages/json_model.h"
#include "report/settings.h"
#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

nlohmann::json json_of_parts(const Model& model) {
  JsonWriter json;
  json.begin_object();
  write_model_parts(json, model);
  return nlohmann::json::parse(json.end_object().take());
}

Model facade_with_a_copy() {
  named_facade::Setting setting;
  setting.copied = 3;
  setting.empty = 5;
  return named_facade::make(setting);
}

}  // namespace

TEST_CASE("json_model__the_tree_of_parts_reads_back") {
  const Model model = facade_with_a_copy();
  const auto parts = json_of_parts(model)["parts"];
  REQUIRE(parts.size() == model.parts.size());
  const std::map<Evidence, std::string> words{
      {Evidence::kNone, "none"},      {Evidence::kMeasured, "measured"},
      {Evidence::kShape, "shape"},    {Evidence::kSeenBehind, "seen_behind"},
      {Evidence::kCopied, "copied"},  {Evidence::kRevealed, "revealed"},
      {Evidence::kDerived, "derived"}};
  for (size_t i = 0; i < parts.size(); ++i) {
    const Part& part = model.parts[i];
    size_t faces = 0;
    for (const Face& face : model.faces) faces += face.part == i;
    CAPTURE(part.name);
    CHECK(parts[i]["name"] == part.name);
    CHECK(parts[i]["class"] == part.part_class);
    CHECK(parts[i]["faces"] == faces);
    CHECK(parts[i]["evidence"] == words.at(part.evidence));
    if (part.parent == kNoParent) CHECK(parts[i]["parent"].is_null());
    else CHECK(parts[i]["parent"] == part.parent);
    if (part.copied_from == kNoParent) CHECK(parts[i]["copied_from"].is_null());
    else CHECK(parts[i]["copied_from"] == part.copied_from);
    if (std::isnan(part.width_m)) CHECK(parts[i]["width_m"].is_null());
    else CHECK(parts[i]["width_m"] == part.width_m);
  }
}

TEST_CASE("json_model__types_count_the_openings_that_carry_their_tag") {
  const auto json = json_of_parts(facade_with_a_copy());
  REQUIRE(json["openings"].size() == 15);
  std::map<std::string, size_t> number, copies;
  for (const auto& opening : json["openings"]) {
    const std::string tag = opening["type"];
    ++number[tag];
    copies[tag] += !opening["copied_from"].is_null();
    for (const auto& type : json["opening_types"]) {
      if (type["type"] != tag) continue;
      CHECK(type["class"] == opening["class"]);
      CHECK(type["arched"] == opening["arched"]);
      for (const char* size : {"width_m", "height_m"})
        CHECK(std::abs(type[size].get<double>() - opening[size].get<double>()) <= kTypeTolerance_m);
    }
    CHECK(opening["sigma_width_m"].is_null());  // nothing is known of the corners
  }
  CHECK(number.size() == json["opening_types"].size());
  for (const auto& type : json["opening_types"]) {
    CHECK(type["count"] == number[type["type"]]);
    CHECK(type["copies"] == copies[type["type"]]);
  }
}

TEST_CASE("json_model__places_that_no_part_has_are_null") {
  Model model;
  model.parts = {named_facade::part("lost", part_class::kWall, 99),
                 named_facade::part("window", part_class::kWindow, 0)};
  model.parts[1].copied_from = 2;  // one behind the last
  const auto json = json_of_parts(model);
  CHECK(json["parts"][0]["parent"].is_null());
  CHECK(json["parts"][1]["parent"] == 0);
  CHECK(json["parts"][1]["copied_from"].is_null());
  CHECK(json["openings"][0]["part"] == 1);
  CHECK(json["openings"][0]["copied_from"].is_null());
  const auto empty = json_of_parts({});
  REQUIRE(empty.size() == 4);
  CHECK(empty["no_data"]["count"] == 0);
  CHECK(empty["no_data"]["share"] == 0);
  for (const char* name : {"opening_types", "openings", "parts"}) CHECK(empty[name].empty());
}
