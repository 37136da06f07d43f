// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/coded_report.h"

#include <doctest/doctest.h>

#include "modelling/codes/coded_model.h"
#include "report/report.h"
#include "unit/report/coded_house.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using namespace jalon::test;
using page_scenes::tables_of;

namespace {

std::string page_of_codes(const std::string& codes, const ReportSettings& settings = {}) {
  const Segmentation s = coded_house(codes);
  Task task;
  const Model model = model_coded_objects(s, {}, task);
  return report_html(s, model, R"({"title": "Codes <b>", "times": {"walls": 1.5}})", settings,
                     task);
}

}  // namespace

TEST_CASE("coded_report__stands_in_the_place_of_the_page_on_planes") {
  const std::string page =
      page_of_codes(std::string(kCodedHouse) + "13;1;0;0;888\n<i>;2;0;0;350\n");
  CHECK(markup::well_formed(page));
  const auto objects = tables_of(page, "Coded objects").at(0);
  REQUIRE(objects.size() == 5);
  CHECK(objects[1][1] == "building 1");
  CHECK(objects[1][5] == "4 corners, 3.00 m high");
  CHECK(objects[2][6] == "left");
  CHECK(objects[2][5] == "1.00 x 2.00 m");
  CHECK(objects[2][7] == "90");
  CHECK(objects[4][5] == "r 0.040 m, 2.80 m long");
  CHECK(objects[4][9] == "10 (408), 11 (409), 12 (410)");
  const auto warnings = tables_of(page, "Warnings").at(0);
  REQUIRE(warnings.size() ==
          5);  // no point at window and gutter, an unknown code, a door of one point
  CHECK(warnings[3][0] == "13");
  CHECK(page.find("&lt;i&gt;") != std::string::npos);
  const auto classes = tables_of(page, "Classes").at(0);
  CHECK(classes.size() == 6);
  CHECK(page.find("In three dimensions") != std::string::npos);
  CHECK(page.find("walls") != std::string::npos);
  const std::string bare = page_of_codes(kCodedHouse, {.picture = false, .viewer_points = 0});
  CHECK(bare.size() < 60000);
}
