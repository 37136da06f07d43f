// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/drawings/svg_writer.h"

#include <cmath>
#include <utility>

#include "formats/files/utf8.h"

namespace jalon {

std::string xml_escaped(std::string_view text) {
  std::string clean = valid_utf8(text);
  // U+FFFE and U+FFFF are valid UTF-8 but no XML characters.
  for (size_t at = 0; (at = clean.find("\xEF\xBF", at)) != std::string::npos; at += 3)
    if (const auto last = static_cast<unsigned char>(clean[at + 2]); last >= 0xBE)
      clean.replace(at, 3, kReplacementCharacter);
  std::string out;
  out.reserve(clean.size() + clean.size() / 8);
  for (const char c : clean) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      case '\t':
      case '\n':
      case '\r':
        out += c;
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) out += kReplacementCharacter;
        else out += c;
    }
  }
  return out;
}

std::string svg_number(double value, int decimals) {
  if (!std::isfinite(value)) return "0";
  std::string text = text_of(value, decimals);
  if (text.find('.') != std::string::npos && text.find('e') == std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

void SvgWriter::tag(std::string_view name, Attributes attributes) {
  out_ += '<';
  out_ += name;
  for (const Attribute& attribute : attributes) {
    out_ += ' ';
    out_ += attribute.name;
    out_ += "=\"";
    out_ += xml_escaped(attribute.value);
    out_ += '"';
  }
}

SvgWriter& SvgWriter::open(std::string_view name, Attributes attributes) {
  tag(name, attributes);
  out_ += ">\n";
  names_.emplace_back(name);
  return *this;
}

SvgWriter& SvgWriter::leaf(std::string_view name, Attributes attributes) {
  tag(name, attributes);
  out_ += "/>\n";
  return *this;
}

SvgWriter& SvgWriter::element(std::string_view name, Attributes attributes,
                              std::string_view content) {
  tag(name, attributes);
  out_ += '>';
  out_ += xml_escaped(content);
  out_ += "</";
  out_ += name;
  out_ += ">\n";
  return *this;
}

SvgWriter& SvgWriter::text(std::string_view content) {
  out_ += xml_escaped(content);
  return *this;
}

SvgWriter& SvgWriter::raw(std::string_view markup) {
  out_ += markup;
  return *this;
}

SvgWriter& SvgWriter::close() {
  if (names_.empty()) return *this;
  out_ += "</" + names_.back() + ">\n";
  names_.pop_back();
  return *this;
}

std::string SvgWriter::take() {
  while (!names_.empty()) close();
  return std::exchange(out_, {});
}

}  // namespace jalon
