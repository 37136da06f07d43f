// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace jalon {

/// What a JsonCursor tells on its way.
class JsonListener {
 public:
  virtual ~JsonListener() = default;
  /// Must throw: "a number was expected at byte 12".
  virtual void refuse(uint64_t byte, const char* expected) const = 0;
  /// Called about every millisecond's work.
  virtual void tick() const {}
};

/// Walks through a JSON text (RFC 8259) value by value and keeps nothing, for files too large to hold as values. The
/// caller takes each value by its kind or skips it:
///
///   cursor.begin_array();
///   while (cursor.next_element()) sum += cursor.number();
///   cursor.begin_object();
///   for (std::string name; cursor.next_member(name);) name == "type" ? use(cursor.text()) : cursor.skip();
///
/// Whatever is no JSON, or another kind than asked for, ends in the listener's refusal.
class JsonCursor {
 public:
  enum class Kind { kNull, kBool, kNumber, kText, kArray, kObject };
  /// Both must outlive the cursor.
  JsonCursor(std::string_view text, const JsonListener& listener);

  Kind kind();  ///< of the value that comes next
  void begin_object();
  bool next_member(std::string& name);  ///< false behind the last one
  void begin_array();
  bool next_element();  ///< false behind the last one
  double number();      ///< finite
  int64_t integer();    ///< a number without fraction and exponent
  std::string text();
  bool flag();
  void null();
  std::string_view skip();  ///< the text of the value, checked
  void end();               ///< nothing but blanks may follow

  uint64_t byte() const { return at_; }
  [[noreturn]] void refuse(const char* expected) const;

 private:
  static constexpr int kMaxDepth = 64;
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c);
  void take_word(std::string_view word);
  void skip_space();
  void open(char bracket);
  bool next(char closing);
  void digits();
  std::string_view number_text(bool& whole);
  void string(std::string* out);
  void escape(std::string* out);
  uint32_t hex4();

  std::string_view text_;
  const JsonListener& listener_;
  size_t at_ = 0, steps_ = 0;
  int depth_ = 0;
  bool fresh_ = false;  ///< nothing taken yet from the open object or array
};

}  // namespace jalon
