// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text_number.h"

/// A small reader of markup, written apart from the writer it checks.
namespace markup {

struct Tag {
  std::string name;  ///< with '/' in front for an end tag
  bool is_empty = false;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text_after;  ///< up to the next tag
  std::string attribute(std::string_view wanted) const {
    for (const auto& [key, value] : attributes)
      if (key == wanted) return value;
    return {};
  }
};

/// All tags; a tag that is not well-formed ends the list with the name "broken".
inline std::vector<Tag> tags(std::string_view s) {
  std::vector<Tag> out;
  size_t i = 0;
  const auto space = [&] {
    while (i < s.size() && std::isspace(static_cast<unsigned char>(s[i]))) ++i;
  };
  const auto is_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == ':';
  };
  const auto broken = [&] {
    Tag tag;
    tag.name = "broken";
    out.push_back(tag);
    return out;
  };
  while (i < s.size()) {
    if (s[i] != '<') {
      if (s[i] == '>') return broken();
      if (!out.empty()) out.back().text_after += s[i];
      ++i;
      continue;
    }
    if (s.substr(i, 15) == "<!DOCTYPE html>" && i == 0) {
      i += 15;
      continue;
    }
    Tag tag;
    ++i;
    if (i < s.size() && s[i] == '/') tag.name += s[i++];
    while (i < s.size() && is_name(s[i])) tag.name += s[i++];
    if (tag.name.empty() || tag.name == "/") return broken();
    for (;;) {
      space();
      if (i >= s.size()) return broken();
      if (s[i] == '/') {
        tag.is_empty = true;
        ++i;
        continue;
      }
      if (s[i] == '>') {
        ++i;
        break;
      }
      std::string key, value;
      while (i < s.size() && is_name(s[i])) key += s[i++];
      if (key.empty() || s.substr(i, 2) != "=\"") return broken();
      for (i += 2; i < s.size() && s[i] != '"'; ++i) {
        if (s[i] == '<') return broken();
        value += s[i];
      }
      ++i;
      tag.attributes.emplace_back(key, value);
    }
    out.push_back(tag);
    if (tag.name == "script") {  // raw up to its end, as in HTML
      const size_t end = std::min(s.find("</script>", i), s.size());
      out.back().text_after = s.substr(i, end - i);
      i = end;
    }
  }
  return out;
}

inline bool well_formed(std::string_view s) {
  std::vector<std::string> open;
  for (const Tag& tag : tags(s)) {
    if (tag.name == "broken") return false;
    for (size_t i = 0; i < tag.text_after.size() && tag.name != "script"; ++i) {
      if (tag.text_after[i] != '&') continue;
      const size_t end = tag.text_after.find(';', i);
      if (end == std::string::npos || end - i > 8) return false;
    }
    if (tag.is_empty) continue;
    if (tag.name[0] != '/') {
      open.push_back(tag.name);
    } else {
      if (open.empty() || "/" + open.back() != tag.name) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

/// Names of tags and attributes in their order: what a hostile text must not change.
inline std::vector<std::string> shape(std::string_view s) {
  std::vector<std::string> out;
  for (const Tag& tag : tags(s)) {
    out.push_back(tag.name);
    for (const auto& [key, value] : tag.attributes) out.push_back(key);
  }
  return out;
}

inline bool has_only_xml_characters(std::string_view s) {
  for (size_t i = 0; i < s.size(); ++i) {
    const auto c = static_cast<unsigned char>(s[i]);
    if (c < 0x20 && c != '\n' && c != '\t' && c != '\r') return false;
    if (c == 0xEF && s.substr(i, 2) == "\xEF\xBF" && i + 2 < s.size() &&
        static_cast<unsigned char>(s[i + 2]) >= 0xBE)
      return false;
  }
  return true;
}

inline double number(std::string_view s) {
  double value = 0;
  jalon::parse_number(s, value);
  return value;
}

/// The x of each corner of a path "M1 2L3 4Z...".
inline std::vector<double> path_x(const std::string& d) {
  std::vector<double> out;
  for (size_t i = 0; i < d.size(); ++i)
    if (d[i] == 'M' || d[i] == 'L')
      out.push_back(number(std::string_view(d).substr(i + 1, d.find(' ', i) - i - 1)));
  return out;
}

struct TextBox {
  std::string text;
  double left, top, right, bottom;
  bool meets(const TextBox& b) const {
    return left < b.right && b.left < right && top < b.bottom && b.top < bottom;
  }
};

/// Boxes of the texts, with letters 0.55 of the font size wide and 0.7 high.
inline std::vector<TextBox> text_boxes(std::string_view svg) {
  std::vector<TextBox> out;
  for (const Tag& tag : tags(svg)) {
    if (tag.name != "text") continue;
    const double x = number(tag.attribute("x")), y = number(tag.attribute("y")),
                 size = number(tag.attribute("font-size"));
    const double width = 0.55 * size * static_cast<double>(tag.text_after.size());
    const std::string anchor = tag.attribute("text-anchor");
    const double left = anchor == "middle" ? -width / 2 : anchor == "end" ? -width : 0;
    TextBox box{tag.text_after, x + left, y - 0.7 * size, x + left + width, y};
    if (tag.attribute("transform").rfind("rotate(-90", 0) == 0)
      box = {tag.text_after, x - 0.7 * size, y - left - width, x, y - left};
    out.push_back(box);
  }
  return out;
}

}  // namespace markup
