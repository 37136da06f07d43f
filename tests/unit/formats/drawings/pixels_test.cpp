// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/drawings/pixels.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "base/random.h"

using namespace jalon;

TEST_CASE("pixels__base64_of_the_examples_of_rfc_4648") {
  CHECK(base64_of("").empty());
  CHECK(base64_of("f") == "Zg==");
  CHECK(base64_of("fo") == "Zm8=");
  CHECK(base64_of("foo") == "Zm9v");
  CHECK(base64_of("foob") == "Zm9vYg==");
  CHECK(base64_of("fooba") == "Zm9vYmE=");
  CHECK(base64_of("foobar") == "Zm9vYmFy");
  CHECK(base64_of("\xff\xef") == "/+8=");
}

TEST_CASE("pixels__base64_leads_back_to_any_bytes_and_hex_to_any_colour") {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  RandomStream random(1, 1);
  for (size_t n = 0; n < 80; ++n) {
    std::string bytes, bits, back;
    for (size_t i = 0; i < n; ++i) bytes += static_cast<char>(random.below(256));
    const std::string text = base64_of(bytes);
    REQUIRE(text.size() == (n + 2) / 3 * 4);
    const size_t padding = text.size() - std::min(text.size(), text.find('='));
    CHECK(padding == (3 - n % 3) % 3);
    for (const char c : text.substr(0, text.size() - padding)) {
      const size_t value = digits.find(c);
      REQUIRE(value < 64);
      for (int bit = 5; bit >= 0; --bit) bits += (value >> bit & 1) != 0 ? '1' : '0';
    }
    for (size_t at = 0; at + 8 <= bits.size(); at += 8)
      back += static_cast<char>(std::stoi(bits.substr(at, 8), nullptr, 2));
    CHECK(back == bytes);
  }
  for (int i = 0; i < 100; ++i) {
    const auto colour = static_cast<uint32_t>(random.below(1u << 24));
    const auto part = [&](uint32_t shift) { return static_cast<uint8_t>(colour >> shift & 255); };
    const std::string text = hex_of({part(16), part(8), part(0)});
    REQUIRE(text.size() == 7);
    CHECK(text[0] == '#');
    CHECK(std::stoul(text.substr(1), nullptr, 16) == colour);
  }
}
