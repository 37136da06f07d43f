// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "formats/text/line_reader.h"

namespace jalon::dxf {

/// The groups of a DXF file as text: a line with a code, a line with its value.
class GroupReader {
 public:
  explicit GroupReader(const ByteSource& source) : source_(source), lines_(source) {}

  /// The next group; false at the end of the file. A group without a value is refused.
  bool next();
  /// The next next() gives the same group again.
  void put_back() { is_kept_ = true; }

  int code() const { return code_; }
  std::string_view value() const {
    return value_;
  }  ///< until the next group; blanks around it are gone
  bool is(int code, std::string_view value) const { return code_ == code && value_ == value; }
  double number() const;    ///< finite, else refused
  int64_t integer() const;  ///< refused where it is none
  /// A name or text: \U+XXXX as the character, valid UTF-8.
  std::string text() const;

  double fraction() const { return lines_.fraction(); }
  uint64_t line() const { return lines_.number(); }
  /// Error(kFormat) "path: line N: reason".
  [[noreturn]] void refuse(const char* format, ...) const JALON_PRINTF(2, 3);

 private:
  const ByteSource& source_;
  LineReader lines_;
  int code_ = 0;
  std::string value_;
  bool is_kept_ = false;
};

}  // namespace jalon::dxf
