// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json_writer.h"

#include <cmath>

#include "base/text_number.h"
#include "base/utf8_character.h"

namespace jalon {

void JsonWriter::new_line() {
  if (indent_ < 0) return;
  out_ += '\n';
  out_.append(static_cast<size_t>(indent_) * static_cast<size_t>(depth_), ' ');
}

void JsonWriter::separate() {
  if (after_name_) {
    after_name_ = false;
    return;
  }
  if (depth_ == 0) return;
  if (!empty_) out_ += ',';
  empty_ = false;
  new_line();
}

JsonWriter& JsonWriter::begin(char bracket) {
  separate();
  out_ += bracket;
  ++depth_;
  empty_ = true;
  return *this;
}

JsonWriter& JsonWriter::end(char bracket) {
  --depth_;
  if (!empty_) new_line();
  out_ += bracket;
  empty_ = false;
  return *this;
}

JsonWriter& JsonWriter::name(std::string_view name) {
  separate();
  quoted(name);
  out_ += indent_ < 0 ? ":" : ": ";
  after_name_ = true;
  return *this;
}

JsonWriter& JsonWriter::literal(std::string_view text) {
  separate();
  out_ += text;
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  separate();
  quoted(text);
  return *this;
}

JsonWriter& JsonWriter::value(double number) {
  if (!std::isfinite(number)) return literal("null");
  std::string text = text_of(number);
  if (text.find_first_of(".e") == std::string::npos)
    text += ".0";  // stays a double where it is read, -0.0 too
  return literal(text);
}

JsonWriter& JsonWriter::value(const JsonValue& read) {
  using Kind = JsonValue::Kind;
  switch (read.kind) {
    case Kind::kNull:
      return literal("null");
    case Kind::kBool:
      return value(read.flag);
    case Kind::kInteger:
    case Kind::kNumber:
      return literal(read.text);
    case Kind::kText:
      return value(read.text);
    case Kind::kArray:
      begin_array();
      for (const JsonValue& child : JsonChildren(read)) value(child);
      return end_array();
    case Kind::kObject:
      break;
  }
  begin_object();
  for (const JsonValue& child : JsonChildren(read)) name(child.name).value(child);
  return end_object();
}

void JsonWriter::quoted(std::string_view text) {
  constexpr std::string_view kSpecial = "\"\\\b\f\n\r\t", kLetters = "\"\\bfnrt";
  constexpr const char* kHex = "0123456789abcdef";
  out_ += '"';
  while (!text.empty()) {
    const size_t bytes = utf8_character_bytes(text);
    const auto c = static_cast<unsigned char>(text.front());
    if (const size_t i = kSpecial.find(text.front()); i != std::string_view::npos) {
      (out_ += '\\') += kLetters[i];
    } else if (c < 0x20) {
      ((out_ += "\\u00") += kHex[c >> 4]) += kHex[c & 15];
    } else if (bytes == 0) {
      out_ += "\xEF\xBF\xBD";
    } else {
      out_ += text.substr(0, bytes);
    }
    text.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  out_ += '"';
}

}  // namespace jalon
