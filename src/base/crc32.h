// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace jalon {

/// CRC-32 of ISO 3309 (that of PNG and zip) of bytes that follow those of crc; 0 to begin with. About a byte a clock.
uint32_t crc32(uint32_t crc, const void* bytes, size_t count);
/// CRC-32C (Castagnoli, RFC 3720), likewise.
uint32_t crc32c(uint32_t crc, const void* bytes, size_t count);

}  // namespace jalon
