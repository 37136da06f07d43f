// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Places of the curves' points against the logarithms of the values and the labels of the axis.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "report/charts/convergence_chart.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

FieldTable iteration_log(const std::vector<std::pair<const char*, std::vector<double>>>& columns) {
  FieldTable out;
  for (const auto& [name, values] : columns)
    out.set(make_column<double>({name, ElementType::kFloat64, 1, "m", ""}, values));
  return out;
}

// The key's line of a curve gives its colour.
std::vector<markup::Tag> points_of_curve(const std::string& svg, const char* name) {
  double key = NAN;
  for (const Vec2& p : drawn::places(svg, name)) key = p.u;
  for (const markup::Tag& line : drawn::elements(svg, "line"))
    if (std::fabs(drawn::number(line, "x2") - key) < 2)
      return drawn::elements(svg, "circle", "fill", line.attribute("stroke"));
  return {};
}

}  // namespace

TEST_CASE("convergence_chart__of_a_log_without_residuals_is_nothing") {
  CHECK(convergence_chart({}).empty());
  CHECK(convergence_chart(iteration_log({{"shift", {0.1, 0.01}}})).empty());
  CHECK(convergence_chart(iteration_log({{"rms", {}}})).empty());
  const std::string one = convergence_chart(iteration_log({{"rms", {0.02}}}));
  CHECK(markup::well_formed(one));
  CHECK(drawn::elements(one, "circle").size() == 1);
}

TEST_CASE("convergence_chart__equal_ratios_are_equal_steps_and_the_axis_reads_them") {
  const std::string svg = convergence_chart(iteration_log({{"rms", {0.1, 0.01, 0.001, 0.0001}}}));
  CHECK(markup::well_formed(svg));
  const auto points = points_of_curve(svg, "rms residual");
  REQUIRE(points.size() == 4);
  const double step = drawn::number(points[1], "cy") - drawn::number(points[0], "cy");
  CHECK(step > 5);  // falls down the page
  const char* labels[] = {"100", "10", "1", "0.1"};
  for (size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    const double y = drawn::number(points[i], "cy");
    CHECK(std::fabs(y - drawn::number(points[0], "cy") - static_cast<double>(i) * step) <=
          4 * drawn::kRounding_mm);
    size_t beside = 0;
    for (const Vec2& p : drawn::places(svg, labels[i]))
      beside += std::fabs(p.v - y) < 1.4;  // half the height of its letters
    CHECK(beside == 1);
    // The number of the iteration stands below its point.
    bool has_number = false;
    for (const Vec2& p : drawn::places(svg, std::to_string(i + 1)))
      has_number |= std::fabs(p.u - drawn::number(points[i], "cx")) <= 2 * drawn::kRounding_mm;
    CHECK(has_number);
  }
}

TEST_CASE("convergence_chart__values_without_a_logarithm_leave_a_gap") {
  const std::string svg = convergence_chart(
      iteration_log({{"rms", {0.03, 0.02, 0.01, 0.005}}, {"shift", {0, 0.004, NAN, 0.5}}}));
  CHECK(markup::well_formed(svg));
  CHECK(drawn::places(svg, "limit of residuals").empty());
  const auto rms = points_of_curve(svg, "rms residual"),
             shift = points_of_curve(svg, "shift of the step");
  REQUIRE(rms.size() == 4);
  REQUIRE(shift.size() == 2);
  // Each stays in the column of its iteration, and larger values stand higher on the common axis.
  CHECK(shift[0].attribute("cx") == rms[1].attribute("cx"));
  CHECK(shift[1].attribute("cx") == rms[3].attribute("cx"));
  CHECK(drawn::number(shift[0], "cy") > drawn::number(rms[3], "cy"));
  CHECK(drawn::number(shift[1], "cy") < drawn::number(rms[0], "cy"));
}
