// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/files/fast_number.h"
#include "formats/files/component.h"
#include "formats/files/finish_cloud.h"
#include "formats/files/utf8.h"
#include "formats/text/block_lines.h"
#include "formats/text/column_ranges.h"
#include "formats/text/layout.h"
#include "formats/text/text.h"

namespace jalon {

namespace {

constexpr size_t kNumberBytes = 400;  // longest cell taken for a number with decimal comma

struct BlockCount {
  uint64_t lines = 0, points = 0;
};

/// Where the cells of one column go, and what they turned out to be.
struct Column64 {
  enum Kind { kSkip, kNumbers, kSigned, kUnsigned, kFloats } kind = kSkip;
  void* out = nullptr;
  size_t stride = 1;  ///< elements from one point to the next
};

class TextReader {
 public:
  TextReader(const ByteSource& source, const std::string& columns, Task& task)
      : source_(source), task_(&task), layout_(detect_text_layout(source, columns)) {
    const uint64_t bytes = source.size() - layout_.data_offset;
    blocks_.resize(static_cast<size_t>((bytes + kTextBlockBytes - 1) / kTextBlockBytes));
    count();
    end_ = blocks_.size();
    points_ = all_points_;
  }

  uint64_t all_points() const { return all_points_; }

  /// What is read from now on: the blocks behind the last part, of so many points or a few more; false behind the last
  /// block. The first part begins with the file.
  bool next_part(size_t most) {
    first_ = is_cut_ ? end_ : 0;
    is_cut_ = true;
    end_ = first_;
    while (end_ < blocks_.size() && points_before(end_) - points_before(first_) < most) ++end_;
    points_ = static_cast<size_t>(points_before(end_) - points_before(first_));
    return first_ < blocks_.size();
  }
  void rewind(Task& task) {
    is_cut_ = false;
    task_ = &task;
  }

  /// What stands in the columns; adds whether all coordinates are finite.
  ColumnRanges ranges(bool& all_finite) {
    Buffer<double> xyz(3 * points_);
    prepare(xyz);
    ColumnRanges out = parse();
    all_finite = all_finite && std::ranges::all_of(xyz, [](double v) { return std::isfinite(v); });
    return out;
  }

  /// Types by what all parts hold; null: by what is read.
  Cloud run(const ColumnRanges* of_all) {
    Buffer<double> xyz(3 * points_);
    prepare(xyz);
    ColumnRanges ranges;
    {
      ProgressSpan span(*task_, 0.15, 0.85, "reading text");
      ranges = parse();
    }
    if (of_all != nullptr) ranges = *of_all;
    reread_wide(ranges);
    Cloud cloud = make_cloud(std::move(xyz));
    add_fields(cloud, ranges);
    cloud.crs = layout_.crs;
    return cloud;
  }

 private:
  uint64_t points_before(size_t block) const {
    return block < blocks_.size() ? blocks_[block].points : all_points_;
  }

  /// Lines and points of each block, turned into numbers of the first of each.
  void count() {
    ProgressSpan span(*task_, 0, 0.15, "counting lines");
    parallel_chunks(*task_, blocks_.size(), [&](size_t b) {
      BlockLines block(source_, layout_.data_offset, b);
      for (std::string_view line; block.next(line);) {
        ++blocks_[b].lines;
        blocks_[b].points += is_data(line) ? 1 : 0;
      }
    });
    uint64_t line = layout_.data_line;
    for (BlockCount& block : blocks_) {
      const BlockCount first{line, all_points_};
      line += block.lines;
      all_points_ += block.points;
      block = first;
    }
  }

  bool is_data(std::string_view line) const {
    return !is_comment(line) && !(layout_.count_lines && is_count_line(line));
  }

