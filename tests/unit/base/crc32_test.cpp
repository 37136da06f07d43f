// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/crc32.h"

#include <doctest/doctest.h>

#include <string_view>
#include <vector>

namespace jalon {
namespace {

// Bit by bit, as the standard says it.
uint32_t crc_by_bits(const std::vector<uint8_t>& bytes, uint32_t polynomial) {
  uint32_t crc = ~0u;
  for (const uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? polynomial ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

TEST_CASE("crc32__is_that_of_the_standard") {
  CHECK(crc32(0, "123456789", 9) == 0xcbf43926);  // the check values of the catalogues
  CHECK(crc32c(0, "123456789", 9) == 0xe3069283);
  CHECK(crc32(0, "", 0) == 0);
  std::vector<uint8_t> bytes;
  for (size_t n = 0; n < 40; ++n) {
    CHECK(crc32(0, bytes.data(), bytes.size()) == crc_by_bits(bytes, 0xedb88320));
    CHECK(crc32c(0, bytes.data(), bytes.size()) == crc_by_bits(bytes, 0x82f63b78));
    bytes.push_back(static_cast<uint8_t>(37 * n + 11));
  }
}

TEST_CASE("crc32__of_parts_is_that_of_the_whole") {
  constexpr std::string_view kText = "a text that is cut at any place, aligned or not";
  for (size_t cut = 0; cut <= kText.size(); ++cut)
    CHECK(crc32(crc32(0, kText.data(), cut), kText.data() + cut, kText.size() - cut) ==
          crc32(0, kText.data(), kText.size()));
}

}  // namespace
}  // namespace jalon
