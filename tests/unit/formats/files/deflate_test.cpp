// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Streams against RFC 1950 and 1951: check sums that are known, and the bits that the fixed code takes. That what was
// written comes back is tested with the pictures (drawings/png_test.cpp).
#include "formats/files/deflate.h"

#include <doctest/doctest.h>

#include <string>

#include "base/random.h"

using namespace jalon;

namespace {

/// Header of two bytes, block, check sum of four.
size_t bytes_of_bits(size_t bits) { return 2 + (bits + 7) / 8 + 4; }

constexpr size_t kBlockBits = 3 + 7;  // of its beginning and its end

uint32_t stated_sum(const std::string& stream) {
  uint32_t out = 0;
  for (const char c : stream.substr(stream.size() - 4))
    out = out << 8 | static_cast<unsigned char>(c);
  return out;
}

std::string noise(size_t n, uint64_t stream) {
  RandomStream random(1, stream);
  std::string out;
  for (size_t i = 0; i < n; ++i) out += static_cast<char>(random.below(256));
  return out;
}

}  // namespace

TEST_CASE("deflate__header_and_check_sum_are_those_of_rfc_1950") {
  // Adler-32 of "Wikipedia" as its article works it out; of "a" by hand: 1 + 97 twice; of nothing: 1.
  CHECK(stated_sum(zlib_of("Wikipedia", 0)) == 0x11e60398);
  CHECK(stated_sum(zlib_of("a", 0)) == 0x00620062);
  CHECK(stated_sum(zlib_of("", 0)) == 1);
  // Its sums are taken modulo 65521, in closed form for n equal bytes of value v: 1 + n v, n + v n (n + 1) / 2.
  constexpr uint64_t kBytes = 100000, kValue = 255, kModulus = 65521;
  const uint64_t a = (1 + kBytes * kValue) % kModulus,
                 b = (kBytes + kValue * (kBytes * (kBytes + 1) / 2)) % kModulus;
  CHECK(stated_sum(zlib_of(std::string(kBytes, '\xff'), 100)) == (b << 16 | a));
  const std::string stream = zlib_of("abc", 0);
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(stream[i]); };
  CHECK((byte(0) & 15) == 8);                  // deflate
  CHECK((byte(0) * 256 + byte(1)) % 31 == 0);  // FCHECK
  CHECK((byte(1) & 32) == 0);                  // no dictionary
}

TEST_CASE("deflate__literals_take_eight_or_nine_bits_and_a_run_thirteen") {
  CHECK(zlib_of("", 0).size() == bytes_of_bits(kBlockBits));
  std::string low, high;  // neighbours differ: nothing repeats at distance 1
  for (int i = 0; i < 1000; ++i) {
    low += static_cast<char>(i % 144);
    high += static_cast<char>(144 + i % 112);
  }
  CHECK(zlib_of(low, 0).size() == bytes_of_bits(kBlockBits + 8 * low.size()));
  CHECK(zlib_of(high, 0).size() == bytes_of_bits(kBlockBits + 9 * high.size()));
  // A literal, then repetitions of 258 bytes: 8 bits of length and 5 of distance 1.
  for (const size_t k : {1, 2, 40})
    CHECK(zlib_of(std::string(1 + 258 * k, 'x'), 0).size() ==
          bytes_of_bits(kBlockBits + 8 + 13 * k));
  CHECK(zlib_of("xxx", 0).size() == bytes_of_bits(kBlockBits + 3 * 8));  // two more are no run
  CHECK(zlib_of("xxxx", 0).size() == bytes_of_bits(kBlockBits + 8 + 7 + 5));
}

TEST_CASE("deflate__looks_back_one_row_of_at_most_32768_bytes") {
  for (const size_t row : {size_t{300}, size_t{32768}}) {
    const std::string line = noise(row, row), first = zlib_of(line, row);
    const size_t pieces = (row + 257) / 258;
    // Lengths and distances take 8 + 5 bits each and 5 + 13 extra ones at most.
    CHECK(zlib_of(line + line, row).size() <= first.size() + pieces * 31 / 8 + 1);
  }
  const std::string line = noise(32769, 3);
  CHECK(zlib_of(line + line, 32769).size() > 2 * line.size());  // beyond the window: noise again
  CHECK(zlib_of(line + line, 32769) == zlib_of(line + line, 0));
}
