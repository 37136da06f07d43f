// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/range_ranks.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.h"

using namespace jalon;

TEST_CASE("range_ranks__the_kth_least_of_ranges_is_that_of_their_values_sorted") {
  RandomStream random(2, 0);
  for (const size_t n : {size_t{1}, size_t{2}, size_t{63}, size_t{64}, size_t{65}, size_t{3000}}) {
    std::vector<double> values(n);
    for (double& v : values)
      v = random.uniform() < 0.3 ? static_cast<double>(random.below(3)) : random.normal();
    Task task;
    const RangeRanks ranks(values, task);
    for (int k = 0; k < 200; ++k) {
      std::vector<RangeRanks::Range> ranges;
      std::vector<double> truth;
      for (uint32_t at = 0; at < n;) {
        const auto first = at + static_cast<uint32_t>(random.below(n / 4 + 1));
        const auto last = first + 1 + static_cast<uint32_t>(random.below(n / 4 + 1));
        if (last > n) break;
        ranges.push_back({first, last});
        truth.insert(truth.end(), values.begin() + first, values.begin() + last);
        at = last;
      }
      if (truth.empty()) continue;
      std::sort(truth.begin(), truth.end());
      const size_t wanted = random.below(truth.size());
      CHECK(ranks.least(ranges, wanted) == truth[wanted]);
    }
  }
}
