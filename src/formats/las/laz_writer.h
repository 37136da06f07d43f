// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/atomic_file.h"
#include "formats/las/layout.h"
#include "formats/las/plan.h"
#include "formats/las/records.h"

namespace jalon::las {

/// In which order and in which chunks points are written.
struct LazOrder {
  std::span<const uint32_t> points;  ///< empty: as they lie
  std::vector<size_t> starts;        ///< of the chunks, and the end of the last
};
/// What was written.
struct LazWritten {
  Tally tally;
  uint64_t bytes = 0;           ///< with the place of the table and the table
  std::vector<uint64_t> sizes;  ///< of the chunks, in bytes
};
constexpr uint64_t kLazPlaceBytes = 8;  ///< of the table's place, before the first chunk

/// The points of a LAZ file: chunks, each encoded by itself, then their table. The same bytes for any
/// number of threads.
class LazWriter {
 public:
  enum class Chunks { kEqual, kOwn };  ///< of one number of points, or each of its own
  /// plan lives as long; path for messages.
  LazWriter(const Plan& plan, const std::string& path, Chunks chunks = Chunks::kEqual);
  /// The record that tells readers how the points are packed.
  Record record() const;
  /// n points as they lie.
  LazOrder order_of(size_t n) const;
  /// Writes the points, which begin at point_offset.
  LazWritten write(const Cloud& cloud, const LazOrder& order, AtomicFile& file,
                   uint64_t point_offset, Task& task) const;

 private:
  friend class LazStream;
  /// Ends the points: the table of their chunks, whose numbers of points are these where each has its own, and its
  /// place.
  void put_table(AtomicFile& file, uint64_t point_offset, const std::vector<uint64_t>& counts,
                 LazWritten& written) const;
  const Plan& plan_;
  const std::string& path_;
  size_t chunk_points_ = 0;  ///< 0: each chunk has its own number
  std::vector<std::byte> vlr_;
};

/// Packs records that come bit by bit, to the same bytes as LazWriter::write in chunks of one number of points.
class LazStream {
 public:
  /// They live as long; the file ends where its points begin.
  LazStream(const LazWriter& writer, AtomicFile& file, uint64_t point_offset);
  void put(std::span<const std::byte> records, Task& task);
  /// Without a tally, which those have who made the records.
  LazWritten finish(Task& task);

 private:
  void pack(std::span<const std::byte> records, size_t chunk_bytes, Task& task);
  const LazWriter& writer_;
  AtomicFile& file_;
  uint64_t point_offset_;
  std::vector<std::byte> rest_;  ///< less than a chunk
  LazWritten written_;
};

}  // namespace jalon::las
