// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/text.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/text_number.h"
#include "base/utf8_character.h"
#include "formats/files/utf8.h"

namespace jalon::dxf {

namespace {

constexpr size_t kMaxTextBytes = 255;  // of a string group in release 12 and 2000
constexpr const char* kHex = "0123456789ABCDEF";

// The file is ASCII: R2000 writes other characters of the basic plane as \U+XXXX, R12 knows no way.
std::string safe(std::string_view text, Version version) {
  const std::string valid = valid_utf8(text);
  std::string out;
  for (size_t at = 0; at < valid.size();) {
    const size_t bytes = utf8_character_bytes(std::string_view(valid).substr(at));
    const uint32_t code = utf8_code(std::string_view(valid).substr(at, bytes));
    at += bytes;
    std::string piece(1, static_cast<char>(code));
    if (code < 0x20 || code == 0x7F) {
      piece = " ";
    } else if (code > 0x7F) {
      piece = "_";
      if (version == Version::kR2000 && code <= 0xFFFF)
        piece = {
            '\\',           'U', '+', kHex[code >> 12], kHex[code >> 8 & 15], kHex[code >> 4 & 15],
            kHex[code & 15]};
    }
    if (out.size() + piece.size() > kMaxTextBytes) break;
    out += piece;
  }
  return out;
}

}  // namespace

Text& Text::code(int code) {
  const std::string text = std::to_string(code);
  if (text.size() < 3) out_.append(3 - text.size(), ' ');
  out_.append(text).append("\n");
  return *this;
}

Text& Text::group(int code_, std::string_view text) {
  code(code_);
  out_.append(safe(text, version_)).append("\n");
  return *this;
}

Text& Text::group(int code_, int value) {
  code(code_);
  out_.append(std::to_string(value)).append("\n");
  return *this;
}

Text& Text::group(int code_, double value) {
  // Vertices are finite, but what is reckoned from the largest of them may not be.
  if (!std::isfinite(value))
    fail(Status::kUnsupported, "a number of the drawing (DXF group %d) is too large to be written",
         code_);
  code(code_);
  std::string text = text_of(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  out_.append(text).append("\n");
  return *this;
}

Text& Text::handle(int code_, uint64_t handle) {
  code(code_);
  char text[17];
  const auto [end, error] = std::to_chars(text, text + sizeof text, handle, 16);
  for (char* c = text; c != end; ++c)
    if (*c >= 'a') *c = static_cast<char>(*c - 'a' + 'A');
  out_.append(text, end).append("\n");
  return *this;
}

Text& Text::point(int code, const Vec3& p) {
  return group(code, p.x).group(code + 10, p.y).group(code + 20, p.z);
}

Text& Text::begin(std::string_view name, uint64_t own, uint64_t owner, int handle_code) {
  group(0, name);
  return is_r12() ? *this : handle(handle_code, own).handle(330, owner);
}

Text& Text::subclass(std::string_view name) { return is_r12() ? *this : group(100, name); }

}  // namespace jalon::dxf
