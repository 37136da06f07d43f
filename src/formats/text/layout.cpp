// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/text/layout.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "formats/files/fast_number.h"
#include "formats/files/utf8.h"

namespace jalon {

namespace {

constexpr size_t kSampleLines = 1000;
constexpr double kUnitTolerance = 0.02;  // of a normal written with 2 or 3 decimals

struct Line {
  std::string_view text;
  uint64_t offset = 0, number = 0;
};

using Cells = std::vector<std::string_view>;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
    text.remove_suffix(1);
  return text;
}

bool is_number(std::string_view cell, bool decimal_comma) {
  std::string copy(cell);
  if (decimal_comma) std::replace(copy.begin(), copy.end(), ',', '.');
  ParsedNumber number;
  return parse_number_at(copy.data(), copy.data() + copy.size(), number) ==
             copy.data() + copy.size() &&
         !copy.empty();
}

double number_of(std::string_view cell, bool decimal_comma) {
  std::string copy(cell);
  if (decimal_comma) std::replace(copy.begin(), copy.end(), ',', '.');
  ParsedNumber number;
  const char* end = parse_number_at(copy.data(), copy.data() + copy.size(), number);
  return end == nullptr ? std::nan("") : number.value;
}

char separator_of(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return ';';
  // "1,5 2,5 3,5" separates by blanks only if each cell still is one number; commas then would be
  // decimal, which blanks do not allow.
  return line.find(',') != std::string_view::npos && line.find('\t') == std::string_view::npos
             ? ','
             : ' ';
}

// The start of the file cut into lines.
class Head {
 public:
  explicit Head(const ByteSource& source)
      : bytes_(std::min<uint64_t>(source.size(), kMaxLineBytes), '\0') {
    bytes_.resize(source.read_some(0, bytes_.data(), bytes_.size()));
    whole_ = bytes_.size() == source.size();
    const std::string_view text = bytes_;
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
      source.refuse(0, "the text is UTF-16; save it as UTF-8");
    size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (uint64_t number = 1; at < text.size(); ++number) {
      const size_t end = text.find('\n', at);
      if (end == std::string_view::npos && !whole_) {
        if (at == 0) source.refuse(0, "the first line is longer than %zu bytes", kMaxLineBytes);
        break;
      }
      lines_.push_back(
          {trimmed(text.substr(at, end == std::string_view::npos ? end : end - at)), at, number});
      if (end == std::string_view::npos || lines_.size() > 4 * kSampleLines) break;
      at = end + 1;
    }
  }
  const std::vector<Line>& lines() const { return lines_; }

