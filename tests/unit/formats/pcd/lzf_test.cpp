// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/pcd/lzf.h"

#include <doctest/doctest.h>

#include <string>

using namespace jalon::pcd;

namespace {

std::span<const std::byte> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

// "" where it is refused.
std::string unpacked_text(const std::string& packed, size_t bytes) {
  std::string out(bytes, '?');
  return unpack_lzf(bytes_of(packed), {reinterpret_cast<std::byte*>(out.data()), bytes}) ? out : "";
}

}  // namespace

TEST_CASE("lzf__literals_and_matches_give_the_text_back") {
  // "abc" as it is; 6 bytes from 3 back (length 4 + 2); 300 bytes from 1 back (7 + 255 + 2 = 264,
  // then 7 + 27 + 2 = 36).
  const std::string packed = std::string("\x02") + "abc" + std::string("\x80\x02", 2) +
                             std::string("\xE0\xFF\x00", 3) + std::string("\xE0\x1B\x00", 3);
  CHECK(unpacked_lzf_bytes(bytes_of(packed)) == 309);
  CHECK(unpacked_text(packed, 309) == "abcabcabc" + std::string(300, 'c'));
  CHECK(unpacked_text("", 0).empty());
}

TEST_CASE("lzf__damaged_bytes_are_refused") {
  const std::string packed = std::string("\x02") + "abc" + std::string("\xE0\x01\x02", 3);
  const size_t whole = unpacked_lzf_bytes(bytes_of(packed));
  CHECK(whole == 13);
  CHECK_FALSE(unpacked_text(packed, whole).empty());
  CHECK(unpacked_text(packed, whole - 1).empty());
  CHECK(unpacked_text(packed, whole + 1).empty());
  CHECK(unpacked_text(std::string("\x20\x00", 2), 3).empty());  // looks back beyond the beginning
  for (const size_t cut : {1u, 2u, 3u, 5u, 6u})
    CHECK(unpacked_lzf_bytes(bytes_of(packed.substr(0, cut))) == ~uint64_t{0});
}
