// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Chapters of openings and parts: their tables against the facade that was built by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "report/pages/html_model.h"
#include "unit/report/named_facade.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::has;
using page_scenes::tables_of;

namespace {

std::string openings_page(const Model& model) {
  Page page;
  add_openings(page, model, list_openings(model, kTypeTolerance_m));
  return page.html().take();
}

std::string parts_page(const Model& model) {
  Page page;
  add_parts(page, model);
  return page.html().take();
}

}  // namespace

TEST_CASE("html_model__each_opening_has_the_measures_of_its_part_and_the_sigma_of_two_sides") {
  named_facade::Setting setting;
  setting.copied = 3;
  setting.corner_variance = 4e-6;  // 2 mm an axis
  Model model = named_facade::make(setting);
  for (Part& part : model.parts)
    if (part.name == "window 1") part.class_confidence = 0.907;
  const std::string html = openings_page(model);
  CHECK(markup::well_formed(html));
  const auto tables = tables_of(html, "Openings");
  REQUIRE(tables.size() == 2);
  double number = 0;
  for (size_t i = 1; i < tables[0].size(); ++i) number += markup::number(tables[0][i][5]);
  CHECK(number == 15);
  REQUIRE(tables[1].size() == 16);
  for (size_t i = 1; i < 16; ++i) {
    const auto& row = tables[1][i];
    REQUIRE(row.size() == 11);
    CHECK(row[1] == (row[0] == "door 1" ? "door" : "window"));
    CHECK(row[2] == (row[0] == "window 1" ? "0.91" : ""));
    const bool is_door = row[0] == "door 1";
    CHECK(row[4] == (is_door ? "1.000" : "1.200"));
    CHECK(row[5] == "2.83");  // sqrt 2 times 2 mm
    if (row[0] == "window 1") {
      CHECK(row[7] == "2.83");
      // Two planes of 1 mm each, and what their normals add (0.01 mrad an axis) at the place.
      CHECK(markup::number(row[9]) >= 1.41);
      CHECK(markup::number(row[9]) < 2.8);
    }
    CHECK(row[8] == (is_door ? "0.250" : "0.150"));
    CHECK((row[10] == "copy of window 1") == (row[0] == "window 4"));
  }
  // Where nothing is known of the corners, the columns stay empty and the note away.
  setting.corner_variance = 0;
  setting.door = false;
  Model unknown = named_facade::make(setting);
  for (Face& face : unknown.faces) face.covariance.fill(NAN);
  const std::string plain = openings_page(unknown);
  CHECK(tables_of(plain, "Openings")[1][1][5].empty());
  CHECK(has(html, "by propagation"));
  CHECK(!has(plain, "by propagation"));
}

TEST_CASE("html_model__parts_are_indented_below_their_parents_and_reveals_are_counted") {
  const Model model = named_facade::make({});
  const std::string html = parts_page(model);
  std::vector<size_t> shown;  // parts in the order of the page, by their names
  size_t at = 0, reveals = 0;
  for (const Part& part : model.parts) reveals += part.part_class == part_class::kReveal;
  for (const markup::Tag& tag : markup::tags(html)) {
    const std::string style = tag.attribute("style");
    if (style.rfind("padding-left:", 0) == 0) {
      const auto table = tables_of(html, "Parts").at(0);
      const std::string& name = table.at(++at).at(0);
      size_t part = 0, depth = 0;
      while (part < model.parts.size() && model.parts[part].name != name) ++part;
      REQUIRE(part < model.parts.size());
      for (uint64_t p = part; model.parts[p].parent != kNoParent; p = model.parts[p].parent) {
        ++depth;
        bool is_above = false;
        for (const size_t other : shown) is_above |= other == model.parts[p].parent;
        CHECK(is_above);
      }
      const double rem = markup::number(std::string_view(style).substr(13, style.size() - 16));
      CHECK(rem == doctest::Approx(0.6 + 1.2 * static_cast<double>(depth)));
      shown.push_back(part);
      double area_m2 = 0;
      for (const Face& face : model.faces) area_m2 += face.part == part ? face.area_m2 : 0;
      const std::string& area = table[at][3];  // two decimals
      CHECK(std::abs((area.empty() ? 0 : markup::number(area)) - area_m2) < 0.0051);
    }
  }
  CHECK(shown.size() == model.parts.size() - reveals);
  CHECK(reveals > 0);
  CHECK(has(html, "And " + std::to_string(reveals) + " reveals"));
}

TEST_CASE("html_model__a_model_without_parts_or_openings_adds_nothing") {
  CHECK(openings_page({}).empty());
  CHECK(parts_page({}).empty());
  Model walls_only;
  walls_only.parts = {named_facade::part("a < b", part_class::kWall, kNoParent)};
  CHECK(openings_page(walls_only).empty());
  const std::string html = parts_page(walls_only);
  CHECK(tables_of(html, "Parts").at(0).at(1).at(0) == "a &lt; b");
  CHECK(!has(html, "reveals"));
}
