// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/printf_format.h"
#include "formats/files/system_file.h"

namespace jalon {

/// A regular file to be read at any offset, by any number of threads. It knows its true size, so
/// that no reader need believe a count: reads beyond the end are Error(kFormat), also when the file
/// shrinks meanwhile. Opening: kNotFound, kIo.
class ByteSource {
 public:
  explicit ByteSource(std::string path);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  const std::string& path() const { return path_; }
  uint64_t size() const { return size_; }
  /// Exactly these bytes.
  void read(uint64_t offset, void* out, size_t bytes) const;
  /// As many of them as there are.
  size_t read_some(uint64_t offset, void* out, size_t bytes) const;
  /// True when [offset, offset + bytes) lies inside the file.
  bool has(uint64_t offset, uint64_t bytes) const {
    return offset <= size_ && bytes <= size_ - offset;
  }
  /// Error(kFormat) "path: offset N: reason".
  [[noreturn]] void refuse(uint64_t offset, const char* format, ...) const JALON_PRINTF(3, 4);

 private:
  std::string path_;
  FileHandle file_ = kNoFile;
  uint64_t size_ = 0;
};

}  // namespace jalon
