// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "formats/codecs/codecs.h"
#include "formats/files/byte_source.h"

namespace jalon::e57 {

/// A column of the records and how its values are packed.
struct RecordColumn {
  int32_t kind = kJcDouble;
  double scale = 1, offset = 0;  ///< of scaled integers
  JcPacking packing{0, 64};
};

/// The records of a scan, some at a time. They stand in packets one after another, in each a piece
/// of every column's stream of bits (ASTM E2807).
class Records {
 public:
  /// section: offset in the file of what holds them. Error(kFormat) where it is none.
  Records(const ByteSource& source, uint64_t section, uint64_t count,
          std::vector<RecordColumn> columns, Task& task);
  /// Goes to the next records: how many; 0 behind the last.
  size_t next(Task& task);
  /// The numbers that stand for `count` values of a column, from that of record `first` of these
  /// records on. Any thread.
  void values(size_t column, size_t first, size_t count, double* out) const;

 private:
  /// Bits of a column that are read and not yet forgotten.
  struct Stream {
    std::vector<std::byte> bytes;  ///< and a padding
    size_t first_bit = 0;          ///< of the first of these records
  };
  /// Where the pieces of a packet begin in the window, and their lengths, of 16 bits each.
  struct Packet {
    size_t pieces, lengths;
  };
  void read_head(uint64_t section, Task& task);
  void forget();
  void read_window(Task& task);
  std::vector<Packet> take_packets();
  bool take_packet(std::vector<Packet>& packets, std::vector<size_t>& held);
  void append(const std::vector<Packet>& packets, Task& task);
  size_t whole_records(const std::vector<size_t>& held) const;
  [[noreturn]] void refuse(const char* reason) const;

  const ByteSource& source_;
  const std::vector<RecordColumn> columns_;
  const uint64_t file_pages_;
  uint64_t left_;             ///< records behind these
  size_t here_ = 0;           ///< these records
  uint64_t end_ = 0;          ///< logical offset behind the packets, as the file says
  Buffer<std::byte> window_;  ///< whole pages
  uint64_t first_page_ = 0;
  size_t pages_ = 0;  ///< in the window
  size_t at_ = 0;     ///< of the next packet in the window
  std::vector<Stream> streams_;
};

}  // namespace jalon::e57
