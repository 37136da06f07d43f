// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <string>

#include "formats/files/endian.h"
#include "unit/formats/files/inflated.h"

namespace jalon::test {

/// The entries of the only directory, and the strips inflated.
class Tiff {
 public:
  explicit Tiff(const std::string& bytes) : bytes_(bytes) {
    CHECK(bytes.substr(0, 4) == std::string("II\x2a\0", 4));
    const size_t directory = at<uint32_t>(4);
    const size_t count = at<uint16_t>(directory);
    uint16_t last = 0;
    for (size_t i = 0; i < count; ++i) {
      const size_t entry = directory + 2 + 12 * i;
      CHECK(at<uint16_t>(entry) > last);  // ascending, as readers want them
      last = at<uint16_t>(entry);
      const size_t size = std::map<int, size_t>{{2, 1}, {3, 2}, {4, 4}, {5, 8}, {12, 8}}.at(
          at<uint16_t>(entry + 2));
      const size_t length = size * at<uint32_t>(entry + 4);
      entries_[last] = bytes.substr(length > 4 ? at<uint32_t>(entry + 8) : entry + 8, length);
    }
    CHECK(at<uint32_t>(directory + 2 + 12 * count) == 0);
  }
  template <class T>
  T value(uint16_t tag, size_t i = 0) const {
    return load<T>(entries_.at(tag).data() + i * sizeof(T));
  }
  std::string text(uint16_t tag) const { return entries_.at(tag); }
  bool has(uint16_t tag) const { return entries_.contains(tag); }
  std::string pixels() const {
    std::string out;
    for (size_t s = 0; s < entries_.at(273).size() / 4; ++s) {
      const Inflated strip(
          std::string_view(bytes_).substr(value<uint32_t>(273, s), value<uint32_t>(279, s)));
      CHECK(strip.ok);
      out += strip.text;
    }
    return out;
  }

 private:
  template <class T>
  T at(size_t offset) const {
    REQUIRE(offset + sizeof(T) <= bytes_.size());
    return load<T>(bytes_.data() + offset);
  }
  std::string bytes_;
  std::map<uint16_t, std::string> entries_;
};

}  // namespace jalon::test
