// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/code_list.h"

#include <cmath>
#include <map>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr size_t kListColumns = 5;  // ID, X, Y, Z, code

std::string_view without_blanks(std::string_view text) {
  const size_t first = text.find_first_not_of(" \r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \r\n") - first + 1);
}

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const size_t end = text.find(separator);
    parts.push_back(without_blanks(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

// Spreadsheets end lines with the separator of a column that is empty.
std::vector<std::string_view> columns_of(std::string_view line) {
  std::vector<std::string_view> columns =
      parts_of(line, line.find(';') != std::string_view::npos ? ';' : '\t');
  while (columns.size() > kListColumns && columns.back().empty()) columns.pop_back();
  return columns;
}

bool read_code(std::string_view text, CodedPoint& point) {
  const size_t dot = text.find('.');
  if (!parse_integer(text.substr(0, dot), point.sequence) || point.sequence < 0) return false;
  if (dot == std::string_view::npos) return true;
  return parse_integer(text.substr(dot + 1), point.modifier) && point.modifier >= 0;
}

bool read_place(const std::vector<std::string_view>& columns, Vec3& place) {
  for (int axis = 0; axis < 3; ++axis)
    if (!parse_number(columns[static_cast<size_t>(axis) + 1], place[axis])) return false;
  return is_finite(place);
}

// A heading names its columns: neither a coordinate nor the code begins as a number does. A first point that cannot be
// read is none, or it would be lost unsaid.
bool is_heading(const std::vector<std::string_view>& columns) {
  for (size_t k = 1; k < kListColumns; ++k)
    if (!columns[k].empty() &&
        std::string_view("0123456789+-.,").find(columns[k].front()) != std::string_view::npos)
      return false;
  return true;
}

bool has_decimal_comma(const std::vector<std::string_view>& columns) {
  for (size_t axis = 1; axis <= 3; ++axis)
    if (columns[axis].find(',') != std::string_view::npos) return true;
  return false;
}

// Lines by the id of their point: one that comes again is a slip, but for one place with another code.
class SeenIds {
 public:
  void add(const CodedPoint& point, std::string_view codes, CodeList& list) {
    const auto [first, is_new] = first_.try_emplace(point.id, Line{point, codes});
    if (is_new) return;
    const Line& before = first->second;
    if (before.point.position == point.position && before.codes != codes) return;
    const bool is_same = before.point.position == point.position;
    list.warnings.push_back({point.line, "point " + point.id,
                             "its id stands in line " + std::to_string(before.point.line) +
                                 " already" + (is_same ? "" : ": both are used")});
  }

 private:
  struct Line {
    CodedPoint point;
    std::string_view codes;
  };
  std::map<std::string, Line> first_;
};

// The codes of one line: each known one a point more, each other one a warning.
void add_codes(std::string_view text, const CodedPoint& bare, const CodeTable& table,
               CodeList& list) {
  for (const std::string_view code : parts_of(text, table.separator)) {
    CodedPoint point = bare;
    const std::string quoted = "\"" + std::string(code) + "\"";
    if (!read_code(code, point))
      list.warnings.push_back({bare.line, "point " + bare.id, quoted + " is no code"});
    else if (table.find(point.sequence) == nullptr)
      list.warnings.push_back(
          {bare.line, "point " + bare.id, "unknown code " + quoted + ": not used"});
    else list.points.push_back(std::move(point));
  }
}

}  // namespace

CodeList read_code_list(std::string_view text, const CodeTable& table, double unit_m) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // of a text that a spreadsheet saved
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  CodeList list;
  SeenIds seen;
  bool first_line = true;
  size_t number = 0;
  const bool has_feeds = text.find('\n') != std::string_view::npos;  // old files end lines by '\r'
  for (const std::string_view raw : parts_of(text, has_feeds ? '\n' : '\r')) {
    ++number;
    if (raw.empty() || raw.front() == '#') continue;
    const std::vector<std::string_view> columns = columns_of(raw);
    const bool may_be_heading = first_line;
    first_line = false;
    CodedPoint point;
    point.line = number;
    if (columns.size() != kListColumns)
      fail(Status::kFormat, "code list, line %zu: %zu columns; ID;X;Y;Z;code are five%s", number,
           columns.size(), columns.size() == 1 ? ", parted by semicolons or tabs" : "");
    point.id = columns[0];
    if (!read_place(columns, point.position)) {
      if (may_be_heading && is_heading(columns)) continue;
      fail(Status::kFormat, "code list, line %zu: X, Y and Z of point %s are not three numbers%s",
           number, point.id.c_str(),
           has_decimal_comma(columns) ? "; decimals stand behind a point, not a comma" : "");
    }
    point.position = point.position * unit_m;
    seen.add(point, columns[4], list);
    add_codes(columns[4], point, table, list);
  }
  return list;
}

}  // namespace jalon
