// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/pcd/header.h"

#include <charconv>
#include <cmath>
#include <cstring>

#include "base/text_number.h"
#include "formats/files/growing_cloud.h"
#include "formats/files/header_lines.h"
#include "formats/files/utf8.h"
#include "formats/text/layout.h"
#include "geometry/rotation.h"

namespace jalon::pcd {

namespace {

constexpr size_t kMaxMembers = 4096;
constexpr double kUnitQuaternion = 1e-3;  // written with three decimals and more

using Words = std::vector<std::string_view>;

// Error: false.
bool element_type(std::string_view letter, uint64_t size, ElementType& out) {
  static constexpr struct {
    char letter;
    uint64_t size;
    ElementType type;
  } kTypes[] = {{'I', 1, ElementType::kInt8},    {'I', 2, ElementType::kInt16},
                {'I', 4, ElementType::kInt32},   {'I', 8, ElementType::kInt64},
                {'U', 1, ElementType::kUint8},   {'U', 2, ElementType::kUint16},
                {'U', 4, ElementType::kUint32},  {'U', 8, ElementType::kUint64},
                {'F', 4, ElementType::kFloat32}, {'F', 8, ElementType::kFloat64}};
  for (const auto& row : kTypes)
    if (letter.size() == 1 && letter[0] == row.letter && size == row.size) {
      out = row.type;
      return true;
    }
  return false;
}

class HeaderParser {
 public:
  explicit HeaderParser(const ByteSource& source) : source_(source), lines_(source) {}

  Header run() {
    for (bool is_done = false; !is_done;) {
      const size_t at = lines_.at();
      std::string_view line;
      if (!next(line)) source_.refuse(at, "the header has no line DATA");
      if (line.starts_with("# crs: ")) header_.crs = valid_utf8(line.substr(7));
      if (line.starts_with('#')) continue;
      const Words words = cells_of(line, ' ');
      if (!words.empty()) is_done = take(words, at);
    }
    header_.data_offset = lines_.at();
    make_members();
    count_points();
    require_room();
    return std::move(header_);
  }

 private:
  bool next(std::string_view& line) {
    if (!lines_.next(line)) return false;
    ++header_.data_line;
    return true;
  }

  // True behind the last line. "COLUMNS" stands for FIELDS in the oldest files.
  bool take(const Words& words, size_t at) {
    const std::string_view key = words[0];
    if (words.size() > kMaxMembers + 1) source_.refuse(at, "more than %zu fields", kMaxMembers);
    if (key == "FIELDS" || key == "COLUMNS") names_.assign(words.begin() + 1, words.end());
    if (key == "TYPE") types_.assign(words.begin() + 1, words.end());
    if (key == "SIZE") sizes_ = numbers(words, at);
    if (key == "COUNT") counts_ = numbers(words, at);
    if (key == "VIEWPOINT") take_viewpoint(words, at);
    for (const auto& [name, out] :
         {std::pair{"WIDTH", &width_}, {"HEIGHT", &height_}, {"POINTS", &points_}})
      if (key == name) {
        const auto read = numbers(words, at);
        if (read.size() != 1) source_.refuse(at, "%s needs one number", name);
        *out = static_cast<int64_t>(read[0]);
      }
    if (key != "DATA") return false;
    const std::string_view form = words.size() > 1 ? words[1] : "";
    if (form == "ascii") header_.data = Data::kAscii;
    else if (form == "binary") header_.data = Data::kBinary;
    else if (form == "binary_compressed") header_.data = Data::kCompressed;
    else source_.refuse(at, "DATA is none of ascii, binary, binary_compressed");
    return true;
  }

  std::vector<uint64_t> numbers(const Words& words, size_t at) const {
    std::vector<uint64_t> out;
    for (size_t i = 1; i < words.size(); ++i) {
      int64_t number = 0;
      if (!parse_integer(words[i], number) || number < 0)
        source_.refuse(at, "a count in the header is no whole number");
      out.push_back(static_cast<uint64_t>(number));
    }
    return out;
  }

