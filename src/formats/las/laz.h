// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/task.h"
#include "formats/files/byte_source.h"
#include "formats/las/layout.h"
#include "geometry/vec.h"

namespace jalon::las {

/// Where a chunk lies, and the number of its first point among those that are read.
struct LazChunk {
  uint64_t offset = 0, bytes = 0, first = 0, points = 0;
};
/// Steps of the file between which points are wanted: x, y, z.
struct StepBox {
  std::array<int32_t, 3> least, most;
};
/// All that the box may hold, and a step more: the places themselves decide. All steps where places may be none.
StepBox step_box(const Header& header, const Vec3& metres, const Box3& box_m);

/// The compressed points of a LAZ file: chunks, each decoded by itself.
class LazPoints {
 public:
  /// Finds the chunks; refuses tables that the file has no room for.
  LazPoints(const ByteSource& source, const Header& header, const std::vector<Record>& vlrs);
  /// Those chunks alone that somebody found already.
  LazPoints(const ByteSource& source, const Header& header, const std::vector<Record>& vlrs,
            std::vector<LazChunk> found);

  /// Before anything is made for them: refuses more points than the chunks hold. Where they promise
  /// more than scanners' files do a byte, they are decoded to see.
  void require_points(Task& task) const;
  /// Of the points of all chunks.
  uint64_t count() const {
    return chunks_.empty() ? 0 : chunks_.back().first + chunks_.back().points;
  }
  size_t chunks() const { return chunks_.size(); }
  uint64_t first_point(size_t chunk) const { return chunks_[chunk].first; }
  size_t points(size_t chunk) const { return static_cast<size_t>(chunks_[chunk].points); }
  /// The chunk's points as records of a LAS file. Any thread.
  std::unique_ptr<std::byte[]> decode(size_t chunk) const;
  /// The same of the records up to the last one within the steps, so many; those behind it are not decoded where that
  /// saves work.
  std::unique_ptr<std::byte[]> decode_within(size_t chunk, const StepBox& box, size_t& count) const;

 private:
  struct Layout {
    uint64_t chunk_points = 0;  ///< 0: each chunk has its own number
    bool has_chunks = false;
  };
  /// Finds the record of the compressor.
  Layout read_layout(const std::vector<Record>& vlrs);
  /// The table's place, version first; its end at the latest.
  uint64_t find_table() const;
  void read_table(uint64_t chunk_points);
  void number_points(uint64_t chunk_points);
  std::unique_ptr<std::byte[]> packed(size_t chunk) const;
  template <class Decode>
  std::unique_ptr<std::byte[]> decoded(size_t chunk, Decode&& run) const;
  const ByteSource& source_;
  const Header& header_;
  std::vector<std::byte> vlr_;
  bool checks_counts_ = false;  ///< that of a chunk against what it says itself
  std::vector<LazChunk> chunks_;
};

}  // namespace jalon::las
