// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/radix_sort.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

using Pairs = std::vector<std::pair<uint64_t, uint32_t>>;

Pairs sorted_by_pairs(const std::vector<uint64_t>& keys) {
  std::vector<uint64_t> k = keys, scratch_keys(keys.size());
  std::vector<uint32_t> v(keys.size()), scratch_values(keys.size());
  for (size_t i = 0; i < v.size(); ++i) v[i] = static_cast<uint32_t>(i);
  sort_pairs({k.data(), v.data()}, {scratch_keys.data(), scratch_values.data()}, k.size());
  Pairs out;
  for (size_t i = 0; i < k.size(); ++i) out.emplace_back(k[i], v[i]);
  return out;
}

// The values are the places of the keys, so a stable sort by key is the sort of the pairs.
Pairs sorted_by_std(const std::vector<uint64_t>& keys) {
  Pairs out;
  for (size_t i = 0; i < keys.size(); ++i) out.emplace_back(keys[i], static_cast<uint32_t>(i));
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE("sort_pairs__is_a_stable_sort_for_any_size_and_kind_of_key") {
  RandomStream random(1, 0);
  // About the limits of insertion sort (24) and of the small digit (512), and none at all.
  for (const size_t n : {0, 1, 2, 23, 24, 25, 26, 511, 512, 513, 5000}) {
    std::vector<uint64_t> few(n), wide(n), high(n), low(n);
    for (size_t i = 0; i < n; ++i) {
      few[i] = random.below(7);
      wide[i] = random.below(~uint64_t{0});
      high[i] = random.below(1000) << 54;
      low[i] = (uint64_t{0xabcdef} << 40) + random.below(3) * 0x10001;
    }
    for (const auto& keys : {few, wide, high, low}) {
      CAPTURE(n);
      CHECK(sorted_by_pairs(keys) == sorted_by_std(keys));
    }
  }
}

TEST_CASE("sort_pairs__equal_keys_and_sorted_keys_keep_their_order") {
  const std::vector<uint64_t> equal(3000, 42);
  CHECK(sorted_by_pairs(equal) == sorted_by_std(equal));
  std::vector<uint64_t> falling(3000);
  for (size_t i = 0; i < falling.size(); ++i) falling[i] = ~uint64_t{0} - i;
  const Pairs sorted = sorted_by_pairs(falling);
  for (size_t i = 0; i < sorted.size(); ++i) REQUIRE(sorted[i].second == sorted.size() - 1 - i);
}

TEST_CASE("sort_pairs__keys_that_differ_in_one_bit_only_are_told_apart") {
  for (int bit = 0; bit < 64; ++bit) {
    std::vector<uint64_t> keys(100, 0x5555555555555555);
    for (size_t i = 0; i < keys.size(); i += 3) keys[i] ^= uint64_t{1} << bit;
    REQUIRE(sorted_by_pairs(keys) == sorted_by_std(keys));
  }
}
