// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Bars, the curve of the law and thresholds against each other and the labels of the axis.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "report/charts/distance_chart.h"
#include "report/charts/histogram_plot.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

Histogram histogram_of(double from, double to, std::vector<uint64_t> counts) {
  Histogram out;
  out.from = from;
  out.to = to;
  out.counts = std::move(counts);
  for (const uint64_t n : out.counts) out.values += n;
  return out;
}

}  // namespace

TEST_CASE("distance_chart__the_curve_of_the_law_covers_the_area_of_the_bars") {
  NoiseLaw law;
  law.gauss_mean = 0.001;
  law.gauss_sigma = 0.002;
  constexpr int kBins = 100;  // a tenth of sigma each, to five sigma on both sides
  std::vector<uint64_t> counts;
  for (int i = 0; i < kBins; ++i) {
    const double from = -0.009 + 0.0002 * i;
    const double share = (std::erf((from + 0.0002 - 0.001) / 0.002 / std::sqrt(2.0)) -
                          std::erf((from - 0.001) / 0.002 / std::sqrt(2.0))) /
                         2;
    counts.push_back(static_cast<uint64_t>(std::lround(1e6 * share)));
  }
  const std::string svg = distance_chart(histogram_of(-0.009, 0.011, counts), &law, {});
  CHECK(markup::well_formed(svg));
  const auto paths = drawn::elements(svg, "path");
  REQUIRE(paths.size() == 1);
  const auto curve = drawn::corners(paths[0].attribute("d"));
  // The rounding of the bars' sides is what differs: 100 heights and widths to half a thousandth of a millimetre.
  const double area = drawn::bar_area(svg);
  CHECK(area > 100);
  CHECK(drawn::area_above(curve, HistogramPlot::kBottom) ==
        doctest::Approx(area).epsilon(0.002).scale(0));
  // Its crest stands over the law's mean: between the labels of 0 and 2 mm.
  Vec2 crest{0, INFINITY};
  for (const Vec2& p : curve)
    if (p.v < crest.v) crest = p;
  REQUIRE(drawn::places(svg, "0").size() >= 1);
  REQUIRE(drawn::places(svg, "2").size() == 1);
  const double step = 156.0 / 240;  // of the curve
  CHECK(std::fabs(crest.u - (drawn::places(svg, "0")[0].u + drawn::places(svg, "2")[0].u) / 2) <=
        step);
  CHECK(drawn::places(svg, "gauss, \xCF\x83 = 2.00 mm").size() == 1);
}

TEST_CASE("distance_chart__thresholds_stand_at_their_values_and_those_outside_do_not") {
  const std::vector<ChartMark> marks{{0.004, "limit"}, {-0.004, "low"}, {0.0101, "far"}};
  const std::string svg = distance_chart(histogram_of(-0.01, 0.01, {2, 0, 4, 1}), nullptr, marks);
  CHECK(markup::well_formed(svg));
  const auto paths = drawn::elements(svg, "path");
  REQUIRE(paths.size() == 2);  // no law, two marks
  const char* labels[] = {"4", "-4"};
  const char* texts[] = {"limit 4.0 mm", "low -4.0 mm"};
  for (size_t i = 0; i < 2; ++i) {
    const double x = drawn::corners(paths[i].attribute("d")).front().u;
    bool is_on_label = false;
    for (const Vec2& p : drawn::places(svg, labels[i]))
      is_on_label |= std::fabs(p.u - x) <= 2 * drawn::kRounding_mm;
    CHECK(is_on_label);
    CHECK(drawn::places(svg, texts[i]).size() == 1);
  }
  for (const markup::TextBox& box : markup::text_boxes(svg)) {
    CAPTURE(box.text);
    CHECK(box.left >= 0);
    CHECK(box.right <= HistogramPlot::kWidth);
  }
}

TEST_CASE("distance_chart__a_mark_near_the_right_end_is_written_to_its_left") {
  const std::vector<ChartMark> marks{{0.0099, "a threshold with a long name"}};
  const std::string svg = distance_chart(histogram_of(-0.01, 0.01, {1, 1}), nullptr, marks);
  size_t found = 0;
  for (const markup::TextBox& box : markup::text_boxes(svg)) {
    if (box.text.find("long name") == std::string::npos) continue;
    ++found;
    CHECK(box.right <= HistogramPlot::kRight);
  }
  CHECK(found == 1);
}

TEST_CASE("distance_chart__distances_of_one_value_still_have_an_axis_and_a_bar") {
  const std::string svg = distance_chart(histogram_of(0.005, 0.005, {3}), nullptr, {});
  CHECK(markup::well_formed(svg));
  const auto bars = drawn::elements(svg, "rect");
  REQUIRE(bars.size() == 1);
  CHECK(drawn::number(bars[0], "width") ==
        doctest::Approx(HistogramPlot::kRight - HistogramPlot::kLeft));
  CHECK(drawn::number(bars[0], "height") > 0);
}
