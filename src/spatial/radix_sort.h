// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace jalon {

/// Keys with a payload in two arrays, as the in-cache sort wants them.
struct KeyedRange {
  uint64_t* keys;
  uint32_t* values;
};

/// Stable sort of n pairs by key; the result lies in data, scratch has the same room. Radix sort from the highest
/// differing bits down, 8 bits a pass, insertion sort below 24; equal keys cost one pass. Meant for ranges that fit the
/// L2 cache.
void sort_pairs(KeyedRange data, KeyedRange scratch, size_t n);

}  // namespace jalon
