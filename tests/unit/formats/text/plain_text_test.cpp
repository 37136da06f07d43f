// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Plain text is told from binary files by its first 4096 bytes: against every byte there is.
#include <doctest/doctest.h>

#include <string>

#include "formats/text/text.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

bool is_text(const std::string& bytes) {
  const OpenedFile file(bytes);
  return is_plain_text(file);
}

}  // namespace

TEST_CASE("plain_text__of_all_bytes_the_control_characters_but_those_that_part_words_are_none") {
  const std::string blanks = "\t\n\f\r";
  std::string allowed;
  for (int c = 0; c < 256; ++c) {
    CAPTURE(c);
    const auto byte = static_cast<char>(c);
    if (c >= 0x20 || blanks.find(byte) != std::string::npos) allowed += byte;
    else CHECK_FALSE(is_text(std::string("1 2 3") + byte + "4\n"));
  }
  CHECK(allowed.size() == 256 - 32 + 4);
  CHECK(is_text(allowed));
  CHECK_FALSE(is_text(""));
}

TEST_CASE("plain_text__only_the_first_4096_bytes_are_looked_at") {
  std::string text(5000, '7');
  text[4096] = '\0';
  CHECK(is_text(text));
  text[4095] = '\0';
  CHECK_FALSE(is_text(text));
}
