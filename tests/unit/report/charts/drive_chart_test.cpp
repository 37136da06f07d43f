// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/drive_chart.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace jalon;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

size_t count(const std::string& text, const std::string& what) {
  size_t n = 0;
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++n;
  return n;
}

}  // namespace

TEST_CASE("drive_chart__of_one_time_is_nothing") {
  const double times[] = {5};
  CHECK(drive_chart("t", times, {}, DriveAxis::kFromZero).empty());
}

TEST_CASE("drive_chart__counts_time_from_the_start_and_has_zero_on_its_axis") {
  const double times[] = {345600, 345610, 345620};
  const DriveCurve curves[] = {{"east", "#000000", false, {0.2, 0.3, 0.4}}};
  const std::string chart = drive_chart("t", times, curves, DriveAxis::kFromZero);
  CHECK(chart.find(">0<") != std::string::npos);
  CHECK(chart.find(">20<") != std::string::npos);
  CHECK(chart.find(">400<") != std::string::npos);
  CHECK(chart.find("3456") == std::string::npos);
}

TEST_CASE("drive_chart__leaves_a_gap_where_a_value_is_missing") {
  const double times[] = {0, 1, 2, 3, 4};
  const DriveCurve whole[] = {{"east", "#123456", false, {1, 2, 3, 2, 1}}},
                   broken[] = {{"east", "#123456", false, {1, 2, kNone, 2, 1}}};
  const auto lines = [&](std::span<const DriveCurve> curves, DriveAxis axis) {
    return count(drive_chart("t", times, curves, axis), "stroke=\"#123456\"") - 1;  // the key
  };
  CHECK(lines(whole, DriveAxis::kFromZero) == 1);
  CHECK(lines(broken, DriveAxis::kFromZero) == 2);
  const DriveCurve nought[] = {{"east", "#123456", false, {1, 2, 0, 2, 1}}};
  CHECK(lines(nought, DriveAxis::kFromZero) == 1);
  CHECK(lines(nought, DriveAxis::kLogarithmic) == 2);
}

TEST_CASE("drive_chart__of_logarithms_tells_apart_what_is_many_times_smaller") {
  const double times[] = {0, 1};
  const DriveCurve curves[] = {{"before", "#000000", true, {1, 1}},
                               {"after", "#000000", false, {0.012, 0.012}}};
  const std::string chart = drive_chart("t", times, curves, DriveAxis::kLogarithmic);
  for (const char* level : {">10<", ">20<", ">100<", ">1000<"})
    CHECK(chart.find(level) != std::string::npos);
}

TEST_CASE("drive_chart__thins_hours_of_epochs") {
  std::vector<double> times(1000000);
  for (size_t i = 0; i < times.size(); ++i) times[i] = 0.01 * static_cast<double>(i);
  const DriveCurve curves[] = {{"east", "#000000", false, std::vector<double>(times.size(), 0.1)}};
  CHECK(drive_chart("t", times, curves, DriveAxis::kFromZero).size() < 100000);
}
