// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Texts from files against characters that are encoded here by the table of RFC 3629.
#include "formats/files/utf8.h"

#include <doctest/doctest.h>

#include <set>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

std::string encoded(uint32_t code) {
  const auto tail = [&](uint32_t shift) { return static_cast<char>(0x80 + (code >> shift) % 64); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0 + code / 64), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0 + code / 4096), tail(6), tail(0)};
  return {static_cast<char>(0xF0 + code / 262144), tail(12), tail(6), tail(0)};
}

/// A character of 1 to 4 bytes, each as likely; no NUL, no surrogate.
std::string random_character(RandomStream& random) {
  constexpr uint32_t kFirst[] = {1, 0x80, 0x800, 0x10000, 0x110000};
  const uint64_t bytes = random.below(4);
  const auto code =
      static_cast<uint32_t>(kFirst[bytes] + random.below(kFirst[bytes + 1] - kFirst[bytes]));
  return encoded(code >= 0xD800 && code < 0xE000 ? code - 0x1000 : code);
}

std::string times(size_t n, std::string_view piece) {
  std::string out;
  for (; n > 0; --n) out += piece;
  return out;
}

}  // namespace

TEST_CASE("utf8__valid_text_stays_and_each_byte_that_is_none_becomes_one_replacement") {
  RandomStream random(1, 1);
  for (int round = 0; round < 200; ++round) {
    std::string given, wanted;
    for (int i = 0; i < 20; ++i) {
      const std::string next = random_character(random);
      given += next;
      wanted += next;
      if (random.below(3) != 0) continue;
      given += static_cast<char>(0xF8 + random.below(8));  // never part of a character
      wanted += kReplacementCharacter;
    }
    CHECK(valid_utf8(given) == wanted);
    CHECK(valid_utf8(wanted) == wanted);
  }
  const std::pair<std::string, size_t> kBroken[] = {
      {"\xC0\x80", 2},          // overlong
      {"\xE0\x9F\xBF", 3},      // overlong
      {"\xED\xA0\x80", 3},      // a surrogate
      {"\xF4\x90\x80\x80", 4},  // beyond U+10FFFF
      {"\xE2\x82", 2},          // cut off
      {"\x80", 1},              // a tail alone
      {std::string(1, '\0'), 1},
  };
  for (const auto& [bytes, count] : kBroken)
    CHECK(valid_utf8("a" + bytes + "b") == "a" + times(count, kReplacementCharacter) + "b");
}

TEST_CASE("utf8__a_prefix_ends_with_the_last_character_that_fits") {
  RandomStream random(2, 1);
  for (int round = 0; round < 50; ++round) {
    std::string text;
    std::vector<size_t> ends{0};
    for (int i = 0; i < 10; ++i) {
      text += random_character(random);
      ends.push_back(text.size());
    }
    for (size_t bytes = 0; bytes <= text.size() + 2; ++bytes) {
      size_t longest = 0;
      for (const size_t end : ends)
        if (end <= bytes) longest = end;
      CHECK(utf8_prefix(text, bytes) == std::string_view(text).substr(0, longest));
    }
  }
}

TEST_CASE("utf8__names_of_files_are_one_clean_line_or_the_fallback") {
  const auto field = [](const std::string& bytes) {
    return text_field(bytes.data(), bytes.size());
  };
  CHECK(field(std::string("ab\0cd", 5)) == "ab");
  CHECK(field(" a\tb\x7f\x01 c \t\r\n") == " a b   c");
  CHECK(field("caf\xC3\xA9\xC3") == "caf\xC3\xA9\xEF\xBF\xBD");
  CHECK(field("").empty());
  CHECK(name_from_file("  x y  ", "f") == "x y");
  for (const std::string& none : {std::string(), std::string(" \t "), std::string("\0abc", 4)})
    CHECK(name_from_file(none, "fallback") == "fallback");
  // 256 bytes at most, whole characters: 85 of three bytes are 255.
  CHECK(name_from_file(times(300, "\xE2\x82\xAC"), "f") == times(85, "\xE2\x82\xAC"));
  CHECK(name_from_file(std::string(300, 'x'), "f") == std::string(256, 'x'));
  CHECK(lower("AZ az \xC3\x89 09@[") == "az az \xC3\x89 09@[");  // ASCII alone
}

TEST_CASE("utf8__unique_names_never_repeat_and_keep_the_first_of_each") {
  RandomStream random(3, 1);
  UniqueNames unique;
  std::set<std::string> given;
  const char* kNames[] = {"a", "a_2", "a_2_2", "a_3", "", "_2"};
  for (int i = 0; i < 2000; ++i) {
    const std::string name = kNames[random.below(6)], got = unique.add(name);
    const bool is_free = !given.contains(name);
    CHECK((got == name) == is_free);
    CHECK(got.starts_with(name));
    CHECK(given.insert(got).second);
  }
  CHECK(numbered("wall", 12) == "wall_12");
}
