// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/radix_sort.h"

#include <bit>
#include <cstring>

namespace jalon {

namespace {

constexpr size_t kInsertionBelow =
    24;  // below, clearing and summing 64 counters would cost more than the moves

void insertion_sort(KeyedRange d, size_t n) {
  for (size_t i = 1; i < n; ++i) {
    const uint64_t key = d.keys[i];
    const uint32_t value = d.values[i];
    size_t j = i;
    for (; j > 0 && d.keys[j - 1] > key; --j) {
      d.keys[j] = d.keys[j - 1];
      d.values[j] = d.values[j - 1];
    }
    d.keys[j] = key;
    d.values[j] = value;
  }
}

// Sorts d; to_scratch says where the result must lie.
void sort_step(KeyedRange d, KeyedRange scratch, size_t n, bool to_scratch) {
  uint64_t differing = 0;
  if (n > kInsertionBelow)
    for (size_t i = 1; i < n; ++i) differing |= d.keys[i] ^ d.keys[0];
  else insertion_sort(d, n);
  if (differing == 0) {
    if (to_scratch) {
      std::memcpy(scratch.keys, d.keys, n * sizeof(uint64_t));
      std::memcpy(scratch.values, d.values, n * sizeof(uint32_t));
    }
    return;
  }
  // Few keys: fewer bins, so that clearing and summing them stays cheap.
  const int digit_bits = n > 512 ? 8 : 6;
  const int top = 64 - std::countl_zero(differing);
  const int shift = top > digit_bits ? top - digit_bits : 0;
  const uint64_t mask = (uint64_t{1} << digit_bits) - 1;
  uint32_t ends[257] = {};
  for (size_t i = 0; i < n; ++i) ++ends[(d.keys[i] >> shift & mask) + 1];
  for (size_t b = 1; b <= mask + 1; ++b) ends[b] += ends[b - 1];
  for (size_t i = 0; i < n; ++i) {
    const uint32_t to = ends[d.keys[i] >> shift & mask]++;
    scratch.keys[to] = d.keys[i];
    scratch.values[to] = d.values[i];
  }
  size_t begin = 0;
  for (size_t b = 0; b <= mask; ++b) {  // now ends[b] is where bin b ends
    const size_t size = ends[b] - begin;
    if (size != 0)
      sort_step({scratch.keys + begin, scratch.values + begin}, {d.keys + begin, d.values + begin},
                size, !to_scratch);
    begin = ends[b];
  }
}

}  // namespace

void sort_pairs(KeyedRange data, KeyedRange scratch, size_t n) {
  if (n > 1) sort_step(data, scratch, n, false);
}

}  // namespace jalon
