// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/task.h"
#include "formats/files/byte_source.h"

namespace jalon::e57 {

/// Of a page in the file, and what it holds in front of its checksum (ASTM E2807).
constexpr uint64_t kPageBytes = 1024, kHeldBytes = 1020;

/// Where a byte of the file stands among the bytes without checksums, and back.
constexpr uint64_t logical_offset(uint64_t physical) {
  return physical - (kPageBytes - kHeldBytes) * (physical / kPageBytes);
}
constexpr uint64_t physical_offset(uint64_t logical) {
  return logical + (kPageBytes - kHeldBytes) * (logical / kHeldBytes);
}

/// Whole pages, without their checksums, which must be right: kHeldBytes each. By all threads.
void read_pages(const ByteSource& source, uint64_t first, size_t count, std::byte* out, Task& task);

}  // namespace jalon::e57
