// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ply/header.h"

#include <charconv>
#include <limits>

#include "formats/files/header_lines.h"
#include "formats/files/utf8.h"
#include "formats/text/layout.h"

namespace jalon::ply {

namespace {

constexpr size_t kMaxElements = 256, kMaxProperties = 4096;

bool parse_type(std::string_view word, ElementType& out) {
  static constexpr struct {
    const char* word;
    ElementType type;
  } kTypes[] = {{"char", ElementType::kInt8},      {"int8", ElementType::kInt8},
                {"uchar", ElementType::kUint8},    {"uint8", ElementType::kUint8},
                {"short", ElementType::kInt16},    {"int16", ElementType::kInt16},
                {"ushort", ElementType::kUint16},  {"uint16", ElementType::kUint16},
                {"int", ElementType::kInt32},      {"int32", ElementType::kInt32},
                {"uint", ElementType::kUint32},    {"uint32", ElementType::kUint32},
                {"int64", ElementType::kInt64},    {"uint64", ElementType::kUint64},
                {"float", ElementType::kFloat32},  {"float32", ElementType::kFloat32},
                {"double", ElementType::kFloat64}, {"float64", ElementType::kFloat64}};
  for (const auto& row : kTypes)
    if (word == row.word) {
      out = row.type;
      return true;
    }
  return false;
}

class Parser {
 public:
  explicit Parser(const ByteSource& source) : source_(source), lines_(source) {}

  Header run() {
    bool has_format = false;
    std::string_view line;
    if (!lines_.next(line) || line != "ply")
      source_.refuse(0, "a PLY file starts with a line \"ply\"");
    for (;;) {
      const size_t at = lines_.at();
      if (!lines_.next(line)) source_.refuse(at, "the header has no end_header");
      const auto words = cells_of(line, ' ');
      if (words.empty()) continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format") has_format = parse_format(words, at);
      if (words[0] == "comment" || words[0] == "obj_info") note_comment(line);
      if (words[0] == "element") add_element(words, at);
      if (words[0] == "property") add_property(words, at);
    }
    if (!has_format) source_.refuse(0, "the header names no format");
    header_.data_offset = lines_.at();
    require_room();
    return std::move(header_);
  }

 private:
  bool parse_format(const std::vector<std::string_view>& words, size_t at) {
    const std::string_view name = words.size() > 1 ? words[1] : "";
    if (name == "ascii") header_.encoding = Encoding::kAscii;
    else if (name == "binary_little_endian") header_.encoding = Encoding::kLittle;
    else if (name == "binary_big_endian") header_.encoding = Encoding::kBig;
    else source_.refuse(at, "the format is none of ascii, binary_little_endian, binary_big_endian");
    return true;
  }

  void note_comment(std::string_view line) {
    if (line.find("CloudCompare") != std::string_view::npos) header_.by_cloudcompare = true;
    constexpr std::string_view kStations = "comment stations ";
    if (line.starts_with(kStations)) header_.stations.emplace_back(line.substr(kStations.size()));
    if (line.starts_with("comment crs ")) header_.crs = valid_utf8(line.substr(12));
  }

  void add_element(const std::vector<std::string_view>& words, size_t at) {
    Element element;
    if (words.size() != 3) source_.refuse(at, "an element needs a name and a count");
    const auto [end, error] =
        std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
    if (error != std::errc() || end != words[2].data() + words[2].size())
      source_.refuse(at, "the element's count is no number");
    element.name = valid_utf8(words[1]);
    if (header_.elements.size() == kMaxElements)
      source_.refuse(at, "more than %zu elements", kMaxElements);
    header_.elements.push_back(std::move(element));
  }

  void add_property(const std::vector<std::string_view>& words, size_t at) {
    if (header_.elements.empty()) source_.refuse(at, "a property before the first element");
    auto& properties = header_.elements.back().properties;
    Property property;
    property.list = words.size() > 1 && words[1] == "list";
    const size_t type = property.list ? 3 : 1;
    if (words.size() != type + 2) source_.refuse(at, "a property needs a type and a name");
    const bool known = parse_type(words[type], property.type) &&
                       (!property.list || parse_type(words[2], property.count_type));
    if (!known) source_.refuse(at, "the property's type is unknown");
    if (property.list && is_floating(property.count_type))
      source_.refuse(at, "the length of a list must be a whole number");
    if (properties.size() == kMaxProperties)
      source_.refuse(at, "more than %zu properties", kMaxProperties);
    property.name = name_from_file(words[type + 1], numbered("property", properties.size() + 1));
    properties.push_back(std::move(property));
  }

  void require_room() const {
    uint64_t room = source_.size() - header_.data_offset;
    if (header_.encoding == Encoding::kAscii) ++room;  // the last line may lack its line feed
    for (const Element& element : header_.elements) {
      const uint64_t bytes = element.least_bytes(header_.encoding);
      if (bytes == 0) continue;
      if (element.count > room / bytes)
        source_.refuse(header_.data_offset,
                       "the header promises %llu of element \"%.60s\", the file has room for %llu",
                       static_cast<unsigned long long>(element.count), element.name.c_str(),
                       static_cast<unsigned long long>(room / bytes));
      room -= element.count * bytes;
    }
  }

  const ByteSource& source_;
  HeaderLines lines_;
  Header header_;
};

}  // namespace

bool Element::has_list() const {
  for (const Property& property : properties)
    if (property.list) return true;
  return false;
}

uint64_t Element::least_bytes(Encoding encoding) const {
  constexpr uint64_t kAsciiBytes = 2;  // a digit and what parts it from the next
  uint64_t bytes = 0;
  for (const Property& property : properties)
    bytes += encoding == Encoding::kAscii
                 ? kAsciiBytes
                 : size_of(property.list ? property.count_type : property.type);
  return bytes;
}

Header read_header(const ByteSource& source) { return Parser(source).run(); }

}  // namespace jalon::ply
