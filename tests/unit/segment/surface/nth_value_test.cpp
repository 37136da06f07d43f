// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/nth_value.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "base/random.h"

using namespace jalon;

TEST_CASE("nth_value__is_that_of_the_sorted_list") {
  RandomStream random(3, 1);
  std::vector<float> values{0.0f, 0.0f, 1e-30f, 3e30f};
  for (int i = 0; i < 150000; ++i)
    values.push_back(static_cast<float>(i % 3 == 0 ? 0.01 : 0.01 + 0.001 * random.uniform()));
  std::vector<float> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  Task task;
  const auto at = [&](size_t i) { return values[i]; };
  for (const size_t nth : {size_t{0}, size_t{2}, size_t{3}, size_t{49999}, size_t{50010},
                           size_t{120003}, sorted.size() - 2, sorted.size() - 1})
    CHECK(nth_value(values.size(), nth, at, task) == sorted[nth]);
  CHECK(nth_value(1, 0, at, task) == 0.0f);
}
