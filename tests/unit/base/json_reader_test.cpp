// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json_reader.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/error.h"

using namespace jalon;

namespace {

using Kind = JsonValue::Kind;

bool refused(const std::string& text) {
  try {
    read_json(text);
  } catch (const Error& error) {
    return error.status() == Status::kInvalidArgument;
  }
  return false;
}

}  // namespace

TEST_CASE("read_json: a tree lies flat in the order of the text, each value knowing its extent") {
  const auto values = read_json(R"( {"a": [1, {"b": null}, "x"], "c": -2.5e1, "d": true} )");
  REQUIRE(values.size() == 8);
  CHECK(values[0].extent == 8);
  std::string names;
  for (const JsonValue& member : JsonChildren(values[0])) names += member.name;
  CHECK(names == "acd");
  const JsonValue& a = *find_member(values[0], "a");
  CHECK(a.extent == 5);
  size_t elements = 0;
  for (const JsonValue& element : JsonChildren(a)) elements += element.kind != Kind::kArray;
  CHECK(elements == 3);
  CHECK(find_member(values[0], "c")->number == -25);
  CHECK(find_member(values[0], "d")->flag);
  CHECK(find_member(values[0], "b") == nullptr);
}

TEST_CASE("read_json: whole numbers keep 64 bits, others and larger ones are doubles") {
  const auto v = read_json(
      "[9223372036854775807, -9223372036854775808, 9223372036854775808, 1.0, 1e3, -0, 0.1]");
  CHECK(v[1].integer == INT64_MAX);
  CHECK(v[2].integer == INT64_MIN);
  CHECK(v[3].kind == Kind::kNumber);
  CHECK(v[3].number == 0x1p63);
  CHECK(v[4].kind == Kind::kNumber);
  CHECK(v[5].kind == Kind::kNumber);
  CHECK(std::signbit(v[6].number));
  CHECK(v[7].number == 0.1);
}

TEST_CASE("read_json: escapes and surrogate pairs become UTF-8") {
  const auto v = read_json(R"(["\"\\\/\b\f\n\r\t", "\u0041\u00e9\u20AC\uD83D\ude00", ""])");
  CHECK(v[1].text == "\"\\/\b\f\n\r\t");
  CHECK(v[2].text == "A\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
  CHECK(v[3].text.empty());
  CHECK(read_json("\xEF\xBB\xBF[]").size() == 1);
  CHECK(read_json(R"("\u0000")")[0].text == std::string(1, '\0'));
}

TEST_CASE("read_json: what RFC 8259 does not allow is refused") {
  for (const char* text : {"",
                           " ",
                           "{",
                           "}",
                           "[",
                           "[1",
                           "[1,",
                           "[1,]",
                           "[,1]",
                           "{\"a\"}",
                           "{\"a\":}",
                           "{\"a\":1,}",
                           "{a:1}",
                           "{1:1}",
                           "{'a':1}",
                           "01",
                           "-",
                           "+1",
                           ".5",
                           "1.",
                           "1e",
                           "1e+",
                           "0x1",
                           "NaN",
                           "Infinity",
                           "-Infinity",
                           "nul",
                           "nullx",
                           "truefalse",
                           "TRUE",
                           "1 2",
                           "[] []",
                           "\"",
                           "\"a",
                           "\"\\\"",
                           "\"\\x\"",
                           "\"\\u12\"",
                           "\"\\u12G4\"",
                           "\"\\ud800\"",
                           "\"\\ud800\\u0041\"",
                           "\"\\udc00\"",
                           "\"\n\"",
                           "\"\t\"",
                           "\"\xff\"",
                           "\"\xc0\xaf\"",
                           "\"\xed\xa0\x80\"",
                           "\"\xf4\x90\x80\x80\"",
                           "\"\xe2\x82\"",
                           "// x\n1",
                           "1e999",
                           "-1e999",
                           "[1]]"}) {
    CAPTURE(text);
    CHECK(refused(text));
  }
  CHECK(refused(std::string("[1]\0", 4)));
  CHECK(refused(std::string("\"\0\"", 3)));
}

TEST_CASE("read_json: 64 levels are read, more and endless nesting are refused") {
  CHECK(read_json(std::string(64, '[') + std::string(64, ']')).size() == 64);
  CHECK(read_json(std::string(64, '[') + "1" + std::string(64, ']')).size() == 65);
  CHECK(refused(std::string(66, '[') + std::string(66, ']')));
  CHECK(refused(std::string(1000000, '[')));
  CHECK(refused(std::string((16 << 20) + 1, ' ')));
}
