// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace jalon {

/// Bits as RFC 1951 packs them: from the least significant of each byte on.
class BitWriter {
 public:
  void bits(uint32_t value, uint32_t count) {
    held_ |= uint64_t{value} << count_;
    for (count_ += count; count_ >= 8; count_ -= 8, held_ >>= 8)
      out_ += static_cast<char>(held_ & 0xff);
  }
  /// Huffman's codes go most significant bit first.
  void code(uint32_t value, uint32_t count) { bits(turned(value, count), count); }
  static uint32_t turned(uint32_t value, uint32_t count) {
    uint32_t out = 0;
    for (uint32_t i = 0; i < count; ++i) out |= (value >> i & 1) << (count - 1 - i);
    return out;
  }
  void flush() {
    if (count_ > 0) bits(0, 8 - count_);
  }
  std::string& out() { return out_; }

 private:
  std::string out_;
  uint64_t held_ = 0;
  uint32_t count_ = 0;
};

/// The check at the end of a zlib stream (RFC 1950); start: that of the bytes before.
inline uint32_t adler32(std::string_view bytes, uint32_t start = 1) {
  constexpr uint32_t kBase = 65521;
  constexpr size_t kNoOverflow = 5552;  // bytes whose sums fit 32 bits
  uint32_t a = start & 0xffff, b = start >> 16;
  for (size_t at = 0; at < bytes.size();) {
    const size_t end = at + kNoOverflow < bytes.size() ? at + kNoOverflow : bytes.size();
    for (; at < end; ++at) {
      a += static_cast<unsigned char>(bytes[at]);
      b += a;
    }
    a %= kBase;
    b %= kBase;
  }
  return b << 16 | a;
}

/// It as the four last bytes of the stream.
inline void put_adler32(std::string& out, uint32_t sum) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(sum >> shift & 0xff);
}

}  // namespace jalon
