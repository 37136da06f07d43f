// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The table of changes and the pages of each.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "report/pages/comparison_report.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::comparison_of;
using page_scenes::has;
using page_scenes::tables_of;

namespace {

std::string page_of_changes(const FieldTable& changes, bool has_pictures = false) {
  Task task;
  std::vector<double> distances(500, 0.002);
  for (size_t i = 100; i < 110; ++i) distances[i] = 0.3;
  const Comparison forward = comparison_of(distances);
  return comparison_html(forward, &forward, changes, "",
                         {.threshold_m = 0.1, .picture = has_pictures}, task);
}

FieldTable regions_of(size_t rows) {
  FieldTable out;
  std::vector<double> numbers(rows);
  for (size_t i = 0; i < rows; ++i) numbers[i] = static_cast<double>(i + 1);
  for (const char* name : {"area", "volume", "mean", "extreme"})
    add_column<double>(out, numbers, name, "", "", [](double v) { return 0.001 * v; });
  add_column<uint64_t>(out, numbers, "points", "", "", [](double v) { return v; });
  add_columns<double, 3>(out, numbers, "centroid", "m", "", [](double v, double* o) {
    o[0] = v;
    o[1] = -v;
    o[2] = NAN;
  });
  return out;
}

FieldTable two_changes() {
  FieldTable changes;
  const std::vector<int> classes{4, 1};
  add_column<uint8_t>(changes, classes, "class", "", "", [](int c) { return c; });
  for (const char* name :
       {"confidence", "area_before", "area_after", "volume_before", "volume_after"})
    add_column<double>(changes, classes, name, "", "", [](int c) { return 0.25 * c; });
  for (const char* name : {"centroid_before", "centroid_after", "displacement"})
    add_columns<double, 3>(changes, classes, name, "m", "", [](int c, double* o) {
      for (int k = 0; k < 3; ++k) o[k] = c == 4 ? 0.1 * (k + 1) : NAN;
    });
  // Of the displacement 1, 2 and 3 mm; those of the rotation are something else.
  add_columns<double, 36>(changes, classes, "covariance", "", "", [](int c, double* o) {
    for (int k = 0; k < 36; ++k) o[k] = c == 4 ? 7 : NAN;
    for (int k = 0; k < 3; ++k)
      if (c == 4) o[6 * (3 + k) + 3 + k] = 1e-6 * (k + 1) * (k + 1);
  });
  add_columns<double, 3>(changes, classes, "box_min", "m", "", [](int c, double* o) {
    for (int k = 0; k < 3; ++k) o[k] = c == 4 ? -1 : 90;
  });
  add_columns<double, 3>(changes, classes, "box_max", "m", "", [](int c, double* o) {
    for (int k = 0; k < 3; ++k) o[k] = c == 4 ? 9 : 91;
  });
  return changes;
}

}  // namespace

TEST_CASE("change_sections__regions_are_listed_up_to_500_and_their_number_is_told") {
  const std::string html = page_of_changes(regions_of(501));
  CHECK(markup::well_formed(html));
  const auto table = tables_of(html, "Change regions").at(0);
  REQUIRE(table.size() == 501);
  CHECK(table[500] ==
        page_scenes::Row{"500", "500", "0.500", "0.500", "500.00", "500.00", "500.00, -500.00, -"});
  CHECK(has(html, "The first 500 of 501."));
  CHECK(!has(page_of_changes(regions_of(500)), "The first 500"));
  CHECK(
      has(page_of_changes(regions_of(0)), "Nothing has changed by more than what was asked for."));
  CHECK(!has(page_of_changes({}), "Change regions"));
}

TEST_CASE("change_sections__the_table_has_seven_columns_and_the_page_of_a_change_the_rest") {
  const std::string html = page_of_changes(two_changes(), true);
  CHECK(markup::well_formed(html));
  const auto table = tables_of(html, "Changes").at(0);
  REQUIRE(table.size() == 3);
  CHECK(table[1] == page_scenes::Row{"1", "displacement with overlap", "1.00", "1.000, 1.000",
                                     "1.000, 1.000", "0.10, 0.20, 0.30", "0.374"});
  CHECK(table[2] == page_scenes::Row{"2", "appearance", "0.25", "0.250, 0.250", "0.250, 0.250",
                                     "-, -, -", "-"});
  const auto page = tables_of(html, "Change 1: displacement with overlap").at(0);
  CHECK(std::find(page.begin(), page.end(),
                  page_scenes::Row{"displacement (m)", "0.1000, 0.2000, 0.3000"}) != page.end());
  CHECK(std::find(page.begin(), page.end(),
                  page_scenes::Row{"its \xCF\x83 (mm)", "1.00, 2.00, 3.00"}) != page.end());
  CHECK(has(html, "before: the reference"));
  // Nothing changed where the second is said to be.
  CHECK(!has(html, "Change 2"));
  CHECK(!has(page_of_changes(two_changes()), "Change 1"));
}
