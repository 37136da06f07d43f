// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The normal curve against the bars of drawn numbers, and against the closed form of its crest.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "report/charts/histogram_plot.h"
#include "report/charts/residual_chart.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

// Draws of a normal distribution in bins, with the mean and sigma that they were drawn with.
Residuals drawn_residuals(double mean_m, double sigma_m, int draws) {
  Residuals out;
  out.count = static_cast<uint64_t>(draws);
  out.mean_m = mean_m;
  out.sigma_m = sigma_m;
  out.half_range_m = 0.02;
  out.bins.assign(40, 0);
  RandomStream random(8, 0);
  for (int i = 0; i < draws; ++i) {
    const double r = mean_m + sigma_m * random.normal();
    ++out.bins[static_cast<size_t>(std::floor((r + 0.02) / 0.001))];
  }
  return out;
}

std::vector<Vec2> curve_of(const std::string& svg) {
  const auto paths = drawn::elements(svg, "path");
  REQUIRE(paths.size() == 1);
  return drawn::corners(paths[0].attribute("d"));
}

}  // namespace

TEST_CASE("residual_chart__the_normal_curve_runs_through_the_bars_of_normal_residuals") {
  constexpr int kDraws = 40000;
  const Residuals residuals = drawn_residuals(0.003, 0.003, kDraws);
  const std::string svg = residual_chart(residuals);
  CHECK(markup::well_formed(svg));
  const auto curve = curve_of(svg);
  CHECK(curve.front().u == HistogramPlot::kLeft);
  CHECK(curve.back().u == HistogramPlot::kRight);
  // All draws lie in the bins (5 sigma and more on either side): both areas are those of all points.
  const double area = drawn::bar_area(svg);
  CHECK(drawn::area_above(curve, HistogramPlot::kBottom) ==
        doctest::Approx(area).epsilon(0.001).scale(0));
  const double point_mm = area / kDraws / ((HistogramPlot::kRight - HistogramPlot::kLeft) / 40);
  for (const markup::Tag& bar : drawn::elements(svg, "rect")) {
    const double middle = drawn::number(bar, "x") + drawn::number(bar, "width") / 2;
    const auto at = std::min_element(curve.begin(), curve.end(), [&](const Vec2& a, const Vec2& b) {
      return std::fabs(a.u - middle) < std::fabs(b.u - middle);
    });
    const double expected = (HistogramPlot::kBottom - at->v) / point_mm,
                 count = drawn::number(bar, "height") / point_mm;
    if (expected < 20) continue;
    // Poisson, and what the curve bends within a third of sigma: below 1 / 216 of its crest's height.
    CHECK(std::fabs(count - expected) < 4.5 * std::sqrt(expected) + kDraws * 0.133 / 200);
  }
}

TEST_CASE("residual_chart__the_crest_stands_over_the_mean_and_is_never_cut_off") {
  Residuals residuals = drawn_residuals(0.005, 0.001, 1000);
  residuals.bins.assign(40, 1);  // far below the curve
  const std::string svg = residual_chart(residuals);
  Vec2 crest{0, INFINITY};
  size_t highest = 0;
  for (const Vec2& p : curve_of(svg)) {
    if (p.v < crest.v) crest = p, highest = 0;
    highest += p.v == crest.v;
  }
  CHECK(highest == 1);
  // 5 mm of -20 ... 20 mm.
  const double x = HistogramPlot::kLeft + 0.625 * (HistogramPlot::kRight - HistogramPlot::kLeft);
  CHECK(std::fabs(crest.u - x) <= drawn::kRounding_mm);
  // A bar of one point is that part of the crest: 1000 points a bin of one sigma, 0.3989 of them at the mean.
  const auto bars = drawn::elements(svg, "rect");
  REQUIRE(bars.size() == 40);
  CHECK((HistogramPlot::kBottom - crest.v) / drawn::number(bars[0], "height") ==
        doctest::Approx(398.94).epsilon(0.005).scale(0));  // the bar is 0.138 mm to 0.0005
  CHECK(drawn::places(svg, "normal, \xCF\x83 = 1.00 mm").size() == 1);
}

TEST_CASE("residual_chart__residuals_without_spread_have_bars_but_no_curve") {
  Residuals residuals;
  residuals.count = 7;
  residuals.bins = {0, 7};
  const std::string svg = residual_chart(residuals);
  CHECK(markup::well_formed(svg));
  CHECK(drawn::elements(svg, "path").empty());
  CHECK(svg.find("normal,") == std::string::npos);
  REQUIRE(drawn::elements(svg, "rect").size() == 1);
}
