// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

/// CRC-32C (Castagnoli), as at the end of each page of 1024 bytes of an E57 file, most significant byte first.
inline void renew_checksum(std::string& bytes, size_t page) {
  constexpr size_t kPage = 1024, kData = 1020;
  uint32_t crc = ~0u;
  for (size_t i = 0; i < kData; ++i) {
    crc ^= static_cast<uint8_t>(bytes[page * kPage + i]);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0x82F63B78u : 0u);
  }
  crc = ~crc;
  for (size_t k = 0; k < 4; ++k)
    bytes[page * kPage + kData + k] = static_cast<char>(crc >> (24 - 8 * k));
}
