// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/sort_along.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "base/random.h"

using namespace jalon;

TEST_CASE("sort_along__gives_what_std_sort_gives_for_spread_crowded_equal_and_extreme_values") {
  RandomStream random(1, 0);
  std::vector<double> work;
  const auto equals_std_sort = [&](std::vector<double> values) {
    std::vector<double> expected = values;
    std::sort(expected.begin(), expected.end());
    sort_along(values, work);
    return values == expected;
  };
  for (size_t n = 0; n < 400; ++n) {
    std::vector<double> spread(n), crowded(n), stepped(n), tiny(n);
    for (size_t i = 0; i < n; ++i) {
      spread[i] = 2 * random.uniform() - 1;
      crowded[i] = i == 0 ? 1e6 : 0.003 * random.normal();  // all but one within one step
      stepped[i] = static_cast<double>(random.below(7)) - 3;
      tiny[i] = std::numeric_limits<double>::denorm_min() * static_cast<double>(random.below(5));
    }
    REQUIRE(equals_std_sort(spread));
    REQUIRE(equals_std_sort(crowded));
    REQUIRE(equals_std_sort(stepped));
    REQUIRE(equals_std_sort(tiny));
    std::ranges::sort(spread, std::greater());
    REQUIRE(equals_std_sort(spread));
    REQUIRE(equals_std_sort(std::vector<double>(n, 0.25)));
  }
}
