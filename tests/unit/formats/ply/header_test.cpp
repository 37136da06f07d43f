// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// PLY headers: all words of the types, where the data begin, and counts that the file has no room for.
#include <doctest/doctest.h>

#include <string>

#include "formats/ply/header.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const std::string kBinaryHead = "ply\nformat binary_little_endian 1.0\n";

ply::Header header_of(const std::string& bytes) {
  const OpenedFile file(bytes, "a.ply");
  return ply::read_header(file);
}

std::string refused_header(const std::string& bytes) {
  const Failure failure = failure_of([&] { header_of(bytes); });
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

bool has_room(const std::string& header, size_t data_bytes) {
  return failure_of([&] { header_of(header + std::string(data_bytes, ' ')); }).text.empty();
}

}  // namespace

TEST_CASE("ply_header__both_words_of_every_type_are_known_and_their_bytes_add_up") {
  constexpr struct {
    const char *word, *other;
    ElementType type;
    size_t bytes;
  } kRows[] = {{"char", "int8", ElementType::kInt8, 1},
               {"uchar", "uint8", ElementType::kUint8, 1},
               {"short", "int16", ElementType::kInt16, 2},
               {"ushort", "uint16", ElementType::kUint16, 2},
               {"int", "int32", ElementType::kInt32, 4},
               {"uint", "uint32", ElementType::kUint32, 4},
               {"float", "float32", ElementType::kFloat32, 4},
               {"double", "float64", ElementType::kFloat64, 8}};
  std::string text = kBinaryHead + "element vertex 0\n";
  size_t bytes = 0;
  for (const auto& row : kRows) {
    text += std::string("property ") + row.word + " a\nproperty " + row.other + " b\n";
    bytes += 2 * row.bytes;
  }
  text += "property list ushort double l\nend_header\n";
  const ply::Header header = header_of(text);
  REQUIRE(header.elements.size() == 1);
  const ply::Element& element = header.elements[0];
  REQUIRE(element.properties.size() == 17);
  for (size_t i = 0; i < 16; ++i) CHECK(element.properties[i].type == kRows[i / 2].type);
  CHECK(element.properties[16].list);
  CHECK(element.properties[16].count_type == ElementType::kUint16);
  CHECK(element.properties[16].type == ElementType::kFloat64);
  CHECK(element.has_list());
  CHECK(element.least_bytes(ply::Encoding::kLittle) == bytes + 2);  // of a list its length
  CHECK(element.least_bytes(ply::Encoding::kBig) == bytes + 2);
  CHECK(element.least_bytes(ply::Encoding::kAscii) == 2 * 17);  // a digit and what parts it
}

TEST_CASE("ply_header__data_begin_behind_the_end_line_and_comments_tell_the_crs_and_the_maker") {
  for (const std::string end : {"\n", "\r\n"}) {
    CAPTURE(end);
    const std::string text = "ply" + end + "format binary_big_endian 1.0" + end +
                             "comment crs EPSG:2154" + end + "obj_info Created by CloudCompare" +
                             end + end + "element vertex 2" + end + "property  uchar   x" + end +
                             "element other 0" + end + "end_header" + end;
    const ply::Header header = header_of(text + "\n\n");
    CHECK(header.encoding == ply::Encoding::kBig);
    CHECK(header.data_offset == text.size());
    CHECK(header.crs == "EPSG:2154");
    CHECK(header.by_cloudcompare);
    REQUIRE(header.elements.size() == 2);
    CHECK(header.elements[0].count == 2);
    CHECK(header.elements[0].properties[0].name == "x");
    CHECK(header.elements[1].properties.empty());
  }
  CHECK_FALSE(
      header_of("ply\nformat ascii 1.0\ncomment made by hand\nend_header\n").by_cloudcompare);
}

TEST_CASE("ply_header__counts_are_taken_up_to_the_last_byte_of_the_file") {
  const std::string two = kBinaryHead +
                          "element a 3\nproperty int x\nelement b 5\nproperty short y\n"
                          "property list uchar int l\nend_header\n";
  CHECK(has_room(two, 3 * 4 + 5 * 3));
  CHECK_FALSE(has_room(two, 3 * 4 + 5 * 3 - 1));
  const std::string text = "ply\nformat ascii 1.0\nelement a 4\nproperty int x\nend_header\n";
  CHECK(has_room(text, 7));  // "1 2 3 4" without an end of line
  CHECK_FALSE(has_room(text, 6));
  CHECK(has_room(kBinaryHead + "element a 99999999\nend_header\n", 0));  // items of no bytes
  const std::string promise = refused_header(two + std::string(12 + 6, ' '));
  CHECK(has_text(promise, "offset " + std::to_string(two.size()) + ": the header promises 5 of "));
  CHECK(has_text(promise, "element \"b\", the file has room for 2"));
}

TEST_CASE("ply_header__what_is_no_header_is_refused_where_it_goes_wrong") {
  const auto at_the_end = [](const std::string& before, const std::string& line) {
    const std::string message = refused_header(before + line + "\nend_header\n");
    CHECK_MESSAGE(has_text(message, ": offset " + std::to_string(before.size()) + ": "), message);
    return message;
  };
  const std::string vertex = kBinaryHead + "element vertex 1\n";
  CHECK(has_text(refused_header("plyx\n"), "starts with a line \"ply\""));
  CHECK(has_text(refused_header("ply\nend_header\n"), "names no format"));
  CHECK(has_text(refused_header(vertex), "no end_header"));
  CHECK(has_text(at_the_end("ply\n", "format binary 1.0"), "none of ascii"));
  CHECK(has_text(at_the_end(kBinaryHead, "property int x"), "before the first element"));
  CHECK(has_text(at_the_end(kBinaryHead, "element vertex"), "a name and a count"));
  CHECK(has_text(at_the_end(kBinaryHead, "element vertex -1"), "count is no number"));
  CHECK(has_text(at_the_end(kBinaryHead, "element vertex 18446744073709551616"), "no number"));
  CHECK(has_text(at_the_end(vertex, "property half x"), "type is unknown"));
  CHECK(has_text(at_the_end(vertex, "property int"), "a type and a name"));
  CHECK(has_text(at_the_end(vertex, "property list int x"), "a type and a name"));
  CHECK(has_text(at_the_end(vertex, "property list float int x"), "must be a whole number"));
}