  /// One array a column: coordinates and normals in place, all others as doubles until their kind
  /// is known.
  void prepare(Buffer<double>& xyz) {
    const auto& names = layout_.names;
    columns_.assign(names.size(), {});
    held_.assign(names.size(), nullptr);
    const bool normals = std::ranges::count(names, "nx") == 1 &&
                         std::ranges::count(names, "ny") == 1 &&
                         std::ranges::count(names, "nz") == 1;
    if (normals)
      normal_ = std::make_shared<Column>(
          FieldInfo{"normal", ElementType::kFloat32, 3, "", "unit normal"}, points_);
    for (size_t c = 0; c < names.size(); ++c) {
      if (names[c].empty()) continue;
      for (size_t k = 0; k < 3; ++k) {
        if (names[c] == std::string_view("xyz").substr(k, 1))
          columns_[c] = {Column64::kNumbers, component(xyz.data(), k), 3};
        if (normals && names[c] == std::string("n") + "xyz"[k])
          columns_[c] = {Column64::kFloats, component(static_cast<float*>(normal_->raw()), k), 3};
      }
      if (columns_[c].kind != Column64::kSkip) continue;
      held_[c] =
          std::make_shared<Column>(FieldInfo{names[c], ElementType::kFloat64, 1, "", ""}, points_);
      columns_[c] = {Column64::kNumbers, held_[c]->raw(), 1};
    }
  }

  ColumnRanges parse() {
    std::vector<ColumnRanges> parts(end_ - first_);
    parallel_chunks(*task_, parts.size(), [&](size_t i) {
      const size_t b = first_ + i;
      ColumnRanges ranges(columns_.size());
      BlockLines block(source_, layout_.data_offset, b);
      uint64_t number = blocks_[b].lines;
      auto point = static_cast<size_t>(blocks_[b].points - points_before(first_));
      for (std::string_view line; block.next(line); ++number)
        if (is_data(line)) parse_line(line, number, point++, ranges);
      parts[i] = std::move(ranges);
    });
    ColumnRanges all(columns_.size());
    for (const ColumnRanges& part : parts) add(all, part);
    return all;
  }

  void parse_line(std::string_view line, uint64_t number, size_t point,
                  ColumnRanges& ranges) const {
    const char* p = line.data();
    const char* end = p + line.size();
    while (end > p && (end[-1] == '\r' || is_blank(end[-1]))) --end;
    for (size_t c = 0; c < columns_.size(); ++c) {
      while (p < end && is_blank(*p)) ++p;
      p = parse_cell(p, end, c, number, point, ranges[c]);
      while (p < end && is_blank(*p)) ++p;
      if (layout_.separator == ' ' || p == end) continue;
      if (*p != layout_.separator) refuse(number, c, "this is no number");
      if (++p == end && c + 1 == columns_.size())
        refuse(number, c + 1, "the line has more columns than the first one");
    }
    if (p < end) refuse(number, columns_.size(), "the line has more columns than the first one");
  }

  static bool is_blank(char c) { return c == ' ' || c == '\t'; }

  // An empty cell of a table is a value that is not there; of blank-separated text it is a line too
  // short.
  const char* parse_cell(const char* p, const char* end, size_t c, uint64_t number, size_t point,
                         ColumnRange& range) const {
    ParsedNumber value;
    const bool empty = p == end || (layout_.separator != ' ' && *p == layout_.separator);
    if (empty) {
      if (layout_.separator == ' ' || (p == end && c != 0 && p[-1] != layout_.separator))
        refuse(number, c, "the line has fewer columns than the first one");
      value.value = std::nan("");
    }
    const char* stop = p;
    const bool quoted = !empty && *p == '"';
    if (quoted) ++p;
    if (!empty && columns_[c].kind != Column64::kSkip) {
      stop = layout_.decimal_comma ? parse_comma(p, end, value) : parse_number_at(p, end, value);
      if (stop == nullptr || !(stop == end || is_blank(*stop) || *stop == layout_.separator ||
                               (quoted && *stop == '"')))
        refuse(number, c, "this is no number");
      if (quoted && stop < end && *stop == '"') ++stop;
    } else if (!empty) {
      while (stop < end &&
             (layout_.separator == ' ' ? !is_blank(*stop) : *stop != layout_.separator))
        ++stop;
      return stop;
    }
    put(columns_[c], point, value, p, end);
    range.add(value);
    return stop;
  }

