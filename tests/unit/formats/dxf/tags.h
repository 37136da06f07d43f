// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "base/text_number.h"

namespace jalon::test {

/// A group of a DXF text; its number is NaN where the value is none.
struct Tag {
  int code = -1;
  std::string value = {};
  double number() const {
    double out = 0;
    return parse_number(value, out) ? out : kNaN;
  }
};

/// An object, entity or table entry: its tags from one 0 to the next.
struct TagItem {
  std::vector<Tag> tags = {};
  const std::string& kind() const { return tags.at(0).value; }
  /// Values of all tags of this code.
  std::vector<std::string> all(int code) const {
    std::vector<std::string> out;
    for (const Tag& tag : tags)
      if (tag.code == code) out.push_back(tag.value);
    return out;
  }
  /// Of the first tag of this code; "" without one.
  std::string text(int code) const {
    const std::vector<std::string> values = all(code);
    return values.empty() ? "" : values[0];
  }
  double number(int code) const { return Tag{code, text(code)}.number(); }
};

inline std::vector<TagItem> tag_items(const std::string& dxf) {
  std::vector<TagItem> out;
  std::istringstream lines(dxf);
  bool whole = true;  // codes are right-aligned, each has its value, the first is 0
  for (std::string code, value; whole && std::getline(lines, code);) {
    whole = std::getline(lines, value).good() && code.size() >= 3;
    const int number = whole ? std::stoi(code) : 0;
    if (number == 0) out.emplace_back();
    whole = whole && !out.empty();
    if (whole) out.back().tags.push_back({number, value});
  }
  REQUIRE(whole);
  return out;
}

}  // namespace jalon::test
