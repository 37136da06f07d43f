// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/group_reader.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "base/error.h"
#include "base/text_number.h"
#include "base/utf8_character.h"
#include "formats/files/utf8.h"

namespace jalon::dxf {

namespace {

constexpr int kLastCode = 1071;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

}  // namespace

bool GroupReader::next() {
  if (is_kept_) {
    is_kept_ = false;
    return true;
  }
  std::string_view line;
  if (!lines_.next(line)) return false;
  int64_t code = 0;
  if (!parse_integer(trimmed(line), code) || code < -5 || code > kLastCode)
    refuse("\"%.40s\" is no group code", std::string(line.substr(0, 40)).c_str());
  code_ = static_cast<int>(code);
  if (!lines_.next(line)) refuse("the file ends before the value of group %d", code_);
  value_ = trimmed(line);
  return true;
}

double GroupReader::number() const {
  double value = 0;
  if (!parse_number(value_, value) || !std::isfinite(value))
    refuse("group %d: \"%.40s\" is no number", code_, value_.substr(0, 40).c_str());
  return value;
}

int64_t GroupReader::integer() const {
  int64_t value = 0;
  if (!parse_integer(value_, value))
    refuse("group %d: \"%.40s\" is no whole number", code_, value_.substr(0, 40).c_str());
  return value;
}

std::string GroupReader::text() const {
  std::string out;
  for (size_t at = 0; at < value_.size();) {
    const bool is_escape = value_.compare(at, 3, "\\U+") == 0 && at + 7 <= value_.size();
    int code = 0;
    for (size_t k = 3; is_escape && k < 7 && code >= 0; ++k) {
      const int digit = digit_of(value_[at + k]);
      code = digit < 0 ? -1 : code * 16 + digit;
    }
    if (is_escape && code > 0) {
      append_utf8(out, static_cast<uint32_t>(code));
      at += 7;
    } else {
      out += value_[at++];
    }
  }
  return valid_utf8(out);
}

void GroupReader::refuse(const char* format, ...) const {
  char reason[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(reason, sizeof reason, format, arguments);
  va_end(arguments);
  fail(Status::kFormat, "%.400s: line %llu: %s", source_.path().c_str(),
       static_cast<unsigned long long>(lines_.number()), reason);
}

}  // namespace jalon::dxf
