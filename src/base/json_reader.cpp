// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json_reader.h"

#include <cmath>

#include "base/error.h"
#include "base/json_cursor.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr size_t kMaxBytes = size_t{16} << 20;

class Refusal : public JsonListener {
 public:
  void refuse(uint64_t byte, const char* expected) const override {
    fail(Status::kInvalidArgument, "no JSON: %s was expected at byte %llu", expected,
         static_cast<unsigned long long>(byte));
  }
};

class Reader {
 public:
  explicit Reader(std::string_view text) : cursor_(text, refusal_) {}

  std::vector<JsonValue> read() {
    value({});
    cursor_.end();
    return std::move(values_);
  }

 private:
  // The array may grow while children are read: the value is always named by its place.
  void value(std::string name) {
    using Kind = JsonValue::Kind;
    const size_t self = values_.size();
    values_.emplace_back();
    values_[self].name = std::move(name);
    switch (cursor_.kind()) {
      case JsonCursor::Kind::kNull:
        cursor_.null();
        break;
      case JsonCursor::Kind::kBool:
        values_[self].kind = Kind::kBool;
        values_[self].flag = cursor_.flag();
        break;
      case JsonCursor::Kind::kNumber:
        number(values_[self]);
        break;
      case JsonCursor::Kind::kText:
        values_[self].kind = Kind::kText;
        values_[self].text = cursor_.text();
        break;
      case JsonCursor::Kind::kArray:
        values_[self].kind = Kind::kArray;
        for (cursor_.begin_array(); cursor_.next_element();) value({});
        break;
      case JsonCursor::Kind::kObject: {
        values_[self].kind = Kind::kObject;
        std::string member;
        for (cursor_.begin_object(); cursor_.next_member(member);) value(std::move(member));
        break;
      }
    }
    values_[self].extent = values_.size() - self;
  }

  void number(JsonValue& out) {
    const uint64_t begin = cursor_.byte();
    out.text = cursor_.skip();
    if (!parse_number(out.text, out.number) || !std::isfinite(out.number))
      fail(Status::kInvalidArgument,
           "no JSON: the number at byte %llu is outside the range of a double",
           static_cast<unsigned long long>(begin));
    const bool whole = out.text.find_first_of(".eE") == std::string::npos;
    out.kind = whole && parse_integer(out.text, out.integer) ? JsonValue::Kind::kInteger
                                                             : JsonValue::Kind::kNumber;
  }

  Refusal refusal_;
  JsonCursor cursor_;
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
