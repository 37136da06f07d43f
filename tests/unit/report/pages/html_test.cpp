// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The report's page: its table of planes and its lead sentence against the fits and recounts.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "report/report.h"
#include "unit/modelling/walls.h"
#include "unit/report/named_facade.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::has;
using page_scenes::number_after;
using page_scenes::tables_of;

namespace {

// A wall of 4 x 3 m and another behind it, turned and on a national grid.
Segmentation two_walls_of_page() {
  walls::WallScan front, back;
  front.width = 4;
  front.height = 3;
  front.spacing = 0.05;
  back = front;
  front.shift = {652000, 6861000, 30};
  back.shift = {652000, 6861002, 30};
  back.seed = 2;
  return walls::segmentation_of({front.points(), back.points()});
}

std::string page_of_segments(const Segmentation& segmentation, const Model& model,
                             const ReportSettings& settings = {}) {
  Task task;
  return report_html(segmentation, model, "", settings, task);
}

}  // namespace

TEST_CASE("html__the_table_of_planes_repeats_the_fits_to_its_last_digit") {
  const Segmentation s = two_walls_of_page();
  const auto table = tables_of(page_of_segments(s, {}, {.picture = false}), "Planes").at(0);
  REQUIRE(table.size() == 3);
  for (size_t i = 0; i < 2; ++i) {
    const PlaneFit& fit = s.segments[i].fit;
    const auto& row = table[i + 1];
    REQUIRE(row.size() == 8);
    CHECK(row[0] == std::to_string(i + 1));
    const auto normal = page_scenes::numbers_of(row[4]);
    REQUIRE(normal.size() == 3);
    for (size_t k = 0; k < 3; ++k)  // half of the last of five decimals, and what a float rounds
      CHECK(std::abs(normal[k] - fit.plane.normal[static_cast<int>(k)]) < 0.50001e-5);
    CHECK(std::abs(markup::number(row[5]) - fit.plane.offset) < 0.50001e-4);
    CHECK(std::abs(markup::number(row[6]) - 1000 * fit.sigma) < 0.50001e-2);
    CHECK(row[7] == std::to_string(fit.n));
  }
}

TEST_CASE("html__the_lead_tells_the_share_of_points_on_planes_and_their_sigma") {
  Segmentation s = two_walls_of_page();
  const size_t n = s.cloud->size();
  auto residuals = std::make_shared<Column>(s.residuals->info(), n);
  size_t noise = 0;
  for (size_t i = 0; i < n; ++i) {
    const bool is_noise = i % 4 == 0;
    residuals->values<float>()[i] = is_noise ? NAN : s.residuals->values<float>()[i];
    noise += is_noise;
  }
  s.residuals = residuals;
  const std::string html = page_of_segments(s, {}, {.picture = false});
  const double used = static_cast<double>(n - noise);
  CHECK(has(html, "2 planes from " + std::to_string(n) + " points"));
  CHECK(std::abs(number_after(html, " points; ") - 100 * used / static_cast<double>(n)) < 0.051);
  // Noise of 4 mm; four standard deviations of its estimate.
  CHECK(std::abs(number_after(html, "with a standard deviation of ") - 4) <
        16 / std::sqrt(2 * used));
  CHECK(has(html, std::to_string(n - noise) + " points, mean"));
}

TEST_CASE("html__drawing_and_picture_are_there_when_wanted_and_possible") {
  const Segmentation s = two_walls_of_page();
  const Model facade = named_facade::make({});
  const std::string all = page_of_segments(s, facade);
  CHECK(has(all, ">Elevation<"));
  CHECK(has(all, ">Labelled points<"));
  CHECK(has(all, "14 windows, 1 door and 0 other openings."));
  const std::string none = page_of_segments(s, facade, {.drawing = false, .picture = false});
  CHECK(!has(none, ">Elevation<"));
  CHECK(!has(none, ">Labelled points<"));
  CHECK(has(none, ">Openings<"));
  CHECK(!has(page_of_segments(s, {}), ">Elevation<"));
}

TEST_CASE("html__nothing_found_is_said_in_words") {
  const std::string html = page_of_segments(walls::segmentation_of({}), {});
  CHECK(markup::well_formed(html));
  for (const char* text :
       {"0 planes from 0 points; 0.0 %", "No plane was found.", "No point lies on a plane."})
    CHECK_MESSAGE(has(html, text), text);
  for (const char* text : {">Openings<", ">Parts<", ">Precision<", "Spheres and cylinders"})
    CHECK_MESSAGE(!has(html, text), text);
}