  const char* parse_comma(const char* p, const char* end, ParsedNumber& value) const {
    char copy[kNumberBytes];
    size_t n = 0;
    while (p + n < end && n < sizeof copy && !is_blank(p[n]) && p[n] != layout_.separator) {
      copy[n] = p[n] == ',' ? '.' : p[n];
      ++n;
    }
    const char* stop = parse_number_at(copy, copy + n, value);
    return stop == nullptr ? nullptr : p + (stop - copy);
  }

  static void put(const Column64& column, size_t point, const ParsedNumber& value, const char* text,
                  const char* end) {
    const size_t at = point * column.stride;
    if (column.kind == Column64::kNumbers) static_cast<double*>(column.out)[at] = value.value;
    if (column.kind == Column64::kFloats)
      static_cast<float*>(column.out)[at] = static_cast<float>(value.value);
    if (text < end && *text == '+') ++text;
    if (column.kind == Column64::kSigned)
      std::from_chars(text, end, static_cast<int64_t*>(column.out)[at]);
    if (column.kind == Column64::kUnsigned)
      std::from_chars(text, end, static_cast<uint64_t*>(column.out)[at]);
  }

  [[noreturn]] void refuse(uint64_t line, size_t column, const char* reason) const {
    fail(Status::kFormat, "%.400s: line %llu, column %zu: %s", source_.path().c_str(),
         static_cast<unsigned long long>(line), column + 1, reason);
  }

  /// Whole numbers beyond 2^53 are read once more, as 64-bit integers.
  void reread_wide(const ColumnRanges& ranges) {
    std::vector<Column64> again(columns_.size());
    bool needed = false;
    for (size_t c = 0; c < columns_.size(); ++c) {
      const ColumnRange& range = ranges[c];
      if (held_[c] == nullptr || !range.wide || !range.integers) continue;
      const bool as_signed = !range.beyond_signed;
      if (!as_signed && (range.beyond_unsigned || range.min < 0)) continue;
      FieldInfo field = held_[c]->info();
      field.type = as_signed ? ElementType::kInt64 : ElementType::kUint64;
      held_[c] = std::make_shared<Column>(field, points_);
      again[c] = {as_signed ? Column64::kSigned : Column64::kUnsigned, held_[c]->raw(), 1};
      needed = true;
    }
    if (!needed) return;
    columns_.swap(again);
    ProgressSpan span(*task_, 0.85, 0.9, "reading text");
    parse();
  }

  /// The smallest usual type of a column of whole numbers.
  static ElementType type_of(const std::string& name, const ColumnRange& range) {
    using enum ElementType;
    const auto within = [&](double low, double high) {
      return range.min >= low && range.max <= high;
    };
    if (!range.integers || range.wide || !(range.min <= range.max)) return kFloat64;
    for (const char* byte :
         {"classification", "return_number", "number_of_returns", "scan_direction",
          "edge_of_flight_line", "synthetic", "key_point", "withheld", "overlap", "scanner_channel",
          "user_data", "red", "green", "blue"})
      if (name == byte && within(0, 255)) return kUint8;
    for (const char* pair : {"intensity", "red", "green", "blue", "nir", "point_source_id"})
      if (name == pair && within(0, 65535)) return kUint16;
    if (name == "gps_time" || name == "scan_angle") return kFloat64;
    if (within(-2147483648.0, 2147483647.0)) return kInt32;
    return within(0, 4294967295.0) ? kUint32 : kInt64;
  }

