// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/range_values.h"

#include <doctest/doctest.h>

#include <functional>

#include "base/random.h"

using namespace jalon;

TEST_CASE("range_values__sums_and_least_are_those_of_the_values_one_by_one") {
  RandomStream random(1, 0);
  for (const size_t n : {size_t{0}, size_t{1}, size_t{16}, size_t{17}, size_t{256}, size_t{5000}}) {
    std::vector<double> values(n);
    for (double& v : values) v = random.normal();
    const RangeValues<std::plus<>> sums(values, std::plus<>());
    const auto smaller = [](double a, double b) { return std::min(a, b); };
    const RangeValues<double (*)(double, double)> least(values, smaller);
    for (int k = 0; k < 500; ++k) {
      size_t first = random.below(n + 1), last = random.below(n + 1);
      if (first > last) std::swap(first, last);
      double sum = 2.5, low = 0.1;
      for (size_t i = first; i < last; ++i) sum += values[i], low = std::min(low, values[i]);
      CHECK(sums.over(first, last, 2.5) == doctest::Approx(sum).scale(1).epsilon(1e-12));
      CHECK(least.over(first, last, 0.1) == low);
    }
  }
}
