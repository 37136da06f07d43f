// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/crc32.h"

#include <array>

namespace jalon {

namespace {

// Of ISO 3309 and of Castagnoli, their lowest power in the highest bit.
constexpr uint32_t kIso = 0xedb88320, kCastagnoli = 0x82f63b78;
constexpr size_t kSlices = 8;  // bytes a step

// Row 0: the remainder of a byte (annex D of the PNG standard); row k: that of a byte with k zero bytes behind it, so
// that eight bytes go at once (slicing; Kounavis & Berry 2008).
template <uint32_t kPolynomial>
constexpr auto kRemainders = [] {
  std::array<std::array<uint32_t, 256>, kSlices> table{};
  for (uint32_t byte = 0; byte < 256; ++byte) {
    uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest & 1) != 0 ? kPolynomial ^ rest >> 1 : rest >> 1;
    table[0][byte] = rest;
  }
  for (size_t k = 1; k < kSlices; ++k)
    for (size_t byte = 0; byte < 256; ++byte)
      table[k][byte] = table[k - 1][byte] >> 8 ^ table[0][table[k - 1][byte] & 0xff];
  return table;
}();

template <uint32_t kPolynomial>
uint32_t crc_of(uint32_t crc, const void* bytes, size_t count) {
  constexpr auto& kRows = kRemainders<kPolynomial>;
  const auto* at = static_cast<const uint8_t*>(bytes);
  crc = ~crc;
  for (; count >= kSlices; count -= kSlices, at += kSlices) {
    uint32_t next = 0;
    for (size_t k = 0; k < 4; ++k)
      next ^= kRows[7 - k][at[k] ^ (crc >> 8 * k & 0xff)] ^ kRows[3 - k][at[4 + k]];
    crc = next;
  }
  for (; count > 0; --count, ++at) crc = crc >> 8 ^ kRows[0][(crc ^ *at) & 0xff];
  return ~crc;
}

}  // namespace

uint32_t crc32(uint32_t crc, const void* bytes, size_t count) {
  return crc_of<kIso>(crc, bytes, count);
}
uint32_t crc32c(uint32_t crc, const void* bytes, size_t count) {
  return crc_of<kCastagnoli>(crc, bytes, count);
}

}  // namespace jalon
