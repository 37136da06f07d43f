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

/// The points of a LAZ file: chunks of one number of points, each encoded by itself, then their
/// table. The same bytes for any number of threads.
class LazWriter {
 public:
  /// plan lives as long; path for messages.
  LazWriter(const Plan& plan, const std::string& path);
  /// The record that tells readers how the points are packed.
  Record record() const;
  /// Writes the points, which begin at point_offset, and says how many bytes they took.
  Tally write(const Cloud& cloud, AtomicFile& file, uint64_t point_offset, uint64_t& bytes,
              Task& task) const;

 private:
  const Plan& plan_;
  const std::string& path_;
  size_t chunk_points_ = 0;
  std::vector<std::byte> vlr_;
};

}  // namespace jalon::las
