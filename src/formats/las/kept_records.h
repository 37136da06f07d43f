// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "formats/las/laz.h"

namespace jalon::las {

/// The records of those points of a LAZ file that are wanted, in its order: each chunk is decoded once, and nothing
/// is kept of the others. So columns are made for what was found alone, while what is in them already goes.
class KeptRecords {
 public:
  /// is_kept(record), of those within the steps at most. Any thread.
  KeptRecords(const LazPoints& laz, size_t record_bytes, const StepBox& steps,
              const std::function<bool(const std::byte*)>& is_kept, Task& task);

  size_t count() const { return count_; }
  /// put(records, n, first) for the points from `first` on, each once, by several threads; then they are gone.
  void give(const std::function<void(const std::byte*, size_t, size_t)>& put, Task& task);

 private:
  struct Part {
    size_t slab = 0, at = 0, count = 0, first = 0;
  };
  Part stored(const std::byte* records, size_t count);
  const size_t record_bytes_;
  size_t slab_bytes_ = 0;
  size_t count_ = 0;
  std::vector<Part> parts_;  ///< of the chunks
  std::mutex filling_;
  std::vector<Buffer<std::byte>> slabs_;
  size_t filled_ = 0;  ///< bytes of the last slab
};

}  // namespace jalon::las
