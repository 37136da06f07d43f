// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/e57/pages.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "base/crc32.h"
#include "base/parallel.h"
#include "formats/files/endian.h"

namespace jalon::e57 {

namespace {

constexpr size_t kPagesAtOnce = 8;  // read by one call, on the stack
constexpr size_t kPageGrain = 256;

void read_some_pages(const ByteSource& source, uint64_t first, size_t count, std::byte* out) {
  std::array<std::byte, kPagesAtOnce * kPageBytes> pages;
  source.read(first * kPageBytes, pages.data(), count * kPageBytes);
  for (size_t p = 0; p < count; ++p) {
    const std::byte* const page = pages.data() + p * kPageBytes;
    if (crc32c(0, page, kHeldBytes) != load<uint32_t, std::endian::big>(page + kHeldBytes))
      source.refuse((first + p) * kPageBytes, "the checksum of the page is not that of its bytes");
    std::memcpy(out + p * kHeldBytes, page, kHeldBytes);
  }
}

}  // namespace

void read_pages(const ByteSource& source, uint64_t first, size_t count, std::byte* out,
                Task& task) {
  parallel_for(task, count, kPageGrain, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; p += kPagesAtOnce)
      read_some_pages(source, first + p, std::min(kPagesAtOnce, end - p), out + p * kHeldBytes);
  });
}

}  // namespace jalon::e57
