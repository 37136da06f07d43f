// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Steps and marks against the list of 1, 2, 5 times powers of ten.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "base/random.h"
#include "report/sheet/ticks.h"
#include "unit/report/markup.h"

using namespace jalon;

namespace {

// 1e-6, 2e-6, 5e-6 ... 5e6, as the compiler reads them.
const std::vector<double>& steps_125() {
  static const std::vector<double> steps = [] {
    std::vector<double> out;
    for (int power = -6; power <= 6; ++power)
      for (const char* digit : {"1", "2", "5"})
        out.push_back(markup::number(digit + ("e" + std::to_string(power))));
    return out;
  }();
  return steps;
}

}  // namespace

TEST_CASE("ticks__round_up_125_is_the_next_of_the_list") {
  for (const double step : steps_125()) {
    CAPTURE(step);
    CHECK(round_up_125(step) == doctest::Approx(step).epsilon(1e-14).scale(0));
    if (step < 2e6)  // a step that rounding has made a little larger is still itself
      CHECK(round_up_125(step * (1 + 1e-12)) == doctest::Approx(step).epsilon(1e-11).scale(0));
  }
  RandomStream random(1, 0);
  for (int i = 0; i < 1000; ++i) {
    const double value = std::pow(10, 12 * random.uniform() - 6);
    const auto next = std::lower_bound(steps_125().begin(), steps_125().end(), value * (1 - 1e-9));
    CHECK(round_up_125(value) == doctest::Approx(*next).epsilon(1e-14).scale(0));
  }
}

TEST_CASE("ticks__marks_are_all_multiples_within_the_range_at_the_finest_step_allowed") {
  RandomStream random(2, 0);
  for (int trial = 0; trial < 500; ++trial) {
    CAPTURE(trial);
    const double from = 2000 * (random.uniform() - 0.5),
                 width = std::pow(10, 5 * random.uniform() - 2),
                 min_step = width * std::pow(10, -2.5 * random.uniform());
    const Ticks ticks = make_ticks(from, from + width, min_step);
    const auto step = std::lower_bound(steps_125().begin(), steps_125().end(), min_step);
    REQUIRE(ticks.step == doctest::Approx(*step).epsilon(1e-14).scale(0));
    // As many as multiples counted one by one; the ends of random ranges are none of them.
    size_t count = 0;
    for (double k = std::ceil(from / *step); k * *step <= from + width; ++k) ++count;
    REQUIRE(ticks.values.size() == count);
    std::set<std::string> labels;
    for (const double value : ticks.values) {
      const double multiple = value / ticks.step;
      CHECK(std::fabs(multiple - std::round(multiple)) < 1e-6);
      CHECK(std::fabs(markup::number(ticks.label(value)) - value) < 1e-6 * ticks.step);
      labels.insert(ticks.label(value));
    }
    CHECK(labels.size() == count);
  }
}

TEST_CASE("ticks__ends_that_are_multiples_are_marked_and_zero_has_no_sign") {
  const Ticks ticks = make_ticks(-0.3, 0.3, 0.1);
  REQUIRE(ticks.values.size() == 7);
  const char* labels[] = {"-0.3", "-0.2", "-0.1", "0.0", "0.1", "0.2", "0.3"};
  for (size_t i = 0; i < 7; ++i) CHECK(ticks.label(ticks.values[i]) == labels[i]);
  CHECK(make_ticks(5, 5, 1).values == std::vector<double>{5});
  CHECK(make_ticks(5.5, 5.6, 1).values.empty());
}

TEST_CASE("ticks__of_impossible_ranges_there_are_none_and_never_too_many") {
  CHECK(make_ticks(1, 0, 0.1).values.empty());
  CHECK(make_ticks(NAN, 1, 0.1).values.empty());
  CHECK(make_ticks(0, INFINITY, 0.1).values.empty());
  for (const double min_step : {0.0, -1.0, 1e-300}) {
    const Ticks ticks = make_ticks(0, 1, min_step);
    CHECK(ticks.values.size() <= 1000);
    CHECK(ticks.values.size() >= 400);  // at most 2.5 times the thousandth part
    CHECK(ticks.values.front() == 0);
  }
}
