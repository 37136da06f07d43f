// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "formats/files/byte_source.h"

namespace jalon {

/// The lines at the begin of a file whose header is text and whose data may not be: up to a mebibyte of them.
class HeaderLines {
 public:
  explicit HeaderLines(const ByteSource& source)
      : bytes_(std::min<uint64_t>(source.size(), kMostBytes), '\0') {
    bytes_.resize(source.read_some(0, bytes_.data(), bytes_.size()));
  }

  /// The next whole line, without its end; false where there is none.
  bool next(std::string_view& line) {
    const size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) return false;
    line = std::string_view(bytes_).substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    at_ = end + 1;
    return true;
  }
  /// Where the next line begins.
  size_t at() const { return at_; }

 private:
  static constexpr size_t kMostBytes = size_t{1} << 20;
  std::string bytes_;
  size_t at_ = 0;
};

}  // namespace jalon
