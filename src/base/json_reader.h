// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jalon {

/// One value of a JSON text. A text is read into one flat array in the order of the text: a value's children follow it,
/// so nothing is allocated when it is dropped, and running out of memory on the way leaves nothing half made.
struct JsonValue {
  enum class Kind : uint8_t { kNull, kBool, kInteger, kNumber, kText, kArray, kObject };

  Kind kind = Kind::kNull;
  bool flag = false;
  int64_t integer = 0;  ///< of kInteger: a number without fraction and exponent that fits
  double number = 0;    ///< of kInteger and kNumber
  std::string text;     ///< of kText; of numbers as they were written
  std::string name;     ///< of a member of an object
  size_t extent = 1;    ///< values from here to the end of this one, itself included

  bool is_number() const { return kind == Kind::kInteger || kind == Kind::kNumber; }
};

/// The members of an object or the elements of an array: for (const JsonValue& child : JsonChildren(value)).
class JsonChildren {
 public:
  struct Iterator {
    const JsonValue* at;
    const JsonValue& operator*() const { return *at; }
    Iterator& operator++() {
      at += at->extent;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };

  explicit JsonChildren(const JsonValue& parent)
      : first_(&parent + 1), last_(&parent + parent.extent) {}
  Iterator begin() const { return {first_}; }
  Iterator end() const { return {last_}; }

 private:
  const JsonValue* first_;
  const JsonValue* last_;
};

/// The member of this name, the last one where a name stands twice, or NULL.
const JsonValue* find_member(const JsonValue& object, std::string_view name);

/// Reads one JSON text (RFC 8259, nothing more: no comments, no NaN, valid UTF-8); the first value is the whole.
/// Anything else, more than 64 levels or more than 16 MiB is Error(kInvalidArgument) with the byte where it went wrong.
std::vector<JsonValue> read_json(std::string_view text);

}  // namespace jalon
