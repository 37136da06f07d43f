// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The page on a comparison: its tables against recounts, its noise law against the law that made the distances.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "report/pages/comparison_report.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::comparison_of;
using page_scenes::has;
using page_scenes::number_after;
using page_scenes::tables_of;

namespace {

std::vector<double> noisy_distances(size_t n, double sigma_m, uint64_t seed) {
  RandomStream random(seed, 11);
  std::vector<double> out(n);
  for (double& d : out) d = sigma_m * random.normal();
  return out;
}

std::string page_of_changes(const FieldTable& changes) {
  Task task;
  const Comparison forward = comparison_of(noisy_distances(100, 0.002, 1));
  return comparison_html(forward, nullptr, changes, "", {.picture = false}, task);
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

}  // namespace

TEST_CASE("comparison_report__summary_has_a_row_a_direction_with_recounted_numbers") {
  std::vector<double> distances = noisy_distances(1230, 0.002, 2);
  for (size_t i = 0; i < 30; ++i) distances[7 * i] = NAN;
  Comparison forward = comparison_of(distances);
  add_value<double>(forward.summary, "mean_lod", "m", "mean level of detection", 0.0042);
  double sum = 0, squares = 0;
  for (const double d : distances)
    if (std::isfinite(d)) sum += d, squares += d * d;
  const Comparison reverse = comparison_of(std::vector<double>(10, 0.25));
  Task task;
  const std::string html = comparison_html(forward, &reverse, {}, "", {}, task);
  CHECK(markup::well_formed(html));
  const auto table = tables_of(html, "Summary").at(0);
  REQUIRE(table.size() == 3);
  REQUIRE(table[1].size() == 12);
  CHECK(table[1][1] == "1 230");
  CHECK(table[1][2] == "1 200");
  CHECK(table[1][3] == "30");
  // Two decimals of a millimetre.
  CHECK(std::abs(markup::number(table[1][7]) - 1000 * sum / 1200) < 0.0051);
  CHECK(std::abs(markup::number(table[1][8]) - 1000 * std::sqrt(squares / 1200)) < 0.0051);
  CHECK(table[2][2] == "10");
  CHECK(table[2][7] == "250.00");
  CHECK(table[2][11] == "0.250");
  const auto precision = tables_of(html, "Precision and detection").at(0);
  REQUIRE(precision.size() == 1);
  CHECK(precision[0] == page_scenes::Row{"mean_lod: mean level of detection", "4.20 mm"});
  CHECK(has(html, ">Where<"));
  const std::string one = comparison_html(forward, nullptr, {}, "", {.picture = false}, task);
  CHECK(tables_of(one, "Summary").at(0).size() == 2);
  CHECK(!has(one, ">Where<"));
}

TEST_CASE("comparison_report__noise_law_is_that_of_the_distances_below_the_threshold") {
  std::vector<double> distances = noisy_distances(2000, 0.002, 3);
  distances.insert(distances.end(), 200, 0.05);
  const Comparison comparison = comparison_of(distances);
  const std::string sigma = "\xCF\x83 = ";
  Task task;
  const std::string quiet = comparison_histogram(comparison, {.threshold_m = 0.01}, task);
  CHECK(markup::well_formed(quiet));
  // Four standard deviations of an estimate from 2000 values.
  CHECK(std::abs(number_after(quiet, sigma) - 2) < 4 * 2 / std::sqrt(4000.0));
  CHECK(has(quiet, "threshold 10.0 mm"));
  CHECK(has(quiet, "threshold -10.0 mm"));  // the distances have signs
  const std::string all = comparison_histogram(comparison, {}, task);
  CHECK(number_after(all, sigma) > 10);  // the changes are in it
  CHECK(!has(all, "threshold"));
  for (double& d : distances) d = std::abs(d);
  const std::string unsigned_ones =
      comparison_histogram(comparison_of(distances), {.threshold_m = 0.01}, task);
  CHECK(has(unsigned_ones, "Weibull"));
  CHECK(!has(unsigned_ones, "threshold -10.0 mm"));
  const std::string still = comparison_histogram(comparison_of({0.1, 0.1, 0.1}), {}, task);
  CHECK(markup::well_formed(still));  // what does not scatter has bars and no law
  CHECK(has(still, "Histogram of the distances"));
  CHECK(!has(still, "Weibull"));
}

TEST_CASE("comparison_report__regions_are_listed_up_to_500_and_their_number_is_told") {
  const std::string html = page_of_changes(regions_of(501));
  CHECK(markup::well_formed(html));
  const auto table = tables_of(html, "Change regions").at(0);
  REQUIRE(table.size() == 501);
  CHECK(table[500] ==
        page_scenes::Row{"500", "500", "0.500", "0.500", "500.00", "500.00", "500.00, -500.00, -"});
  CHECK(has(html, "The first 500 of 501."));
  CHECK(!has(page_of_changes(regions_of(500)), "The first 500"));
  CHECK(has(page_of_changes(regions_of(0)), "Nothing has changed by more than the threshold."));
  CHECK(!has(page_of_changes({}), "Change regions"));
}

TEST_CASE("comparison_report__changes_have_their_class_and_the_sigma_of_their_displacement") {
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
  const auto table = tables_of(page_of_changes(changes), "Changes").at(0);
  REQUIRE(table.size() == 3);
  REQUIRE(table[1].size() == 11);
  CHECK(table[1][1] == "displacement with overlap");
  CHECK(table[1][9] == "0.100, 0.200, 0.300");
  CHECK(table[1][10] == "1.00, 2.00, 3.00");
  CHECK(table[2][1] == "appearance");
  CHECK(table[2][2] == "0.25");
  CHECK(table[2][10] == "-, -, -");
}
