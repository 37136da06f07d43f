// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json_writer.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "base/json_reader.h"

using namespace jalon;

namespace {

std::string rewritten(const std::string& text, int indent = -1) {
  return JsonWriter(indent).value(read_json(text)[0]).take();
}

}  // namespace

TEST_CASE("JsonWriter: numbers read back the same and are finite") {
  for (const double number :
       {0.1, 1.0 / 3, -0.0, 1.0, 1e300, 5e-324, 652000.123, 9007199254740993.0, 1e5}) {
    CAPTURE(number);
    const auto read = read_json(JsonWriter().value(number).take());
    CHECK(read[0].kind == JsonValue::Kind::kNumber);
    CHECK(read[0].number == number);
    CHECK(std::signbit(read[0].number) == std::signbit(number));
  }
  CHECK(JsonWriter().value(INT64_MIN).take() == "-9223372036854775808");
  CHECK(JsonWriter().value(UINT64_MAX).take() == "18446744073709551615");
  CHECK(JsonWriter().value(std::numeric_limits<double>::infinity()).take() == "null");
  CHECK(JsonWriter().value(std::nan("")).take() == "null");
}

TEST_CASE("JsonWriter: any bytes become one valid text; valid UTF-8 comes back as it was") {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  const std::string text = read_json(JsonWriter().value(all).take())[0].text;
  CHECK(text.substr(0, 128) == all.substr(0, 128));
  CHECK(text.size() == 128 + 128 * 3);  // each lone byte above 0x7F is U+FFFD
  for (const std::string good : {"Fa\xC3\xA7"
                                 "ade \"A\"\\ \n",
                                 "\xF0\x9F\x98\x80", ""})
    CHECK(read_json(JsonWriter().value(good).take())[0].text == good);
}

TEST_CASE("JsonWriter: layout of objects and arrays, on one line and indented") {
  const std::string compact = R"({"a":[1,{"b":null},"x"],"c":{},"d":[],"e":true})";
  CHECK(rewritten(compact) == compact);
  CHECK(rewritten(R"({"a": [1, 2.50], "c": {}})", 1) ==
        "{\n \"a\": [\n  1,\n  2.50\n ],\n \"c\": {}\n}");
  CHECK(rewritten("[]", 2) == "[]");
  CHECK(rewritten("[[]]", 2) == "[\n  []\n]");
}
