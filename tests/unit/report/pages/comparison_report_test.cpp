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
  CHECK(!has(html, "Hausdorff"));  // the distances have signs
  CHECK(!has(html, ">Significance<"));
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
  CHECK(std::abs(number_after(all, sigma) - 2) < 0.3);  // of the body: the changes are not in it
  CHECK(has(all, "200 beyond 20.0 mm (9.09 %)"));
  const std::string asked = comparison_histogram(comparison, {.limit_m = 0.1}, task);
  CHECK(number_after(asked, sigma) > 10);  // as far as was asked for, the changes too
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

TEST_CASE("comparison_report__significance_tells_how_far_is_far_and_how_many_are") {
  Comparison forward = comparison_of(std::vector<double>(1000, 0.01));
  std::vector<uint8_t> significant(1000, 0);
  std::vector<float> level(1000);
  for (size_t i = 0; i < 1000; ++i) {
    level[i] = 1e-5F * static_cast<float>(i);
    significant[i] = i < 250 ? 1 : 0;
  }
  forward.points.set(make_column<uint8_t>({"significant"}, significant));
  forward.points.set(make_column<float>({"level_of_detection"}, level));
  Task task;
  const std::string html = comparison_html(forward, nullptr, {}, "", {}, task);
  CHECK(markup::well_formed(html));
  const auto table = tables_of(html, "Significance").at(0);
  REQUIRE(table.size() == 2);
  CHECK(table[1] == page_scenes::Row{"compared with the reference", "1 000", "250", "25.00", "0.49",
                                     "4.99", "9.49"});
  CHECK(has(html, "only what is significant"));
  CHECK(has(html, "directed Hausdorff distance"));
}
