// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "formats/files/byte_source.h"
#include "formats/las/layout.h"

namespace jalon::las {

/// The compressed points of a LAZ file: chunks, each decoded by itself.
class LazPoints {
 public:
  /// Finds the chunks; refuses tables that the file has no room for, and more points than its
  /// compressed bytes can stand for.
  LazPoints(const ByteSource& source, const Header& header, const std::vector<Record>& vlrs);

  size_t chunks() const { return chunks_.size(); }
  uint64_t first_point(size_t chunk) const { return chunks_[chunk].first; }
  size_t points(size_t chunk) const { return static_cast<size_t>(chunks_[chunk].points); }
  /// The chunk's points as records of a LAS file. Any thread.
  std::unique_ptr<std::byte[]> decode(size_t chunk) const;

 private:
  struct Chunk {
    uint64_t offset = 0, bytes = 0, first = 0, points = 0;
  };
  /// The table's place, version first; its end at the latest.
  uint64_t find_table() const;
  void read_table(uint64_t chunk_points);
  void number_points(uint64_t chunk_points);
  const ByteSource& source_;
  const Header& header_;
  std::vector<std::byte> vlr_;
  std::vector<Chunk> chunks_;
};

}  // namespace jalon::las
