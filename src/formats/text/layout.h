// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/files/byte_source.h"

namespace jalon {

constexpr size_t kMaxLineBytes = size_t{1} << 20;
constexpr size_t kMaxTextColumns = 4096;

/// How a text file of points is laid out.
struct TextLayout {
  char separator = ' ';  ///< ' ': any run of blanks and tabs
  bool decimal_comma = false;
  bool count_lines = false;  ///< lines of one whole number (PTS) tell a count and are passed over
  std::vector<std::string> names;  ///< of each column of the file; "" = skipped
  std::string crs;
  uint64_t data_offset = 0;  ///< of the first line with points
  uint64_t data_line = 1;    ///< its number
};

/// True for lines that hold no data: blank, or starting with # or // or %.
bool is_comment(std::string_view line);
/// True for a line that is one whole number, the count of PTS, whatever separates the cells of others.
bool is_count_line(std::string_view line);
/// The cells of a line; quotes around a cell are taken off.
std::vector<std::string_view> cells_of(std::string_view line, char separator);
/// Looks at the start of the file: separator, header line, and what the columns are: the option's
/// names, the header's, or a guess (3: x y z; 4: + intensity; 6 to 10: colours are whole numbers
/// 0-255, normals have unit length; both orders of 9 and 10 columns).
TextLayout detect_text_layout(const ByteSource& source, const std::string& columns_option);
/// The usual name of a column: "i" -> "intensity", "NormalX" -> "nx" ...
std::string usual_name(std::string_view name);

}  // namespace jalon
