// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json_reader.h"

#include <cmath>

#include "base/error.h"
#include "base/text_number.h"
#include "base/utf8_character.h"

namespace jalon {

namespace {

constexpr int kMaxDepth = 64;
constexpr size_t kMaxBytes = size_t{16} << 20;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

void append_utf8(std::string& out, uint32_t code) {
  const auto put = [&](uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) return put(code);
  if (code < 0x800) {
    put(0xC0 | code >> 6);
  } else {
    if (code < 0x10000) {
      put(0xE0 | code >> 12);
    } else {
      put(0xF0 | code >> 18);
      put(0x80 | (code >> 12 & 0x3F));
    }
    put(0x80 | (code >> 6 & 0x3F));
  }
  put(0x80 | (code & 0x3F));
}

/// Recursive descent, one function a rule of RFC 8259.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  std::vector<JsonValue> read() {
    value({}, 0);
    skip_space();
    if (at_ != text_.size()) wrong("the end of the text");
    return std::move(values_);
  }

 private:
  [[noreturn]] void wrong(const char* expected) const {
    fail(Status::kInvalidArgument, "no JSON: %s was expected at byte %zu", expected, at_);
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) {
    if (peek() != c || at_ >= text_.size()) return false;
    ++at_;
    return true;
  }
  bool take_word(std::string_view word) {
    if (!text_.substr(at_).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }
  void skip_space() {
    while (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r') ++at_;
  }

  void value(std::string name, int depth) {
    using Kind = JsonValue::Kind;
    if (depth > kMaxDepth) fail(Status::kInvalidArgument, "the JSON text is nested deeper than %d levels", kMaxDepth);
    skip_space();
    const size_t self = values_.size();
    values_.emplace_back();
    values_[self].name = std::move(name);
    if (take('{')) {
      values_[self].kind = Kind::kObject;
      members(depth);
    } else if (take('[')) {
      values_[self].kind = Kind::kArray;
      elements(depth);
    } else if (peek() == '"') {
      values_[self].kind = Kind::kText;
      values_[self].text = string();
    } else if (take_word("true")) {
      values_[self].kind = Kind::kBool;
      values_[self].flag = true;
    } else if (take_word("false")) {
      values_[self].kind = Kind::kBool;
    } else if (!take_word("null")) {
      number(values_[self]);
    }
    values_[self].extent = values_.size() - self;
  }

  void members(int depth) {
    skip_space();
    if (take('}')) return;
    do {
      skip_space();
      std::string name = string();
      skip_space();
      if (!take(':')) wrong("a colon");
      value(std::move(name), depth + 1);
      skip_space();
    } while (take(','));
    if (!take('}')) wrong("a comma or the end of an object");
  }

  void elements(int depth) {
    skip_space();
    if (take(']')) return;
    do {
      value({}, depth + 1);
      skip_space();
    } while (take(','));
    if (!take(']')) wrong("a comma or the end of an array");
  }

  void digits() {
    if (!is_digit(peek())) wrong("a digit");
    while (is_digit(peek())) ++at_;
  }

  void number(JsonValue& out) {
    const size_t begin = at_;
    bool whole = true;
    take('-');
    if (at_ == begin && !is_digit(peek())) wrong("a value");
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
    out.text = text_.substr(begin, at_ - begin);
    if (!parse_number(out.text, out.number) || !std::isfinite(out.number))
      fail(Status::kInvalidArgument, "no JSON: the number at byte %zu is outside the range of a double", begin);
    out.kind = whole && parse_integer(out.text, out.integer) ? JsonValue::Kind::kInteger : JsonValue::Kind::kNumber;
  }

  std::string string() {
    if (!take('"')) wrong("a text in quotes");
    std::string out;
    while (!take('"')) {
      if (static_cast<unsigned char>(peek()) < 0x20) wrong("the closing quote");
      if (take('\\')) {
        escape(out);
        continue;
      }
      const size_t bytes = utf8_character_bytes(text_.substr(at_));
      if (bytes == 0) wrong("valid UTF-8");
      out.append(text_, at_, bytes);
      at_ += bytes;
    }
    return out;
  }

  void escape(std::string& out) {
    constexpr std::string_view kLetters = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
    if (take('u')) {
      uint32_t code = hex4();
      if (code >= 0xD800 && code < 0xDC00) {  // the first half of a pair
        const uint32_t low = take_word("\\u") ? hex4() : 0;
        if (low < 0xDC00 || low > 0xDFFF) wrong("the second half of a surrogate pair");
        code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
      } else if (code >= 0xDC00 && code < 0xE000) {
        wrong("the first half of a surrogate pair");
      }
      return append_utf8(out, code);
    }
    const size_t i = at_ < text_.size() ? kLetters.find(text_[at_]) : std::string_view::npos;
    if (i == std::string_view::npos) wrong("an escape");
    out += kMeanings[i];
    ++at_;
  }

  uint32_t hex4() {
    uint32_t code = 0;
    for (int i = 0; i < 4; ++i, ++at_) {
      const char c = peek();
      const int digit = is_digit(c)              ? c - '0'
                        : c >= 'a' && c <= 'f' ? c - 'a' + 10
                        : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                               : -1;
      if (digit < 0) wrong("four hexadecimal digits");
      code = code << 4 | static_cast<uint32_t>(digit);
    }
    return code;
  }

  std::string_view text_;
  size_t at_ = 0;
  std::vector<JsonValue> values_;
};

}  // namespace

const JsonValue* find_member(const JsonValue& object, std::string_view name) {
  const JsonValue* found = nullptr;
  for (const JsonValue& member : JsonChildren(object))
    if (member.name == name) found = &member;
  return found;
}

std::vector<JsonValue> read_json(std::string_view text) {
  if (text.size() > kMaxBytes)
    fail(Status::kInvalidArgument, "a JSON text of %zu bytes; at most %zu", text.size(), kMaxBytes);
  return Reader(text).read();
}

}  // namespace jalon