  void add_fields(Cloud& cloud, const ColumnRanges& ranges) {
    ProgressSpan span(*task_, 0.9, 0.95);
    for (size_t c = 0; c < held_.size(); ++c) {
      if (held_[c] == nullptr) continue;
      task_->checkpoint(static_cast<double>(c) / static_cast<double>(held_.size()));
      const ElementType type = type_of(layout_.names[c], ranges[c]);
      if (held_[c]->info().type == ElementType::kFloat64 && type != ElementType::kFloat64) {
        FieldInfo field = held_[c]->info();
        field.type = type;
        auto narrow = std::make_shared<Column>(field, points_);
        store_converted(*narrow, 0, held_[c]->raw(), ElementType::kFloat64, points_,
                        sizeof(double));
        held_[c] = std::move(narrow);
      }
      cloud.fields.set(std::move(held_[c]));
    }
    if (normal_) cloud.fields.set(std::move(normal_));
  }

  const ByteSource& source_;
  Task* task_;
  TextLayout layout_;
  std::vector<BlockCount> blocks_;
  uint64_t all_points_ = 0;
  size_t first_ = 0, end_ = 0;  ///< blocks of the part that is read: all where none was cut
  bool is_cut_ = false;
  size_t points_ = 0;  ///< of that part
  std::vector<Column64> columns_;
  std::vector<std::shared_ptr<Column>> held_;
  std::shared_ptr<Column> normal_;
};

/// Read twice: what types the columns have is known when all is read.
class TextPieces : public CloudPieces {
 public:
  TextPieces(const ByteSource& source, const std::string& columns, Task& task)
      : reader_(source, columns, task) {}

  uint64_t count() const override { return reader_.all_points(); }
  double look_share() const override { return kLookShare; }

  bool look_through(Task& task) override {
    reader_.rewind(task);
    bool all_finite = true;
    for (uint64_t passed = 0; all_finite && reader_.next_part(kLookPoints); passed += kLookPoints) {
      ProgressSpan span(task, share(passed), share(passed + kLookPoints), "reading text");
      add(ranges_, reader_.ranges(all_finite));
    }
    return all_finite;
  }

  void rewind() override { is_begun_ = false; }

  bool next(size_t most, Cloud& piece, Task& task) override {
    if (!is_begun_) reader_.rewind(task);
    const bool is_first = !is_begun_;
    is_begun_ = true;
    piece = {};
    if (!reader_.next_part(most) && !is_first) return false;
    piece = reader_.run(&ranges_);
    return true;
  }

 private:
  static constexpr double kLookShare = 0.4;  // parsing once more, and writing
  static constexpr size_t kLookPoints = size_t{1} << 19;
  double share(uint64_t points) const {
    const uint64_t all = std::max<uint64_t>(count(), 1);
    return static_cast<double>(std::min(points, all)) / static_cast<double>(all);
  }

  TextReader reader_;
  ColumnRanges ranges_;
  bool is_begun_ = false;
};

}  // namespace

Cloud text_points(const ByteSource& source, const std::string& columns, Task& task) {
  return TextReader(source, columns, task).run(nullptr);
}

std::unique_ptr<CloudPieces> pieces_of_text(const ByteSource& source, const std::string& columns,
                                            Task& task) {
  return std::make_unique<TextPieces>(source, columns, task);
}

std::unique_ptr<CloudPieces> text_pieces(const ByteSource& source, const ReadSettings& settings,
                                         Task& task) {
  // Below, parsing once more costs more than it saves: some 300 MB of points.
  constexpr uint64_t kLeastBytes = uint64_t{256} << 20;
  if (source.size() < kLeastBytes) return nullptr;
  return pieces_of_text(source, settings.columns, task);
}

Cloud read_text(const ByteSource& source, const ReadSettings& settings, Task& task) {
  return finish_cloud(text_points(source, settings.columns, task), source, settings.drop_invalid,
                      task);
}

}  // namespace jalon
