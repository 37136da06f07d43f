// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "formats/files/system_file.h"

namespace jalon {

/// A file that appears whole or not at all: written beside the target under a private name, renamed
/// by commit(). Without commit() the private file is removed and the target stays as it was; what a
/// killed writer left beside it the next writer takes away.
/// Buffered. Errors are Error(kIo) with path and cause.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const void* data, size_t bytes);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Overwrites bytes already written (headers whose counts are known late).
  void rewrite(size_t offset, const void* data, size_t bytes);
  /// Bytes already written; as many as there are.
  size_t read_back(uint64_t offset, void* out, size_t bytes);
  /// Flushes, syncs and renames over the target.
  void commit();

 private:
  void flush();
  [[noreturn]] void refuse(const char* action) const;
  std::string path_, temporary_;
  FileHandle file_ = kNoFile;
  std::vector<char> buffer_;
  size_t filled_ = 0;
};

}  // namespace jalon
