// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/huffman.h"

#include <doctest/doctest.h>

#include "base/random.h"

using namespace jalon;

namespace {

/// Kraft's sum in units of 2^-15: 32768 where the code leaves no word unused.
uint64_t kraft(const PrefixCode& code) {
  uint64_t sum = 0;
  for (const uint8_t length : code.lengths)
    if (length != 0) sum += uint64_t{1} << (15 - length);
  return sum;
}

uint64_t bits_of(const PrefixCode& code, const std::vector<uint32_t>& frequencies) {
  uint64_t bits = 0;
  for (size_t s = 0; s < frequencies.size(); ++s)
    bits += uint64_t{frequencies[s]} * code.lengths[s];
  return bits;
}

}  // namespace

TEST_CASE("huffman__frequent_symbols_get_short_codes_and_no_word_is_unused") {
  // Huffman's own example of halves: 8 4 2 1 1 take 1 2 3 4 4 bits.
  const PrefixCode code = prefix_code(std::vector<uint32_t>{8, 4, 0, 2, 1, 1}, 15);
  CHECK(code.lengths == std::vector<uint8_t>{1, 2, 0, 3, 4, 4});
  CHECK(kraft(code) == 32768);
  CHECK(code.codes[1] == 1);  // 10, turned round: 01
  const PrefixCode one = prefix_code(std::vector<uint32_t>{0, 7}, 15);
  CHECK(one.lengths == std::vector<uint8_t>{0, 1});
}

TEST_CASE("huffman__frequencies_like_fibonaccis_numbers_stay_within_the_bound") {
  std::vector<uint32_t> frequencies{1, 1};
  while (frequencies.size() < 30)
    frequencies.push_back(frequencies[frequencies.size() - 1] +
                          frequencies[frequencies.size() - 2]);
  for (const uint32_t most : {7u, 15u}) {
    const PrefixCode code = prefix_code(frequencies, most);
    for (const uint8_t length : code.lengths) CHECK(length <= most);
    CHECK(kraft(code) == 32768);
  }
  CHECK(bits_of(prefix_code(frequencies, 15), frequencies) <
        bits_of(prefix_code(frequencies, 7), frequencies));
}

TEST_CASE("huffman__no_code_is_the_beginning_of_another") {
  RandomStream random(4, 1);
  std::vector<uint32_t> frequencies(40);
  for (uint32_t& f : frequencies) f = static_cast<uint32_t>(random.below(1000));
  const PrefixCode code = prefix_code(frequencies, 15);
  for (size_t a = 0; a < 40; ++a)
    for (size_t b = 0; b < 40; ++b) {
      if (a == b || code.lengths[a] == 0 || code.lengths[b] < code.lengths[a]) continue;
      CHECK((code.codes[b] & ((1u << code.lengths[a]) - 1)) != code.codes[a]);
    }
}
