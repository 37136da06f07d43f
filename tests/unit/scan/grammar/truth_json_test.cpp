// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/json_reader.h"
#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("truth_json__says_all_of_the_truth_and_reads_back") {
  Task task;
  const FacadeTruth truth =
      facade_truth(grammar_scene(FacadeKind::kLoggias, 2, {.spacing_m = 0.05}), {}, task);
  const std::vector<JsonValue> json = read_json(json_of(truth));
  const auto at = [](const JsonValue& object, const char* name) -> const JsonValue& {
    const JsonValue* found = find_member(object, name);
    REQUIRE(found != nullptr);
    return *found;
  };
  CHECK(at(json[0], "shape").text == "jalon facade truth 1");
  CHECK(at(json[0], "kind").text == "loggias");
  CHECK(at(json[0], "seed").integer == 2);
  size_t w = 0;
  for (const JsonValue& wall : JsonChildren(at(json[0], "walls"))) {
    const TruthWall& own = truth.walls.at(w++);
    CHECK(at(wall, "name").text == own.name);
    CHECK(at(wall, "area_m2").number == own.area_m2);
    CHECK(at(wall, "seen_share").number == own.seen_share);
    std::string cells;
    for (const JsonValue& row : JsonChildren(at(at(wall, "raster"), "rows"))) cells += row.text;
    REQUIRE(cells.size() == own.raster.cells.size());
    for (size_t c = 0; c < cells.size(); ++c)
      CHECK(cells[c] == static_cast<char>(own.raster.cells[c]));
  }
  CHECK(w == truth.walls.size());
  size_t i = 0;
  for (const JsonValue& opening : JsonChildren(at(json[0], "openings"))) {
    const TruthOpening& own = truth.openings.at(i++);
    CHECK(at(opening, "class").text == name_of(own.opening_class));
    CHECK(at(opening, "spacing_m").number == own.spacing_m);
    CHECK(at(opening, "touches_ground").flag == own.touches_ground);
    size_t k = 0;
    for (const JsonValue& corner : JsonChildren(at(opening, "contour"))) {
      std::vector<double> numbers;
      for (const JsonValue& number : JsonChildren(corner)) numbers.push_back(number.number);
      CHECK(numbers == std::vector<double>{own.contour[k].at.u, own.contour[k].at.v,
                                           own.contour[k].sagitta_m});
      ++k;
    }
  }
  CHECK(i == truth.openings.size());
}
