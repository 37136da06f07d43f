// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include "base/json_reader.h"

namespace jalon {

/// Builds JSON text value by value. Numbers are the shortest that read back the same, those that are not finite become
/// null; control characters are escaped, broken UTF-8 becomes U+FFFD.
///
///   JsonWriter json;
///   json.begin_object().name("label").value(3).name("size").begin_array().value(1.5).end_array().end_object();
///   json.take();  // {"label":3,"size":[1.5,2.0]}
class JsonWriter {
 public:
  /// indent: blanks a level, each value on its own line; negative writes everything on one line without blanks.
  explicit JsonWriter(int indent = -1) : indent_(indent) {}

  JsonWriter& begin_object() { return begin('{'); }
  JsonWriter& end_object() { return end('}'); }
  JsonWriter& begin_array() { return begin('['); }
  JsonWriter& end_array() { return end(']'); }
  JsonWriter& name(std::string_view name);  ///< of the member that comes next
  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(const std::string& text) { return value(std::string_view(text)); }
  JsonWriter& value(double number);
  JsonWriter& value(bool flag) { return literal(flag ? "true" : "false"); }
  template <std::integral T>
  JsonWriter& value(T number) {
    return literal(std::to_string(number));
  }
  JsonWriter& value(const JsonValue& read);  ///< with all its children

  std::string take() { return std::move(out_); }

 private:
  JsonWriter& begin(char bracket);
  JsonWriter& end(char bracket);
  JsonWriter& literal(std::string_view text);
  void separate();
  void new_line();
  void quoted(std::string_view text);

  std::string out_;
  int indent_, depth_ = 0;
  bool empty_ = true;  ///< nothing yet in the open object or array
  bool after_name_ = false;
};

}  // namespace jalon
