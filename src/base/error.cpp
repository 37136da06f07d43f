// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"

#include <cstdarg>
#include <cstdio>

#include "base/whole_utf8.h"

namespace jalon {

void fail(Status status, const char* format, ...) {
  constexpr size_t kMostBytes = 1023;
  char text[kMostBytes + kMostUtf8Bytes];  // a character across the limit is whole, and left out
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  throw Error(status, {text, copy_whole_utf8(text, text, kMostBytes)});
}

}  // namespace jalon
