// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "base/utf8_character.h"

namespace jalon {

constexpr size_t kMostUtf8Bytes = 4;  ///< of a character

/// Copies text to out, at most room bytes: whole characters alone, and '?' for each run of bytes that are none, as
/// where a name was cut. Gives the bytes written; out may be where text begins. Never throws.
inline size_t copy_whole_utf8(std::string_view text, char* out, size_t room) {
  size_t written = 0;
  while (!text.empty()) {
    size_t read = utf8_character_bytes(text);
    const size_t bytes = read == 0 ? 1 : read;
    if (bytes > room - written) break;
    if (read > 0) {
      std::memmove(out + written, text.data(), bytes);
    } else {
      out[written] = '?';
      read = 1;
      while (read < text.size() && (static_cast<unsigned char>(text[read]) & 0xC0) == 0x80) ++read;
    }
    written += bytes;
    text.remove_prefix(read);
  }
  return written;
}

/// A formatted message, cut to whole characters; `text` ends with a zero.
struct MessageText {
  static constexpr size_t kMostBytes = 1023;
  char text[kMostBytes + kMostUtf8Bytes];  // a character across the limit is whole, and left out
  size_t bytes = 0;

  MessageText(const char* format, va_list arguments) {
    std::vsnprintf(text, sizeof text, format, arguments);
    bytes = copy_whole_utf8(text, text, kMostBytes);
    text[bytes] = 0;
  }
};

}  // namespace jalon
