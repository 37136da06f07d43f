// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Statistics part by part, against sums over sorted values in longer numbers.
#include "compare/distance/part_statistics.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.h"
#include "base/random.h"

using namespace jalon;

namespace {

FieldTable statistics_of(const std::vector<double>& distances, const std::vector<uint32_t>& parts,
                         size_t part_count, double tolerance_m = 0) {
  Task task;
  return part_statistics(distances, parts, part_count, tolerance_m, task);
}

double cell_of(const FieldTable& table, const char* column, size_t row) {
  return table.require(column).number(row);
}

}  // namespace

TEST_CASE("part_statistics__equal_those_of_the_values_of_each_part") {
  constexpr uint32_t kParts = 5;
  RandomStream random(1, 0);
  std::vector<double> distances;
  std::vector<uint32_t> parts;
  std::vector<std::vector<double>> by_part(kParts);
  for (int i = 0; i < 70000; ++i) {  // more than one look at the task
    const double d = random.below(20) == 0 ? kNaN : 0.1 * random.normal();
    const auto part = static_cast<uint32_t>(random.below(kParts + 2));  // two that there are not
    distances.push_back(d);
    parts.push_back(part == kParts + 1 ? ~uint32_t{0} : part);
    if (part < kParts && !std::isnan(d)) by_part[part].push_back(d);
  }
  const FieldTable table = statistics_of(distances, parts, kParts, 0.07);
  for (uint32_t p = 0; p < kParts; ++p) {
    std::vector<double>& values = by_part[p];
    std::ranges::sort(values);
    long double sum = 0, squares = 0;
    size_t within = 0;
    for (const double v : values) sum += v, within += v >= -0.07 && v <= 0.07 ? 1 : 0;
    const auto n = static_cast<long double>(values.size());
    for (const double v : values) squares += (v - sum / n) * (v - sum / n);
    // n roundings of sums that stay below 100 m, over n.
    CHECK(std::abs(cell_of(table, "mean", p) - static_cast<double>(sum / n)) < 1e-14);
    CHECK(
        cell_of(table, "sigma", p) ==
        doctest::Approx(static_cast<double>(std::sqrt(squares / (n - 1)))).epsilon(1e-11).scale(0));
    CHECK(cell_of(table, "part", p) == p);
    CHECK(cell_of(table, "points", p) == static_cast<double>(values.size()));
    CHECK(cell_of(table, "minimum", p) == values.front());
    CHECK(cell_of(table, "maximum", p) == values.back());
    CHECK(cell_of(table, "maximum_absolute", p) == std::max(-values.front(), values.back()));
    CHECK(cell_of(table, "within_tolerance", p) == static_cast<double>(within));
    CHECK(cell_of(table, "tolerance_share", p) ==
          static_cast<double>(within) / static_cast<double>(values.size()));
  }
}

TEST_CASE("part_statistics__of_no_points_and_of_one_are_nan_where_nothing_can_be_said") {
  const FieldTable table = statistics_of({kNaN, -3, kNaN}, {0, 1, 2}, 3, 0.5);
  for (const size_t empty : {size_t{0}, size_t{2}}) {
    CHECK(cell_of(table, "points", empty) == 0);
    for (const char* name :
         {"mean", "sigma", "minimum", "maximum", "maximum_absolute", "tolerance_share"})
      CHECK(std::isnan(cell_of(table, name, empty)));
    CHECK(cell_of(table, "within_tolerance", empty) == 0);
  }
  CHECK(cell_of(table, "mean", 1) == -3);
  CHECK(cell_of(table, "maximum_absolute", 1) == 3);
  CHECK(std::isnan(cell_of(table, "sigma", 1)));
  CHECK(cell_of(table, "tolerance_share", 1) == 0);
  CHECK(statistics_of({}, {}, 0).require("part").count() == 0);
}

TEST_CASE("part_statistics__keep_a_small_spread_about_a_large_mean_and_judge_only_if_asked") {
  std::vector<double> distances;
  for (int i = 0; i < 1000; ++i) distances.push_back(1e6 + (i % 2 == 0 ? 0x1p-10 : -0x1p-10));
  const std::vector<uint32_t> parts(1000, 0);
  const FieldTable table = statistics_of(distances, parts, 1);
  CHECK(cell_of(table, "mean", 0) == 1e6);  // the roundings of these sums are none: 2^-10 of 1e9
  CHECK(cell_of(table, "sigma", 0) ==
        doctest::Approx(0x1p-10 * std::sqrt(1000.0 / 999)).epsilon(1e-12).scale(0));
  CHECK(table.find("within_tolerance") == nullptr);
  CHECK(table.find("tolerance_share") == nullptr);
  // Exactly the tolerance is within it, on either side.
  CHECK(cell_of(statistics_of({0.5, -0.5, 0.5000001}, {0, 0, 0}, 1, 0.5), "within_tolerance", 0) ==
        2);
}