 private:
  std::string bytes_;
  bool whole_ = false;
  std::vector<Line> lines_;
};

bool has_xyz(const std::vector<std::string>& names) {
  return std::ranges::count(names, "x") == 1 && std::ranges::count(names, "y") == 1 &&
         std::ranges::count(names, "z") == 1;
}

bool has_normal(const std::vector<std::string>& names) {
  return std::ranges::count(names, "nx") != 0 && std::ranges::count(names, "ny") != 0 &&
         std::ranges::count(names, "nz") != 0;
}

std::vector<std::string> names_of(const Cells& cells) {
  std::vector<std::string> names;
  for (const std::string_view cell : cells) {
    const std::string clean = name_from_file(cell, "");
    names.push_back(clean == "-" || clean == "_" ? "" : usual_name(clean));
  }
  // r, g, b are colours only together.
  static constexpr const char* kColours[][2] = {{"r", "red"}, {"g", "green"}, {"b", "blue"}};
  const auto has = [&](const char* letter) {
    return std::ranges::count_if(names, [&](const std::string& n) { return lower(n) == letter; }) ==
           1;
  };
  if (has("r") && has("g") && has("b"))
    for (std::string& name : names)
      for (const auto& [letter, colour] : kColours)
        if (lower(name) == letter) name = std::string(colour);
  if (!has_xyz(names))  // surveyors' names of the coordinates
    for (std::string& name : names) {
      const std::string small = lower(name);
      if (small == "e" || small == "easting" || small == "east") name.assign(1, 'x');
      if (small == "n" || small == "northing" || small == "north") name.assign(1, 'y');
      if (small == "h" || small == "height" || small == "elevation" || small == "alt")
        name.assign(1, 'z');
    }
  return names;
}

// ---- the guess, for files that say nothing
// ---------------------------------------------------------------------------

struct Sample {
  std::vector<std::vector<double>> rows;
  bool whole_0_255(size_t first) const {
    for (const auto& row : rows)
      for (size_t c = first; c < first + 3; ++c)
        if (!(row[c] >= 0 && row[c] <= 255 && row[c] == std::floor(row[c]))) return false;
    return true;
  }
  bool unit(size_t first) const {
    for (const auto& row : rows) {
      const double square = row[first] * row[first] + row[first + 1] * row[first + 1] +
                            row[first + 2] * row[first + 2];
      const bool none = square == 0 || std::isnan(square);  // points without a normal
      if (!none && std::fabs(std::sqrt(square) - 1) > kUnitTolerance) return false;
    }
    return true;
  }
};

void put_three(std::vector<std::string>& names, const Sample& sample, size_t first,
               bool other_is_colour) {
  static constexpr const char* kColour[] = {"red", "green", "blue"};
  static constexpr const char* kNormal[] = {"nx", "ny", "nz"};
  const bool unit = sample.unit(first), colour = sample.whole_0_255(first);
  if (!unit && !colour) return;
  // Zeros and ones are both: the other three decide, then colour.
  const bool is_normal = unit && (!colour || other_is_colour);
  for (size_t c = 0; c < 3; ++c) names[first + c] = is_normal ? kNormal[c] : kColour[c];
}

std::vector<std::string> guessed_names(size_t count, const Sample& sample) {
  std::vector<std::string> names;
  for (size_t c = 0; c < count; ++c) names.push_back(numbered("column", c + 1));
  for (size_t c = 0; c < 3; ++c) names[c].assign(1, "xyz"[c]);
  const bool has_intensity = count == 4 || count == 7 || count == 10;
  if (has_intensity) names[3] = "intensity";
  const size_t first = has_intensity ? 4 : 3;
  if (count == 6 || count == 7) put_three(names, sample, first, false);
  if (count == 9 || count == 10) {
    const bool first_colour = sample.whole_0_255(first),
               second_colour = sample.whole_0_255(first + 3);
    put_three(names, sample, first, second_colour && !(first_colour && sample.unit(first + 3)));
    put_three(names, sample, first + 3, names[first] == "red");
    if (names[first] == names[first + 3])  // twice the same is no layout that anybody writes
      for (size_t c = 0; c < 3; ++c) names[first + 3 + c] = numbered("column", first + 4 + c);
  }
  return names;
}

// ---- putting it together
// ---------------------------------------------------------------------------------------------

class Detector {
 public:
  Detector(const ByteSource& source, const std::string& option)
      : source_(source), option_(option), head_(source) {}

  TextLayout run() {
    find_first_data();
    const Line first = head_.lines()[data_];
    layout_.data_offset = first.offset;
    layout_.data_line = first.number;
    const size_t count = cells_of(first.text, layout_.separator).size();
    if (count < 3) refuse(first, 1, "a point needs three coordinates");
    if (count > kMaxTextColumns)
      refuse(first, kMaxTextColumns, "more columns than the 4096 that are read");
    layout_.names = option_.empty() ? names_from_file(count) : names_from_option(first, count);
    if (!has_xyz(layout_.names)) refuse(first, 1, "the columns do not name x, y and z once each");
    make_unique();
    return layout_;
  }

 private:
  [[noreturn]] void refuse(const Line& line, size_t column, const char* reason) const {
    fail(Status::kFormat, "%.400s: line %llu, column %zu: %s", source_.path().c_str(),
         static_cast<unsigned long long>(line.number), column, reason);
  }

  // Passes over comments, a header line and the count line of PTS.
  void find_first_data() {
    const auto& lines = head_.lines();
    bool passed_header = false, passed_count = false;
    for (data_ = 0; data_ < lines.size(); ++data_) {
      const Line& line = lines[data_];
      if (is_comment(line.text)) {
        note_comment(line.text);
        continue;
      }
      const char separator = separator_of(line.text);
      const Cells cells = cells_of(line.text, separator);
      const bool comma = separator != ',' && decimal_comma(cells);
      if (is_count_line(line.text) && !passed_count) {
        passed_count = layout_.count_lines = true;
        continue;
      }
      if (is_number(cells[0], comma)) {
        layout_.separator = separator;
        layout_.decimal_comma = comma;
        return;
      }
      if (passed_header) refuse(line, 1, "this is no number");
      passed_header = true;
      header_ = line.text;
      header_separator_ = separator;
    }
    fail(Status::kFormat, "%.400s: line %zu, column 1: there is no line of numbers",
         source_.path().c_str(), lines.size());
  }

  static bool decimal_comma(const Cells& cells) {
    bool comma = false, point = false;
    for (const std::string_view cell : cells) {
      comma = comma || cell.find(',') != std::string_view::npos;
      point = point || cell.find('.') != std::string_view::npos;
    }
    return comma && !point;
  }

