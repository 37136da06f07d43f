// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/large_memory.h"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <vector>

#include "base/buffer.h"

using namespace jalon;

TEST_CASE("large_memory__copies_the_bits_and_finds_every_number_that_is_not_finite") {
  const double inf = std::numeric_limits<double>::infinity(),
               nan = std::numeric_limits<double>::quiet_NaN();
  for (const size_t n : {size_t{1}, size_t{2}, size_t{3}, size_t{1001}}) {
    std::vector<double> from(n + 1);
    for (size_t i = 0; i < n; ++i) from[i] = i % 2 == 0 ? -1.7e308 : 5e-324;
    Buffer<double> to(n);
    CHECK(copy_finite(from.data(), n, to.data()));
    CHECK(std::memcmp(from.data(), to.data(), n * sizeof(double)) == 0);
    for (const double wrong :
         {inf, -inf, nan, -nan, std::numeric_limits<double>::signaling_NaN()}) {
      for (const size_t at : {size_t{0}, n / 2, n - 1}) {
        const double kept = from[at];
        from[at] = wrong;
        CHECK_FALSE(copy_finite(from.data(), n, to.data()));
        from[at] = kept;
      }
    }
    // The caller's memory need not be aligned.
    std::vector<char> odd(n * sizeof(double) + 1);
    std::memcpy(odd.data() + 1, from.data(), n * sizeof(double));
    CHECK(copy_finite(odd.data() + 1, n, to.data()));
    CHECK(std::memcmp(from.data(), to.data(), n * sizeof(double)) == 0);
  }
}

TEST_CASE("large_memory__advice_leaves_what_is_there") {
  Buffer<char> memory(3 * kLargeBytes);
  std::memset(memory.data(), 42, memory.size());
  advise_large_pages(memory.data(), memory.size());
  CHECK(memory[0] == 42);
  CHECK(memory[memory.size() - 1] == 42);
  advise_large_pages(memory.data() + 5, 10);
  advise_large_pages(nullptr, 0);
}
