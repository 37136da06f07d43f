// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/utf8_character.h"

#include <doctest/doctest.h>

using namespace jalon;

TEST_CASE("utf8_character__every_code_becomes_one_character_and_comes_back") {
  for (uint32_t code = 0; code <= 0x10FFFF; ++code) {
    std::string text;
    append_utf8(text, code);
    const bool is_surrogate = code >= 0xD800 && code < 0xE000;
    REQUIRE(utf8_character_bytes(text) == (is_surrogate ? 0 : text.size()));
    if (!is_surrogate) REQUIRE(utf8_code(text) == code);
  }
}
