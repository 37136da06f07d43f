// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"

#include <cstdarg>

#include "base/whole_utf8.h"

namespace jalon {

void fail(Status status, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const MessageText message(format, arguments);
  va_end(arguments);
  throw Error(status, {message.text, message.bytes});
}

}  // namespace jalon
