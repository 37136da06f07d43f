// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Layouts of random windows: what must hold of their boxes, and scales against the list of usual ones tried one by one.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "report/sheet/sheet.h"

using namespace jalon;

namespace {

constexpr double kSlack_mm = 1e-9;  // rounding of sums of some hundred millimetres
constexpr const char* kSheetPapers[] = {"A4", "A3", "A2", "A1", "A0"};

bool holds(const Box_mm& outer, const Box_mm& inner) {
  return inner.x >= outer.x - kSlack_mm && inner.y >= outer.y - kSlack_mm &&
         inner.right() <= outer.right() + kSlack_mm && inner.bottom() <= outer.bottom() + kSlack_mm;
}

// The window with its margins, legend and strip lie in the frame, clear of each other, and the frame on the paper.
void check_sheet(const Sheet& s, double width_m, double height_m, const Margins_mm& m) {
  CHECK(s.view.width == doctest::Approx(1000 * width_m / static_cast<double>(s.denominator)));
  CHECK(s.view.height == doctest::Approx(1000 * height_m / static_cast<double>(s.denominator)));
  const Box_mm drawing{s.view.x - m.left, s.view.y - m.above, m.left + s.view.width + m.right,
                       m.above + s.view.height + m.below};
  CHECK(holds({0, 0, s.width, s.height}, s.frame));
  for (const Box_mm& box : {drawing, s.legend, s.strip}) CHECK(holds(s.frame, box));
  CHECK(drawing.right() <= s.legend.x + kSlack_mm);
  CHECK(drawing.bottom() <= s.strip.y + kSlack_mm);
  CHECK(s.legend.bottom() <= s.strip.y + kSlack_mm);
}

std::vector<int64_t> usual_denominators() {
  std::vector<int64_t> out{1, 2, 5};
  for (int64_t power = 10; power <= 1000000; power *= 10)
    for (const int64_t factor : {10, 20, 25, 50}) out.push_back(factor * power / 10);
  return out;
}

}  // namespace

TEST_CASE("sheet__parts_lie_on_the_paper_clear_of_each_other") {
  RandomStream random(1, 0);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    const double width = std::pow(10, 4 * random.uniform() - 1),
                 height = std::pow(10, 4 * random.uniform() - 1);
    const Margins_mm margins{17, 14 + 10 * random.uniform(), 12 + 15 * random.uniform(),
                             11 + 20 * random.uniform()};
    const uint64_t paper = random.below(6);
    const int64_t scale = random.below(3) == 0 ? 50 : 0;
    check_sheet(
        lay_out_sheet(width, height, paper == 5 ? "auto" : kSheetPapers[paper], scale, margins),
        width, height, margins);
  }
}

TEST_CASE("sheet__the_scale_is_the_largest_usual_one_that_the_paper_holds") {
  const auto scales = usual_denominators();
  RandomStream random(2, 0);
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    const double width = std::pow(10, 4 * random.uniform() - 1),
                 height = std::pow(10, 4 * random.uniform() - 1);
    const char* paper = kSheetPapers[random.below(5)];
    const Sheet s = lay_out_sheet(width, height, paper, 0);
    CHECK(s.paper.substr(0, 2) == paper);
    const auto at = std::find(scales.begin(), scales.end(), s.denominator);
    REQUIRE(at != scales.end());
    // Any larger scale asks for a paper of its own size.
    for (auto larger = scales.begin(); larger != at; ++larger)
      CHECK(lay_out_sheet(width, height, paper, *larger).paper == "own size");
    CHECK(lay_out_sheet(width, height, paper, s.denominator).paper == s.paper);
  }
}

TEST_CASE("sheet__auto_is_a3_or_a_smaller_paper_that_holds_the_same_scale") {
  RandomStream random(3, 0);
  size_t small = 0, office = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const double width = 1 + 99 * random.uniform(), height = 1 + 29 * random.uniform();
    const Sheet s = lay_out_sheet(width, height, "auto", 0),
                a3 = lay_out_sheet(width, height, "A3", 0),
                a4 = lay_out_sheet(width, height, "A4", 0);
    CHECK(s.denominator == a3.denominator);
    CHECK(s.paper == (a4.denominator == a3.denominator ? a4.paper : a3.paper));
    small += s.paper == "A4";
    office += s.paper.substr(0, 2) == "A3";
  }
  CHECK(small > 10);  // both occur
  CHECK(office > 10);
  // Twice as high as wide: upright.
  CHECK(lay_out_sheet(12, 30, "auto", 0).paper == "A3 upright");
  CHECK(lay_out_sheet(30, 12, "auto", 0).paper == "A3");
}

TEST_CASE("sheet__a_figure_is_as_small_as_its_content_and_has_room_for_its_legend") {
  RandomStream random(4, 0);
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    const double width = std::pow(10, 4 * random.uniform() - 1),
                 height = std::pow(10, 4 * random.uniform() - 1), legend = 200 * random.uniform();
    const Sheet s = lay_out_figure(width, height, {}, legend);
    CHECK(s.paper.empty());
    CHECK(s.view.width == doctest::Approx(s.mm_of(width)));
    CHECK(s.width <= 250);
    CHECK(s.legend.height >= legend);
    const Box_mm page{0, 0, s.width, s.height};
    for (const Box_mm& box : {s.view, s.legend, s.strip}) CHECK(holds(page, box));
    CHECK(s.view.right() <= s.legend.x);
    CHECK(s.view.bottom() <= s.strip.y);
    // Not smaller than the next usual scale, 2.5 times as large, would have made it too large.
    CHECK((s.denominator == 1 || 2.5 * std::max(s.view.width, s.view.height) >= 170 - kSlack_mm));
  }
}
