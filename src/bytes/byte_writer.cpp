// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/byte_writer.h"

#include <cstring>

#include "base/large_memory.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kBlockBytes = 4096;               // from here on a block is not copied twice
constexpr size_t kCopiedAtOnce = size_t{1} << 20;  // well below a millisecond

}  // namespace

void ByteWriter::copy(const void* data, size_t bytes) {
  small_.append(static_cast<const char*>(data), bytes);
}

void ByteWriter::text(std::string_view text) {
  item(static_cast<uint64_t>(text.size()));
  small_.append(text);
}

void ByteWriter::block(const void* data, size_t bytes) {
  if (bytes == 0) return;
  if (bytes < kBlockBytes) copy(data, bytes);
  else blocks_.push_back({data, bytes, small_.size()});
}

Buffer<uint8_t> ByteWriter::sealed(BytesKind kind, Task& task) const {
  size_t total = kHeaderBytes + small_.size();
  for (const Block& block : blocks_) total += block.bytes;
  Buffer<uint8_t> out(total);
  if (total >= kLargeBytes) advise_large_pages(out.data(), total);
  {
    const ProgressSpan span(task, 0, 0.5);
    uint8_t* to = out.data() + kHeaderBytes;
    size_t copied = 0;  // of small_
    const auto copy_up_to = [&](size_t end) {
      std::memcpy(to, small_.data() + copied, end - copied);
      to += end - copied;
      copied = end;
    };
    for (const Block& block : blocks_) {
      copy_up_to(block.behind);
      parallel_for(task, block.bytes, kCopiedAtOnce, [&](size_t begin, size_t end) {
        std::memcpy(to + begin, static_cast<const char*>(block.data) + begin, end - begin);
      });
      to += block.bytes;
    }
    copy_up_to(small_.size());
  }
  const ProgressSpan span(task, 0.5, 1);
  write_header({out.data(), out.size()}, kind, task);
  return out;
}

}  // namespace jalon
