// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/range_counts.h"

#include <doctest/doctest.h>

#include "base/random.h"

using namespace jalon;

TEST_CASE("range_counts__are_those_of_the_positions_one_by_one_and_add_up_over_ranges") {
  RandomStream random(1, 0);
  for (const size_t n : {size_t{0}, size_t{1}, size_t{64}, size_t{65}, size_t{1000}}) {
    std::vector<uint8_t> classes(n);
    for (uint8_t& c : classes) c = static_cast<uint8_t>(random.below(5));
    const RangeCounts<5> counts(classes);
    for (int k = 0; k < 300; ++k) {
      size_t first = random.below(n + 1), last = random.below(n + 1);
      if (first > last) std::swap(first, last);
      RangeCounts<5>::Counts found{1, 0, 0, 0, 2}, truth = found;
      counts.add(first, last, found);
      for (size_t i = first; i < last; ++i) ++truth[classes[i]];
      CHECK(found == truth);
    }
  }
}
