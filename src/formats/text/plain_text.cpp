// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/text/text.h"

namespace jalon {

bool is_plain_text(const ByteSource& source) {
  constexpr size_t kLookBytes = 4096;
  char start[kLookBytes];
  const size_t bytes = source.read_some(0, start, sizeof start);
  for (const char c : std::string_view(start, bytes))
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f')
      return false;
  return bytes != 0;
}

}  // namespace jalon