  // tx ty tz qw qx qy qz
  void take_viewpoint(const Words& words, size_t at) {
    double v[7];
    if (words.size() != 8) source_.refuse(at, "VIEWPOINT needs seven numbers");
    for (size_t i = 0; i < 7; ++i)
      if (!parse_number(words[i + 1], v[i]) || !std::isfinite(v[i]))
        source_.refuse(at, "VIEWPOINT holds what is no finite number");
    const double length = std::hypot(std::hypot(v[3], v[4]), std::hypot(v[5], v[6]));
    if (!(std::fabs(length - 1) <= kUnitQuaternion))
      source_.refuse(at, "the quaternion of VIEWPOINT has not the length 1");
    const Matrix3 r = matrix_of({v[3] / length, v[4] / length, v[5] / length, v[6] / length});
    for (size_t i = 0; i < 3; ++i) {
      for (size_t k = 0; k < 3; ++k) header_.pose.m[4 * i + k] = r.m[3 * i + k];
      header_.pose.m[4 * i + 3] = v[i];
    }
    header_.has_pose = header_.pose.m != Transform{}.m;
  }

  void make_members() {
    const auto refuse_lists = [&](const char* what) {
      source_.refuse(0, "%s of the header has another number of entries than FIELDS", what);
    };
    if (names_.empty()) source_.refuse(0, "the header names no fields");
    if (sizes_.empty()) sizes_.assign(names_.size(), 4);  // 0.5 had neither
    if (types_.empty()) types_.assign(names_.size(), "F");
    if (counts_.empty()) counts_.assign(names_.size(), 1);
    if (sizes_.size() != names_.size()) refuse_lists("SIZE");
    if (types_.size() != names_.size()) refuse_lists("TYPE");
    if (counts_.size() != names_.size()) refuse_lists("COUNT");
    for (size_t i = 0; i < names_.size(); ++i) {
      Member member;
      member.name = name_from_file(names_[i], numbered("field", i + 1));
      if (!element_type(types_[i], sizes_[i], member.type))
        source_.refuse(0,
                       "field \"%.60s\" has a type that is none of I, U with 1, 2, 4 or 8 "
                       "bytes and F with 4 or 8",
                       member.name.c_str());
      if (counts_[i] == 0 || counts_[i] > kMostComponents)
        source_.refuse(0, "field \"%.60s\" has a COUNT that is not from 1 to %u",
                       member.name.c_str(), kMostComponents);
      member.count = static_cast<uint32_t>(counts_[i]);
      member.offset = header_.record_bytes;
      header_.record_bytes += member.bytes();
      header_.members.push_back(std::move(member));
    }
  }

  void count_points() {
    if (width_ < 0 && points_ < 0) source_.refuse(0, "the header has neither WIDTH nor POINTS");
    header_.height = height_ < 0 ? 1 : static_cast<uint64_t>(height_);
    header_.width = static_cast<uint64_t>(width_ < 0 ? points_ : width_);
    const uint64_t rows = std::max<uint64_t>(1, header_.height);
    if (header_.width > ~uint64_t{0} / rows) source_.refuse(0, "WIDTH x HEIGHT is beyond 64 bits");
    const uint64_t cells = header_.width * header_.height;
    header_.points = points_ < 0 ? cells : static_cast<uint64_t>(points_);
    if (width_ >= 0 && height_ >= 0 && header_.points != cells)
      source_.refuse(0, "POINTS is not WIDTH x HEIGHT");
  }

  void require_room() const {
    const uint64_t room = source_.size() - header_.data_offset;
    uint64_t values = 0;
    for (const Member& member : header_.members) values += member.count;
    // A digit and what parts it from the next; the last line may lack its end. One token of LZF of
    // three bytes stands for at most 264 (liblzf, lzf_d.c).
    const uint64_t least = header_.data == Data::kAscii ? 2 * values : header_.record_bytes;
    const uint64_t most = header_.data == Data::kAscii    ? (room + 1) / least
                          : header_.data == Data::kBinary ? room / least
                                                          : room * 88 / least;
    if (header_.points > most)
      source_.refuse(
          header_.data_offset, "the header promises %llu points, the file has room for %llu",
          static_cast<unsigned long long>(header_.points), static_cast<unsigned long long>(most));
  }

  const ByteSource& source_;
  HeaderLines lines_;
  Header header_;
  std::vector<std::string_view> names_, types_;
  std::vector<uint64_t> sizes_, counts_;
  int64_t width_ = -1, height_ = -1, points_ = -1;  ///< -1: not there
};

}  // namespace

Header read_header(const ByteSource& source) { return HeaderParser(source).run(); }

}  // namespace jalon::pcd
