// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json_cursor.h"

#include <cmath>

#include "base/error.h"
#include "base/text_number.h"
#include "base/utf8_character.h"

namespace jalon {

namespace {

constexpr size_t kStepsPerTick = 8192;  // values between two ticks: about a millisecond

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

JsonCursor::JsonCursor(std::string_view text, const JsonListener& listener)
    : text_(text), listener_(listener) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

void JsonCursor::refuse(const char* expected) const {
  listener_.refuse(at_, expected);
  fail(Status::kInternal, "a JSON refusal returned");
}

bool JsonCursor::take(char c) {
  if (at_ >= text_.size() || text_[at_] != c) return false;
  ++at_;
  return true;
}

void JsonCursor::take_word(std::string_view word) {
  if (!text_.substr(at_).starts_with(word)) refuse("a value");
  at_ += word.size();
}

void JsonCursor::skip_space() {
  while (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r') ++at_;
}

JsonCursor::Kind JsonCursor::kind() {
  skip_space();
  switch (peek()) {
    case '{':
      return Kind::kObject;
    case '[':
      return Kind::kArray;
    case '"':
      return Kind::kText;
    case 't':
    case 'f':
      return Kind::kBool;
    case 'n':
      return Kind::kNull;
    default:
      return Kind::kNumber;
  }
}

void JsonCursor::open(char bracket) {
  skip_space();
  if (!take(bracket)) refuse(bracket == '{' ? "an object" : "an array");
  if (++depth_ > kMaxDepth) refuse("no more than 64 levels");
  fresh_ = true;
}

// Behind the last value of an object or array; a comma stands between two.
bool JsonCursor::next(char closing) {
  if (++steps_ % kStepsPerTick == 0) listener_.tick();
  skip_space();
  if (take(closing)) {
    --depth_;
    fresh_ = false;
    return false;
  }
  if (!fresh_ && !take(',')) refuse("a comma or the end of the values");
  fresh_ = false;
  return true;
}

void JsonCursor::begin_object() { open('{'); }
void JsonCursor::begin_array() { open('['); }
bool JsonCursor::next_element() { return next(']'); }

bool JsonCursor::next_member(std::string& name) {
  if (!next('}')) return false;
  skip_space();
  name.clear();
  string(&name);
  skip_space();
  if (!take(':')) refuse("a colon");
  return true;
}

void JsonCursor::digits() {
  if (!is_digit(peek())) refuse("a number");
  while (is_digit(peek())) ++at_;
}

std::string_view JsonCursor::number_text(bool& whole) {
  skip_space();
  const size_t begin = at_;
  whole = true;
  take('-');
  if (!take('0')) digits();
  if (take('.')) {
    whole = false;
    digits();
  }
  if (take('e') || take('E')) {
    whole = false;
    if (!take('+')) take('-');
    digits();
  }
  return text_.substr(begin, at_ - begin);
}

double JsonCursor::number() {
  bool whole = false;
  double out = 0;
  if (!parse_number(number_text(whole), out) || !std::isfinite(out))
    refuse("a number that a double holds");
  return out;
}

int64_t JsonCursor::integer() {
  bool whole = false;
  int64_t out = 0;
  const std::string_view text = number_text(whole);
  if (!whole || !parse_integer(text, out)) refuse("a whole number");
  return out;
}

std::string JsonCursor::text() {
  std::string out;
  skip_space();
  string(&out);
  return out;
}

bool JsonCursor::flag() {
  const bool value = kind() == Kind::kBool && peek() == 't';
  take_word(value ? "true" : "false");
  return value;
}

void JsonCursor::null() {
  skip_space();
  take_word("null");
}

std::string_view JsonCursor::skip() {
  const Kind what = kind();
  const size_t begin = at_;
  bool whole = false;
  std::string name;
  switch (what) {
    case Kind::kNull:
      null();
      break;
    case Kind::kBool:
      flag();
      break;
    case Kind::kNumber:
      number_text(whole);
      break;
    case Kind::kText:
      string(nullptr);
      break;
    case Kind::kArray:
      for (begin_array(); next_element();) skip();
      break;
    case Kind::kObject:
      for (begin_object(); next_member(name);) skip();
      break;
  }
  return text_.substr(begin, at_ - begin);
}

void JsonCursor::end() {
  skip_space();
  if (at_ != text_.size()) refuse("the end of the text");
}

void JsonCursor::string(std::string* out) {
  if (!take('"')) refuse("a text in quotes");
  while (!take('"')) {
    if (static_cast<unsigned char>(peek()) < 0x20) refuse("the closing quote");
    if (take('\\')) {
      escape(out);
      continue;
    }
    const size_t bytes = utf8_character_bytes(text_.substr(at_));
    if (bytes == 0) refuse("valid UTF-8");
    if (out != nullptr) out->append(text_, at_, bytes);
    at_ += bytes;
  }
}

void JsonCursor::escape(std::string* out) {
  constexpr std::string_view kLetters = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
  if (take('u')) {
    uint32_t code = hex4();
    if (code >= 0xD800 && code < 0xDC00) {  // the first half of a pair
      const uint32_t low = take('\\') && take('u') ? hex4() : 0;
      if (low < 0xDC00 || low > 0xDFFF) refuse("the second half of a surrogate pair");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    } else if (code >= 0xDC00 && code < 0xE000) {
      refuse("the first half of a surrogate pair");
    }
    if (out != nullptr) append_utf8(*out, code);
    return;
  }
  const size_t i = at_ < text_.size() ? kLetters.find(text_[at_]) : std::string_view::npos;
  if (i == std::string_view::npos) refuse("an escape");
  if (out != nullptr) *out += kMeanings[i];
  ++at_;
}

uint32_t JsonCursor::hex4() {
  uint32_t code = 0;
  for (int i = 0; i < 4; ++i, ++at_) {
    const char c = peek();
    const int digit = is_digit(c)            ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : -1;
    if (digit < 0) refuse("four hexadecimal digits");
    code = code << 4 | static_cast<uint32_t>(digit);
  }
  return code;
}

}  // namespace jalon
