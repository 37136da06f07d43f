// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>

#include "formats/files/byte_source.h"
#include "formats/text/layout.h"

namespace jalon {

constexpr size_t kTextBlockBytes = size_t{1} << 20;

/// The lines that start in one block of the file. The cuts depend on the file only.
class BlockLines {
 public:
  BlockLines(const ByteSource& source, uint64_t data_begin, size_t index) : source_(source) {
    const uint64_t begin = data_begin + uint64_t{index} * kTextBlockBytes;
    const uint64_t from =
        index == 0 ? begin : begin - 1;  // the byte before tells whether a line starts here
    const auto nominal = static_cast<size_t>(
        std::min<uint64_t>(kTextBlockBytes, source.size() - begin) + (begin - from));
    bytes_.reset(static_cast<char*>(std::malloc(nominal)));
    if (!bytes_) throw std::bad_alloc();
    size_ = source.read_some(from, bytes_.get(), nominal);
    offset_ = from;
    limit_ = size_;
    if (index != 0) {
      const void* feed = size_ == 0 ? nullptr : std::memchr(bytes_.get(), '\n', size_);
      at_ = feed == nullptr
                ? size_
                : static_cast<size_t>(static_cast<const char*>(feed) - bytes_.get()) + 1;
    }
  }

  /// The next line that starts in the block, without its line feed.
  bool next(std::string_view& line) {
    if (at_ >= limit_) return false;
    const void* feed = std::memchr(bytes_.get() + at_, '\n', size_ - at_);
    while (feed == nullptr && read_more())
      feed = std::memchr(bytes_.get() + at_, '\n', size_ - at_);
    const size_t end = feed == nullptr
                           ? size_
                           : static_cast<size_t>(static_cast<const char*>(feed) - bytes_.get());
    line = {bytes_.get() + at_, end - at_};
    at_ = end + 1;
    return true;
  }

 private:
  bool read_more() {
    constexpr size_t kMore = size_t{64} << 10;  // at a time, to find the end of the last line
    if (size_ - at_ > kMaxLineBytes)
      source_.refuse(offset_ + at_, "a line is longer than %zu bytes", kMaxLineBytes);
    const uint64_t from = offset_ + size_;
    if (from >= source_.size()) return false;
    const auto more = static_cast<size_t>(std::min<uint64_t>(kMore, source_.size() - from));
    char* larger = static_cast<char*>(std::realloc(bytes_.get(), size_ + more));
    if (larger == nullptr) throw std::bad_alloc();
    (void)bytes_.release();
    bytes_.reset(larger);
    const size_t read = source_.read_some(from, bytes_.get() + size_, more);
    size_ += read;
    return read != 0;
  }

  struct Free {
    void operator()(char* p) const { std::free(p); }
  };
  const ByteSource& source_;
  std::unique_ptr<char, Free> bytes_;
  size_t size_ = 0, limit_ = 0, at_ = 0;
  uint64_t offset_ = 0;
};

}  // namespace jalon
