// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace jalon {

/// A prefix code, canonical as RFC 1951, 3.2.2 wants it: from the lengths alone one knows it.
struct PrefixCode {
  std::vector<uint8_t> lengths;  ///< bits of each symbol, 0: it does not occur
  std::vector<uint16_t> codes;   ///< as BitWriter::bits() takes them
};

/// The shortest code for symbols of these frequencies (Huffman 1952) of at most `most` bits each
/// (Larmore & Hirschberg's bound is met nearly: frequencies are levelled until the longest fits).
/// Equal frequencies go by the symbol, so that the same frequencies give the same code.
PrefixCode prefix_code(std::span<const uint32_t> frequencies, uint32_t most);

}  // namespace jalon
