// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "base/utf8_character.h"

using namespace jalon;

TEST_CASE("fail__throws_the_status_and_the_formatted_line") {
  try {
    fail(Status::kNotFound, "field \"%s\", point %d of %llu", "label", -3, 18446744073709551615ull);
    FAIL("fail came back");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kNotFound);
    CHECK(std::string(error.what()) == "field \"label\", point -3 of 18446744073709551615");
  }
}

namespace {

template <class F>
std::string text_of_failure(F&& failing) {
  try {
    failing();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

bool is_whole_utf8(std::string_view text) {
  while (!text.empty() && utf8_character_bytes(text) > 0)
    text.remove_prefix(utf8_character_bytes(text));
  return text.empty();
}

}  // namespace

TEST_CASE("fail__throws_whole_utf_8_whatever_it_is_made_of") {
  const auto told = [](const char* text) {
    return text_of_failure([&] { fail(Status::kIo, "%s", text); });
  };
  for (const char* whole : {"", "plain", "\xC3\xA9t\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80!"})
    CHECK(told(whole) == whole);
  CHECK(told("\"x\xC3\"; there are") == "\"x?\"; there are");
  CHECK(told("\xF0\x9F\x98; \xC3\xA9") == "?; \xC3\xA9");  // one for what is left of a character
  CHECK(told("caf\xE9, \xFF\xFE") == "caf?, ??");
  CHECK(told("\x80\x80z\xE2\x82") == "?z?");
  CHECK(told("\xED\xA0\x80") == "?");  // a surrogate
}

TEST_CASE("fail__cuts_names_and_long_texts_between_characters") {
  for (const std::string character : {"\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"})
    for (size_t before = 0; before < 5; ++before) {
      CAPTURE(character);
      CAPTURE(before);
      std::string name(before, 'x');
      while (name.size() < 3000) name += character;
      const std::string part = text_of_failure(
          [&] { fail(Status::kNotFound, "no \"%.100s\"; there are", name.c_str()); });
      CHECK(is_whole_utf8(part));
      CHECK(part.ends_with("\"; there are"));
      const std::string cut =
          text_of_failure([&] { fail(Status::kNotFound, "no \"%s\"", name.c_str()); });
      CHECK(is_whole_utf8(cut));
      CHECK(("no \"" + name).starts_with(cut));  // nothing else at the end
      CHECK(cut.size() <= 1023);
      CHECK(cut.size() + character.size() > 1023);
    }
}

TEST_CASE("fail__cuts_a_long_text_instead_of_overrunning") {
  const std::string name(5000, 'x');
  try {
    fail(Status::kIo, "file %s", name.c_str());
    FAIL("fail came back");
  } catch (const std::exception& error) {
    const std::string text = error.what();
    CHECK(text.size() >= 500);
    CHECK(text.size() < name.size());
    CHECK(("file " + name).starts_with(text));
  }
}
