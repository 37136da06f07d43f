// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "formats/files/byte_source.h"
#include "formats/text/layout.h"

namespace jalon {

/// The lines of a text file one after the other, without their ends; memory for one line of at most
/// 1 MiB.
class LineReader {
 public:
  explicit LineReader(const ByteSource& source) : source_(source) {}

  bool next(std::string_view& line) {
    size_t end = buffer_.find('\n', at_);
    while (end == std::string::npos && more()) end = buffer_.find('\n', at_);
    if (end == std::string::npos) {
      if (at_ >= buffer_.size()) return false;
      end = buffer_.size();
    }
    line = std::string_view(buffer_).substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    at_ = std::min(end + 1, buffer_.size());
    ++number_;
    return true;
  }

  uint64_t number() const { return number_; }  ///< of the line just read, from 1
  double fraction() const {
    return static_cast<double>(offset_) / static_cast<double>(source_.size() + 1);
  }

 private:
  bool more() {
    constexpr size_t kMore = size_t{256} << 10;
    buffer_.erase(0, at_);
    at_ = 0;
    if (buffer_.size() > kMaxLineBytes)
      source_.refuse(offset_ - buffer_.size(), "a line is longer than %zu bytes", kMaxLineBytes);
    const size_t have = buffer_.size();
    buffer_.resize(have + kMore);
    const size_t read = source_.read_some(offset_, buffer_.data() + have, kMore);
    buffer_.resize(have + read);
    offset_ += read;
    return read != 0;
  }

  const ByteSource& source_;
  std::string buffer_;
  size_t at_ = 0;
  uint64_t offset_ = 0, number_ = 0;
};

}  // namespace jalon
