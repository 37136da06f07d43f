// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// A zlib stream read back: stored blocks and those with codes of their own (RFC 1951), written apart from the writer.
class Inflated {
 public:
  explicit Inflated(std::string_view stream) : bytes_(stream) {
    at_ = 16;  // the header of two bytes
    for (bool is_last = false; !is_last && ok;) {
      is_last = bits(1) == 1;
      const uint32_t kind = bits(2);
      if (kind == 0) stored();
      else if (kind == 2) coded();
      else ok = false;
    }
    at_ = (at_ + 7) / 8 * 8;
    uint32_t a = 1, b = 0, told = 0;
    for (const char c : text) {
      a = (a + static_cast<unsigned char>(c)) % 65521;
      b = (b + a) % 65521;
    }
    for (int i = 0; i < 4; ++i) told = told << 8 | bits(8);
    ok = ok && told == (b << 16 | a) && at_ == 8 * bytes_.size();
  }
  std::string text;
  bool ok = true;

 private:
  using Lengths = std::vector<uint32_t>;

  uint32_t bits(uint32_t count) {
    uint32_t out = 0;
    for (uint32_t i = 0; i < count; ++i, ++at_) {
      if (at_ / 8 >= bytes_.size()) return ok = false, 0;
      out |= (static_cast<unsigned char>(bytes_[at_ / 8]) >> at_ % 8 & 1u) << i;
    }
    return out;
  }
  // Bit by bit through the canonical code.
  uint32_t symbol(const Lengths& lengths) {
    uint32_t code = 0, first = 0;
    for (uint32_t length = 1; length <= 15 && ok; ++length) {
      code = code << 1 | bits(1);
      uint32_t count = 0;
      for (const uint32_t l : lengths) count += l == length ? 1 : 0;
      if (code < first + count) {
        for (uint32_t s = 0, k = code - first; s < lengths.size(); ++s)
          if (lengths[s] == length && k-- == 0) return s;
      }
      first = (first + count) << 1;
    }
    return ok = false, 0;
  }
  void stored() {
    at_ = (at_ + 7) / 8 * 8;
    const uint32_t length = bits(16), inverse = bits(16);
    ok = ok && (length ^ 0xffff) == inverse;
    for (uint32_t i = 0; i < length && ok; ++i) text += static_cast<char>(bits(8));
  }
  void coded() {
    static constexpr uint8_t kOrder[] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                         11, 4,  12, 3, 13, 2, 14, 1, 15};
    const uint32_t literals = bits(5) + 257, distances = bits(5) + 1, codes = bits(4) + 4;
    Lengths of_lengths(19, 0), all;
    for (uint32_t i = 0; i < codes; ++i) of_lengths[kOrder[i]] = bits(3);
    while (all.size() < literals + distances && ok) {
      const uint32_t s = symbol(of_lengths);
      if (s < 16) all.push_back(s);
      else if (s == 16 && !all.empty()) all.insert(all.end(), 3 + bits(2), uint32_t{all.back()});
      else all.insert(all.end(), s == 17 ? 3 + bits(3) : 11 + bits(7), 0u);
    }
    ok = ok && all.size() == literals + distances;
    if (!ok) return;
    const Lengths literal(all.begin(), all.begin() + literals),
        distance(all.begin() + literals, all.end());
    for (uint32_t s = symbol(literal); ok && s != 256; s = symbol(literal)) {
      if (s < 256) {
        text += static_cast<char>(s);
        continue;
      }
      static constexpr uint32_t kBase[] = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                           15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                           67, 83, 99, 115, 131, 163, 195, 227, 258};
      const uint32_t l = s - 257;
      if (l > 28) return void(ok = false);
      const uint32_t length = kBase[l] + bits(l < 8 || l == 28 ? 0 : (l - 4) / 4);
      ok = ok && symbol(distance) == 0 && !text.empty();  // of the byte before alone
      if (ok) text.append(length, text.back());
    }
  }
  std::string_view bytes_;
  size_t at_ = 0;
};
