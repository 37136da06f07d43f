// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/byte_reader.h"

#include <cstdarg>
#include <cstdio>

#include "base/utf8_character.h"

namespace jalon {

std::string ByteReader::text() {
  const size_t bytes = count(1);
  const std::string_view whole(reinterpret_cast<const char*>(block(bytes)), bytes);
  for (std::string_view rest = whole; !rest.empty();) {
    const size_t character = utf8_character_bytes(rest);
    if (character == 0 || rest.front() == 0) refuse("a text is not valid UTF-8");
    rest.remove_prefix(character);
  }
  return std::string(whole);
}

const uint8_t* ByteReader::block(uint64_t bytes) {
  if (bytes > left_.size())
    refuse("%llu bytes are told where %zu are left", static_cast<unsigned long long>(bytes),
           left_.size());
  const uint8_t* at = left_.data();
  left_ = left_.subspan(bytes);
  return at;
}

size_t ByteReader::count(size_t item_bytes) {
  const auto told = take<uint64_t>();
  if (told > left_.size() / item_bytes)
    refuse("%llu items of %zu bytes are told where %zu bytes are left",
           static_cast<unsigned long long>(told), item_bytes, left_.size());
  return told;
}

void ByteReader::end() const {
  if (!left_.empty()) refuse("%zu bytes stand behind the end", left_.size());
}

void ByteReader::refuse(const char* format, ...) const {
  char reason[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(reason, sizeof reason, format, arguments);
  va_end(arguments);
  fail(Status::kFormat, "the bytes of %s are wrong at byte %zu: %s", what_,
       kHeaderBytes + payload_.size() - left_.size(), reason);
}

}  // namespace jalon
