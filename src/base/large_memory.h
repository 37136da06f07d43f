// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace jalon {

/// From so many bytes on the two below pay: filling fresh memory page by page of 4 KiB costs five times as long as
/// copying to it.
constexpr size_t kLargeBytes = size_t{4} << 20;

/// Asks the system for large pages for memory that will be written whole. Advice: nothing happens where it knows none.
void advise_large_pages(void* memory, size_t bytes);

/// Copies n doubles past the caches, which would hold none of them at the end anyway, for buffers of kLargeBytes and
/// more. Returns whether all are finite. to: aligned to 16 bytes, from to that of a double or less.
bool copy_finite(const void* from, size_t n, double* to);

}  // namespace jalon
