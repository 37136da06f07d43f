// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/random.h"
#include "formats/files/endian.h"
#include "fuzz/e57_page.h"

namespace jalon::test {

/// These bytes as the pages of a file, with their checksums.
inline std::string paged(std::string held) {
  constexpr size_t kHeld = 1020;
  held.resize((held.size() + kHeld - 1) / kHeld * kHeld);
  std::string out;
  for (size_t page = 0; page < held.size() / kHeld; ++page) {
    out += held.substr(page * kHeld, kHeld) + "crc.";
    renew_checksum(out, page);
  }
  return out;
}

/// A stream of integers of so many bits, the lowest first.
struct BitStream {
  std::string bytes;
  size_t used = 0;
  void add(uint64_t value, uint32_t bits) {
    for (uint32_t b = 0; b < bits; ++b, ++used) {
      if (used % 8 == 0) bytes += '\0';
      if ((value >> b & 1) != 0) bytes.back() = static_cast<char>(bytes.back() | 1 << used % 8);
    }
  }
};

/// A packet of points: a piece of each stream.
inline std::string data_packet(const std::vector<std::string>& pieces) {
  std::string out("\x01\x00\x00\x00", 4);
  append_stored(out, static_cast<uint16_t>(pieces.size()));
  for (const std::string& piece : pieces) append_stored(out, static_cast<uint16_t>(piece.size()));
  for (const std::string& piece : pieces) out += piece;
  out.resize((out.size() + 3) / 4 * 4);
  store(out.data() + 2, static_cast<uint16_t>(out.size() - 1));
  return out;
}

/// A packet that holds no points: 0 of an index, 2 to be ignored.
inline std::string other_packet(char kind, size_t bytes) {
  std::string out(bytes, '\0');
  out[0] = kind;
  store(out.data() + 2, static_cast<uint16_t>(bytes - 1));
  return out;
}

/// The streams cut into packets of at most `most` bytes a piece, each at its own places, with other
/// packets between.
inline std::string packets_of(const std::vector<BitStream>& streams, size_t most, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<size_t> done(streams.size());
  std::string out;
  for (bool all = false; !all;) {
    std::vector<std::string> pieces;
    all = true;
    for (size_t s = 0; s < streams.size(); ++s) {
      const size_t left = streams[s].bytes.size() - done[s];
      const size_t count = std::min(left, 1 + random.below(most));
      pieces.push_back(streams[s].bytes.substr(done[s], count));
      done[s] += count;
      all = all && count == left;
    }
    out += data_packet(pieces);
    if (random.uniform() < 0.2) out += other_packet(random.uniform() < 0.5 ? 0 : 2, 64);
  }
  return out;
}

/// A section with these packets behind `before` bytes of a file, and `behind` behind them.
inline std::string section_file(size_t before, const std::string& packets,
                                const std::string& behind) {
  std::string head(32, '\0');
  head[0] = 1;
  store<uint64_t>(head.data() + 8, head.size() + packets.size());
  const size_t at = before + head.size();
  store<uint64_t>(head.data() + 16, at + 4 * (at / 1020));
  return paged(std::string(before, '.') + head + packets + behind);
}

}  // namespace jalon::test
