// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/pcd/lzf.h"

#include <cstring>

namespace jalon::pcd {

namespace {

constexpr size_t kLiteral = 32;   // tokens below: that many bytes and one follow as they are
constexpr size_t kLongMatch = 7;  // a length that a further byte adds to

/// A run of bytes as they are, or of bytes that came before.
struct Token {
  bool literal = false;
  size_t length = 0;
  size_t back = 0;  ///< of a match: how far it lies behind
};

// The token at `at`, which moves behind it (and not behind the bytes of a literal); false where
// they end too early.
bool next_token(std::span<const std::byte> packed, size_t& at, Token& token) {
  const auto head = static_cast<size_t>(packed[at++]);
  if (head < kLiteral) {
    token = {true, head + 1, 0};
    return token.length <= packed.size() - at;
  }
  size_t length = head >> 5;
  if (length == kLongMatch) {
    if (at == packed.size()) return false;
    length += static_cast<size_t>(packed[at++]);
  }
  if (at == packed.size()) return false;
  token = {false, length + 2, ((head & 31) << 8) + static_cast<size_t>(packed[at++]) + 1};
  return true;
}

}  // namespace

uint64_t unpacked_lzf_bytes(std::span<const std::byte> packed) {
  uint64_t bytes = 0;
  Token token;
  for (size_t at = 0; at < packed.size(); bytes += token.length) {
    if (!next_token(packed, at, token)) return ~uint64_t{0};
    if (token.literal) at += token.length;
  }
  return bytes;
}

bool unpack_lzf(std::span<const std::byte> packed, std::span<std::byte> out) {
  size_t to = 0;
  Token token;
  for (size_t at = 0; at < packed.size();) {
    if (!next_token(packed, at, token) || token.length > out.size() - to) return false;
    if (token.literal) {
      std::memcpy(out.data() + to, packed.data() + at, token.length);
      at += token.length;
      to += token.length;
    } else {
      if (token.back > to) return false;
      for (size_t i = 0; i < token.length; ++i, ++to)
        out[to] = out[to - token.back];  // may overlap
    }
  }
  return to == out.size();
}

}  // namespace jalon::pcd
