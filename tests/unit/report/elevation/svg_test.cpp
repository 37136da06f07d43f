// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Whole drawings: own names in a page of several, the settings that the table gives, figures around their content.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "report/report.h"
#include "unit/compare/refusal.h"
#include "unit/modelling/walls.h"
#include "unit/report/drawn.h"
#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

ElevationSettings settings_of(const std::string& json) {
  ParamSet set("elevation", elevation_rows());
  set.from_json(json);
  return settings_from<ElevationSettings>(set);
}

std::string svg_with(const Model& m, const ElevationSettings& settings) {
  Task task;
  return elevation_svg(walls::segmentation_of({}), m, settings, task);
}

std::set<std::string> ids_of(const std::string& svg) {
  std::set<std::string> out;
  for (const markup::Tag& tag : markup::tags(svg))
    if (!tag.attribute("id").empty()) out.insert(tag.attribute("id"));
  return out;
}

}  // namespace

TEST_CASE("svg__drawings_in_one_page_refer_to_their_own_patterns_only") {
  named_facade::Setting s;
  s.columns = 2;
  const Model m = named_facade::make(s);
  std::set<std::string> all;
  for (const int64_t facade : {0, 1}) {
    ElevationSettings settings;
    settings.facade = facade;
    const std::string svg = svg_with(m, settings);
    const std::set<std::string> ids = ids_of(svg);
    CHECK(ids.size() == 2);
    for (const std::string& id : ids) CHECK(all.insert(id).second);
    size_t references = 0;
    for (size_t at = svg.find("url(#"); at != std::string::npos; at = svg.find("url(#", at + 1)) {
      CHECK(ids.count(svg.substr(at + 5, svg.find(')', at) - at - 5)) == 1);
      ++references;
    }
    CHECK(references >= 2);  // the clip and the place without data
  }
}

TEST_CASE("svg__the_table_of_settings_starts_from_their_defaults_and_refuses_other_papers") {
  const ElevationSettings plain, read = settings_of("{}");
  CHECK(read.title == plain.title);
  CHECK(read.paper == plain.paper);
  CHECK(read.limits.front_angle_rad == plain.limits.front_angle_rad);
  CHECK(read.type_tolerance_m == plain.type_tolerance_m);
  CHECK(read.colours == plain.colours);
  CHECK(read.labels == plain.labels);
  CHECK(settings_of(R"({"behind_m": 3, "colours": "none"})").limits.behind_m == 3);
  for (const char* json : {R"({"paper": "A5"})", R"({"colours": "red"})", R"({"scale": -1})",
                           R"({"front_angle_rad": 1.2})"}) {
    CAPTURE(json);
    const std::string text = json, name = text.substr(2, text.find('"', 2) - 2);
    CHECK(test::refuses([&] { settings_of(json); }, Status::kInvalidArgument, name));
  }
}

TEST_CASE("svg__north_is_that_of_a_map_and_a_local_system_has_an_axis") {
  const Model m = named_facade::make({});
  for (const auto& expected : {std::pair{"", "view from +Y"},
                               {"EPSG:2154", "view from north"},
                               {"LOCAL_CS[\"scene, metres\",UNIT[\"metre\",1]]", "view from +Y"}}) {
    CAPTURE(expected.first);
    Segmentation segmentation = walls::segmentation_of({});
    Cloud cloud = *segmentation.cloud;
    cloud.crs = expected.first;
    segmentation.cloud = std::make_shared<const Cloud>(cloud);
    Task task;
    CHECK(elevation_svg(segmentation, m, {}, task).find(expected.second) != std::string::npos);
  }
}

TEST_CASE("svg__a_figure_has_no_title_block_and_the_same_drawing_as_the_sheet") {
  const Model m = named_facade::make({});
  ElevationSettings settings;
  const std::string sheet = svg_with(m, settings);
  settings.outlines_only = true;
  const std::string figure = svg_with(m, settings);
  CHECK(markup::well_formed(figure));
  CHECK(drawn::places(sheet, "Units; drawn by").size() == 1);
  CHECK(drawn::places(figure, "Units; drawn by").empty());
  for (const char* name : {"face", "opening"}) {
    const auto on_sheet = drawn::elements(sheet, "path", "class", name),
               on_figure = drawn::elements(figure, "path", "class", name);
    REQUIRE(!on_sheet.empty());
    REQUIRE(on_sheet.size() == on_figure.size());
    for (size_t i = 0; i < on_sheet.size(); ++i)
      CHECK(on_sheet[i].attribute("fill") == on_figure[i].attribute("fill"));
  }
  // It is smaller than the paper, and all its texts lie on it.
  const auto size_of_page = [](const std::string& svg) {
    const std::string box = markup::tags(svg)[0].attribute("viewBox");
    const size_t gap = box.find(' ', 4);
    return Vec2{markup::number(box.substr(4, gap - 4)), markup::number(box.substr(gap + 1))};
  };
  const auto [width, height] = size_of_page(figure);
  CHECK(width < size_of_page(sheet).u);
  CHECK(height < size_of_page(sheet).v);
  for (const markup::TextBox& text : markup::text_boxes(figure)) {
    CAPTURE(text.text);
    CHECK((text.left >= 0 && text.right <= width && text.top >= 0 && text.bottom <= height));
  }
}

TEST_CASE("svg__a_cancelled_drawing_ends_with_that_status") {
  std::atomic<bool> cancel = true;
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  const Segmentation segmentation = walls::segmentation_of({});
  const auto draw = [&] { elevation_svg(segmentation, named_facade::make({}), {}, task); };
  CHECK(test::refuses(draw, Status::kCancelled, ""));
}
