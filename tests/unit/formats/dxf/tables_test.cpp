// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Header and tables against what they state of themselves: counts, names that others point to, the drawing's extent.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>

#include "formats/dxf/sections.h"
#include "unit/formats/dxf/tags.h"

using namespace jalon;
using namespace jalon::test;
using dxf::Version;

namespace {

dxf::Drawing layered_drawing() {
  dxf::Drawing drawing;
  drawing.layers.of_class("wall");
  drawing.layers.of_class("window", true);
  drawing.layers.of_class("no_data");
  drawing.box.add({1, 2, 3});
  drawing.box.add({5, 8, 4.5});
  drawing.view_direction = {0.6, -0.8, 0};
  return drawing;
}

struct DxfTable {
  TagItem head;
  std::vector<TagItem> entries = {};
};
std::map<std::string, DxfTable> tables_of(const dxf::Drawing& drawing, Version version) {
  dxf::Text text(version);
  dxf::add_tables(text, drawing);
  std::map<std::string, DxfTable> out;
  DxfTable* open = nullptr;
  for (const TagItem& item : tag_items(text.take())) {
    if (item.kind() == "TABLE") {
      CHECK(open == nullptr);
      open = &(out[item.text(2)] = {item});
    } else if (item.kind() == "ENDTAB") {
      REQUIRE(open != nullptr);
      open = nullptr;
    } else if (open != nullptr) {
      open->entries.push_back(item);
    }
  }
  CHECK(open == nullptr);
  return out;
}

/// The tags behind each variable of the header.
std::map<std::string, std::vector<Tag>> header_of(const dxf::Drawing& drawing, Version version) {
  dxf::Text text(version);
  dxf::add_header(text, drawing, 0xBEEF);
  const std::vector<TagItem> items = tag_items(text.take());
  REQUIRE(items.size() == 2);
  std::map<std::string, std::vector<Tag>> out;
  std::string name;
  for (const Tag& tag : items[0].tags) {
    if (tag.code == 9) name = tag.value;
    else if (!name.empty()) out[name].push_back(tag);
  }
  return out;
}

Vec3 point_of(const std::vector<Tag>& tags) {
  REQUIRE(tags.size() == 3);
  return {tags[0].number(), tags[1].number(), tags[2].number()};
}

}  // namespace

TEST_CASE("dxf_tables__count_their_entries_and_name_each_once") {
  for (const Version version : {Version::kR12, Version::kR2000}) {
    auto tables = tables_of(layered_drawing(), version);
    for (const char* name : {"VPORT", "LTYPE", "LAYER", "STYLE", "VIEW", "UCS", "APPID"})
      CHECK(tables.contains(name));
    for (const char* name : {"DIMSTYLE", "BLOCK_RECORD"})
      CHECK(tables.contains(name) == (version == Version::kR2000));
    for (const auto& named : tables) {
      const auto& kind = named.first;
      const auto& table = named.second;
      CAPTURE(kind);
      CHECK(table.head.number(70) == static_cast<double>(table.entries.size()));
      std::set<std::string> names;
      for (const TagItem& entry : table.entries) {
        CHECK(entry.kind() == kind);
        CHECK(names.insert(entry.text(2)).second);
        CHECK(entry.text(330) == table.head.text(5));  // "" both in release 12
        CHECK(entry.text(kind == "DIMSTYLE" ? 105 : 5).empty() == (version == Version::kR12));
      }
    }
    CHECK(tables["APPID"].entries.back().text(2) == "JALON");  // as the data of the entities say
  }
}

TEST_CASE("dxf_tables__layers_have_colour_and_a_line_type_that_is_there") {
  const dxf::Drawing drawing = layered_drawing();
  for (const Version version : {Version::kR12, Version::kR2000}) {
    auto tables = tables_of(drawing, version);
    std::set<std::string> types;
    for (const TagItem& type : tables["LTYPE"].entries) {
      types.insert(type.text(2));
      double length = 0;
      for (const std::string& dash : type.all(49)) length += std::fabs(Tag{49, dash}.number());
      CHECK(type.number(40) == doctest::Approx(length).epsilon(1e-12));
      CHECK(type.number(73) == static_cast<double>(type.all(49).size()));
      CHECK((type.text(2) == "DASHED") == (length > 0));
    }
    const std::vector<TagItem>& layers = tables["LAYER"].entries;
    REQUIRE(layers.size() == 4);
    for (size_t i = 0; i < layers.size(); ++i) {
      const dxf::Layer& layer = drawing.layers.all()[i];
      CHECK(layers[i].text(2) == layer.name);
      CHECK(layers[i].number(62) == layer.colour);
      CHECK(types.contains(layers[i].text(6)));
      CHECK((layers[i].text(6) == "DASHED") == (i >= 2));  // the copy, and what no station saw
    }
    if (version == Version::kR2000)
      CHECK(std::stoull(layers[3].text(5), nullptr, 16) == dxf::kFirstFree + 3);
  }
}

TEST_CASE("dxf_tables__header_and_window_tell_where_the_drawing_is") {
  const dxf::Drawing drawing = layered_drawing();
  for (const Version version : {Version::kR12, Version::kR2000}) {
    auto header = header_of(drawing, version);
    CHECK(point_of(header["$EXTMIN"]) == Vec3{1, 2, 3});
    CHECK(point_of(header["$EXTMAX"]) == Vec3{5, 8, 4.5});
    CHECK(header["$ACADVER"].at(0).value == (version == Version::kR12 ? "AC1009" : "AC1015"));
    CHECK(header.contains("$HANDSEED") == (version == Version::kR2000));
    CHECK(header.contains("$INSUNITS") == (version == Version::kR2000));
    CHECK(point_of(header_of({}, version)["$EXTMAX"]) == Vec3{});  // nothing drawn: no infinities
    auto tables = tables_of(drawing, version);
    REQUIRE(tables["VPORT"].entries.size() == 1);
    const TagItem& window = tables["VPORT"].entries[0];
    CHECK(Vec3{window.number(16), window.number(26), window.number(36)} == Vec3{0.6, -0.8, 0});
    CHECK(Vec3{window.number(17), window.number(27), window.number(37)} == Vec3{3, 5, 3.75});
    const double diagonal_m = norm(Vec3{4, 6, 1.5});
    CHECK(window.number(40) >= diagonal_m);  // all of it, from any direction
    CHECK(window.number(40) <= 1.5 * diagonal_m);
  }
  CHECK(header_of(drawing, Version::kR2000)["$HANDSEED"].at(0).value == "BEEF");
  CHECK(header_of(drawing, Version::kR2000)["$INSUNITS"].at(0).value == "6");  // metres
}
