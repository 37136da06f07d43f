// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/files/fast_number.h"
#include "formats/files/component.h"
#include "formats/files/finish_cloud.h"
#include "formats/files/utf8.h"
#include "formats/text/layout.h"
#include "formats/text/text.h"

namespace jalon {

namespace {

constexpr size_t kBlockBytes = size_t{1} << 20;
constexpr size_t kMoreBytes = size_t{64}
                              << 10;  // read at a time to find the end of a block's last line
constexpr size_t kNumberBytes = 400;  // longest cell taken for a number with decimal comma

/// The lines that start in one block of the file. The cuts depend on the file only.
class Block {
 public:
  Block(const ByteSource& source, uint64_t data_begin, size_t index) : source_(source) {
    const uint64_t begin = data_begin + uint64_t{index} * kBlockBytes;
    const uint64_t from =
        index == 0 ? begin : begin - 1;  // the byte before tells whether a line starts here
    const auto nominal = static_cast<size_t>(
        std::min<uint64_t>(kBlockBytes, source.size() - begin) + (begin - from));
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
    if (size_ - at_ > kMaxLineBytes)
      source_.refuse(offset_ + at_, "a line is longer than %zu bytes", kMaxLineBytes);
    const uint64_t from = offset_ + size_;
    if (from >= source_.size()) return false;
    const auto more = static_cast<size_t>(std::min<uint64_t>(kMoreBytes, source_.size() - from));
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

struct BlockCount {
  uint64_t lines = 0, points = 0;
};

/// Where the cells of one column go, and what they turned out to be.
struct Column64 {
  enum Kind { kSkip, kNumbers, kSigned, kUnsigned, kFloats } kind = kSkip;
  void* out = nullptr;
  size_t stride = 1;  ///< elements from one point to the next
};

struct Range {
  bool integers = true, wide = false, beyond_signed = false, beyond_unsigned = false;
  double min = std::numeric_limits<double>::infinity(),
         max = -std::numeric_limits<double>::infinity();
  void add(const ParsedNumber& number) {
    integers = integers && number.integer;
    wide = wide || number.wide;
    beyond_signed = beyond_signed || number.beyond_signed;
    beyond_unsigned = beyond_unsigned || number.beyond_unsigned;
    min = std::min(min, number.value);
    max = std::max(max, number.value);
  }
  Range& operator+=(const Range& b) {
    integers = integers && b.integers;
    wide = wide || b.wide;
    beyond_signed = beyond_signed || b.beyond_signed;
    beyond_unsigned = beyond_unsigned || b.beyond_unsigned;
    min = std::min(min, b.min);
    max = std::max(max, b.max);
    return *this;
  }
};

using Ranges = std::vector<Range>;

class TextReader {
 public:
  TextReader(const ByteSource& source, const std::string& columns, Task& task)
      : source_(source), task_(task), layout_(detect_text_layout(source, columns)) {
    const uint64_t bytes = source.size() - layout_.data_offset;
    blocks_.resize(static_cast<size_t>((bytes + kBlockBytes - 1) / kBlockBytes));
  }

  Cloud run() {
    count();
    Buffer<double> xyz(3 * points_);
    prepare(xyz);
    Ranges ranges;
    {
      ProgressSpan span(task_, 0.15, 0.85, "reading text");
      ranges = parse();
    }
    reread_wide(ranges);
    Cloud cloud = make_cloud(std::move(xyz));
    add_fields(cloud, ranges);
    cloud.crs = layout_.crs;
    return cloud;
  }

 private:
  /// Lines and points of each block, turned into numbers of the first of each.
  void count() {
    ProgressSpan span(task_, 0, 0.15, "counting lines");
    parallel_chunks(task_, blocks_.size(), [&](size_t b) {
      Block block(source_, layout_.data_offset, b);
      for (std::string_view line; block.next(line);) {
        ++blocks_[b].lines;
        blocks_[b].points += is_data(line) ? 1 : 0;
      }
    });
    uint64_t line = layout_.data_line;
    for (BlockCount& block : blocks_) {
      const BlockCount first{line, points_};
      line += block.lines;
      points_ += block.points;
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
    columns_.resize(names.size());
    held_.resize(names.size());
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

  Ranges parse() {
    std::vector<Ranges> parts(blocks_.size());
    parallel_chunks(task_, blocks_.size(), [&](size_t b) {
      Ranges ranges(columns_.size());
      Block block(source_, layout_.data_offset, b);
      uint64_t number = blocks_[b].lines;
      size_t point = blocks_[b].points;
      for (std::string_view line; block.next(line); ++number)
        if (is_data(line)) parse_line(line, number, point++, ranges);
      parts[b] = std::move(ranges);
    });
    Ranges all(columns_.size());
    for (const Ranges& part : parts)
      for (size_t c = 0; c < part.size(); ++c) all[c] += part[c];
    return all;
  }

  void parse_line(std::string_view line, uint64_t number, size_t point, Ranges& ranges) const {
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
                         Range& range) const {
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
  void reread_wide(const Ranges& ranges) {
    std::vector<Column64> again(columns_.size());
    bool needed = false;
    for (size_t c = 0; c < columns_.size(); ++c) {
      const Range& range = ranges[c];
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
    ProgressSpan span(task_, 0.85, 0.9, "reading text");
    parse();
  }

  /// The smallest usual type of a column of whole numbers.
  static ElementType type_of(const std::string& name, const Range& range) {
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

  void add_fields(Cloud& cloud, const Ranges& ranges) {
    ProgressSpan span(task_, 0.9, 0.95);
    for (size_t c = 0; c < held_.size(); ++c) {
      if (held_[c] == nullptr) continue;
      task_.checkpoint(static_cast<double>(c) / static_cast<double>(held_.size()));
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
  Task& task_;
  TextLayout layout_;
  std::vector<BlockCount> blocks_;
  size_t points_ = 0;
  std::vector<Column64> columns_;
  std::vector<std::shared_ptr<Column>> held_;
  std::shared_ptr<Column> normal_;
};

}  // namespace

Cloud text_points(const ByteSource& source, const std::string& columns, Task& task) {
  return TextReader(source, columns, task).run();
}

Cloud read_text(const ByteSource& source, const ReadSettings& settings, Task& task) {
  return finish_cloud(text_points(source, settings.columns, task), source, settings.drop_invalid,
                      task);
}

}  // namespace jalon