  void note_comment(std::string_view text) {
    const size_t mark = text.find_first_not_of("#/%! \t");
    if (mark == std::string_view::npos) return;
    text.remove_prefix(mark);
    if (text.starts_with("crs: ") && layout_.crs.empty()) layout_.crs = valid_utf8(text.substr(5));
    const std::vector<std::string> names = names_of(cells_of(text, separator_of(text)));
    if (has_xyz(names)) comment_names_ = names;
  }

  std::vector<std::string> names_from_file(size_t count) const {
    if (!header_.empty()) {
      std::vector<std::string> names = names_of(cells_of(header_, header_separator_));
      if (has_xyz(names)) {
        if (names.size() != count)
          refuse(head_.lines()[data_], std::min(names.size(), count),
                 "the header has another number of columns");
        return names;
      }
    }
    if (comment_names_.size() == count) return comment_names_;
    return guessed_names(count, sample(count));
  }

  std::vector<std::string> names_from_option(const Line& first, size_t count) const {
    std::string option = option_;
    std::replace_if(
        option.begin(), option.end(),
        [](char c) { return c == ',' || c == ';' || c == '\t' || c == '\n'; }, ' ');
    std::vector<std::string> names = names_of(cells_of(trimmed(option), ' '));
    if (!has_xyz(names))
      fail(Status::kInvalidArgument, "columns \"%.200s\" do not name x, y and z once each",
           option_.c_str());
    if (names.size() > count) {
      const std::string reason = "the line has " + std::to_string(count) + " columns, " +
                                 std::to_string(names.size()) + " were named";
      refuse(first, count, reason.c_str());
    }
    names.resize(count);
    return names;
  }

  Sample sample(size_t count) const {
    Sample out;
    for (size_t i = data_; i < head_.lines().size() && out.rows.size() < kSampleLines; ++i) {
      const Line& line = head_.lines()[i];
      const Cells cells = cells_of(line.text, layout_.separator);
      if (is_comment(line.text) || cells.size() != count) continue;
      std::vector<double> row;
      for (const std::string_view cell : cells)
        row.push_back(number_of(cell, layout_.decimal_comma));
      out.rows.push_back(std::move(row));
    }
    return out;
  }

  void make_unique() {
    UniqueNames unique;
    if (has_normal(layout_.names)) unique.add("normal");  // the field that these three become
    for (std::string& name : layout_.names)
      if (!name.empty()) name = unique.add(name);
  }

  const ByteSource& source_;
  const std::string& option_;
  Head head_;
  size_t data_ = 0;
  std::string_view header_;
  char header_separator_ = ' ';
  std::vector<std::string> comment_names_;
  TextLayout layout_;
};

}  // namespace

bool is_comment(std::string_view line) {
  line = trimmed(line);
  return line.empty() || line.front() == '#' || line.front() == '%' || line.starts_with("//");
}

bool is_count_line(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && line.find_first_not_of("0123456789") == std::string_view::npos;
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  line = trimmed(line);
  while (!line.empty() && cells.size() <= kMaxTextColumns) {
    size_t end = separator == ' ' ? line.find_first_of(" \t") : line.find(separator);
    const bool last = end == std::string_view::npos;
    if (last) end = line.size();
    std::string_view cell = trimmed(line.substr(0, end));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
    cells.push_back(cell);
    line.remove_prefix(last ? line.size() : end + 1);
    if (separator == ' ') {
      line = trimmed(line);
    } else if (line.empty() && !last) {
      cells.push_back({});  // "1;2;": an empty cell at the end
    }
  }
  return cells;
}

std::string usual_name(std::string_view name) {
  static constexpr struct {
    const char *alias, *name;
  } kAliases[] = {{"x", "x"},
                  {"y", "y"},
                  {"z", "z"},
                  {"i", "intensity"},
                  {"intensity", "intensity"},
                  {"red", "red"},
                  {"green", "green"},
                  {"blue", "blue"},
                  {"nx", "nx"},
                  {"ny", "ny"},
                  {"nz", "nz"},
                  {"normalx", "nx"},
                  {"normaly", "ny"},
                  {"normalz", "nz"},
                  {"normal_x", "nx"},
                  {"normal_y", "ny"},
                  {"normal_z", "nz"},
                  {"x[m]", "x"},
                  {"y[m]", "y"},
                  {"z[m]", "z"},
                  {"gpstime", "gps_time"}};
  const std::string small = lower(name);
  for (const auto& row : kAliases)
    if (small == row.alias) return row.name;
  return std::string(name);
}

TextLayout detect_text_layout(const ByteSource& source, const std::string& columns_option) {
  return Detector(source, columns_option).run();
}

}  // namespace jalon
