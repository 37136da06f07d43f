// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Axes and bars against the numbers that their labels tell.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"
#include "report/charts/histogram_plot.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

HistogramPlot plot_of_counts(double from_mm, double to_mm, double most) {
  HistogramPlot out{10, from_mm, to_mm};
  out.most = most;
  return out;
}

std::string axes_of(const HistogramPlot& plot) {
  return drawn::svg_of([&](SvgWriter& svg) { draw_axes(svg, plot, "what"); });
}

// The labels that are numbers: below the plot, or left of it.
std::vector<markup::Tag> axis_labels(const std::string& svg, bool below) {
  std::vector<markup::Tag> out;
  for (const markup::Tag& tag : drawn::elements(svg, "text")) {
    double value = 0;
    if (parse_number(tag.text_after, value) && (tag.attribute("text-anchor") == "middle") == below)
      out.push_back(tag);
  }
  return out;
}

}  // namespace

TEST_CASE("histogram_plot__labels_stand_where_their_numbers_belong") {
  RandomStream random(5, 0);
  for (int trial = 0; trial < 100; ++trial) {
    const double from = 40 * (random.uniform() - 0.5),
                 width = std::pow(10, 4 * random.uniform() - 1),
                 most = std::pow(10, 6 * random.uniform());
    CAPTURE(trial);
    const HistogramPlot plot = plot_of_counts(from, from + width, most);
    const std::string svg = axes_of(plot);
    REQUIRE(markup::well_formed(svg));
    const auto across = axis_labels(svg, true), upward = axis_labels(svg, false);
    CHECK(across.size() >= 2);  // of a dozen steps at most 2.5 times as long
    CHECK(upward.size() >= 2);
    for (const markup::Tag& tag : across) {
      const double share = (markup::number(tag.text_after) - from) / width;
      const double shown = (drawn::number(tag, "x") - HistogramPlot::kLeft) /
                           (HistogramPlot::kRight - HistogramPlot::kLeft);
      CHECK(std::fabs(share - shown) < 1e-4);  // labels are exact, places to 1 / 300000 of the axis
    }
    for (const markup::Tag& tag : upward) {
      const double count = markup::number(tag.text_after);
      CHECK(count == std::floor(count));  // points are whole
      const double shown =
          (HistogramPlot::kBottom + 1 - drawn::number(tag, "y")) / (HistogramPlot::kBottom - 10);
      CHECK(std::fabs(count / most - shown) < 1e-4);
    }
  }
}

TEST_CASE("histogram_plot__counts_above_the_window_end_at_its_top") {
  const HistogramPlot plot = plot_of_counts(-3, 5, 20);
  CHECK(plot.x(-3) == HistogramPlot::kLeft);
  CHECK(plot.x(5) == HistogramPlot::kRight);
  CHECK(plot.x(1) == doctest::Approx((HistogramPlot::kLeft + HistogramPlot::kRight) / 2));
  CHECK(plot.y(0) == HistogramPlot::kBottom);
  CHECK(plot.y(20) == 10);
  CHECK(plot.y(2000) == 10);
}

TEST_CASE("histogram_plot__bars_tile_the_axis_and_empty_bins_have_none") {
  const std::vector<uint64_t> bins{3, 0, 12, 6, 0};
  const HistogramPlot plot = plot_of_counts(0, 10, 12);
  const std::string svg = drawn::svg_of([&](SvgWriter& out) { draw_bars(out, plot, bins); });
  const auto bars = drawn::elements(svg, "rect");
  REQUIRE(bars.size() == 3);
  const double width = (HistogramPlot::kRight - HistogramPlot::kLeft) / 5;
  const size_t place[] = {0, 2, 3};
  const double tallest = HistogramPlot::kBottom - 10;
  for (size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(std::fabs(drawn::number(bars[i], "width") - width) <= drawn::kRounding_mm);
    CHECK(std::fabs(drawn::number(bars[i], "x") - HistogramPlot::kLeft -
                    static_cast<double>(place[i]) * width) <= drawn::kRounding_mm);
    CHECK(std::fabs(drawn::number(bars[i], "height") -
                    static_cast<double>(bins[place[i]]) / 12 * tallest) <= drawn::kRounding_mm);
    CHECK(std::fabs(drawn::number(bars[i], "y") + drawn::number(bars[i], "height") -
                    HistogramPlot::kBottom) <= 2 * drawn::kRounding_mm);
  }
  CHECK(drawn::svg_of([&](SvgWriter& out) { draw_bars(out, plot, {}); }).empty());
}
