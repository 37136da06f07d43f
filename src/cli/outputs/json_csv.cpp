// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs/json_csv.h"

#include <charconv>
#include <string_view>

#include <nlohmann/json.hpp>

namespace jalon::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string cell_of(const Json& value) {
  if (value.is_null()) return {};
  return value.is_string() ? csv_cell(value.get<std::string>()) : value.dump();
}

// What a spreadsheet computes instead of showing it; numbers are shown.
bool is_formula(const std::string& text) {
  if (text.empty() || std::string_view("=+-@\t\r").find(text[0]) == std::string_view::npos)
    return false;
  const char* first = text.data() + (text[0] == '+' ? 1 : 0);
  const char* last = text.data() + text.size();
  double number = 0;
  const auto read = std::from_chars(first, last, number);
  return read.ec != std::errc() || read.ptr != last;
}

}  // namespace

std::string csv_cell(const std::string& text) {
  const std::string mark = is_formula(text) ? "'" : "";
  if (text.find_first_of(",\"\n\r") == std::string::npos) return mark + text;
  std::string out = "\"" + mark;
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string csv_of(const Json& rows) {
  std::string heading, out;
  for (const Json& row : rows) {
    const bool is_first = heading.empty();
    std::string line;
    const auto add = [&](const std::string& name, const Json& value) {
      if (is_first) heading += (heading.empty() ? "" : ",") + name;
      line += "," + cell_of(value);
    };
    for (const auto& [name, value] : row.items()) {
      if (!value.is_array()) add(name, value);
      for (size_t i = 0; value.is_array() && i < value.size(); ++i)
        add(name + "_" + std::to_string(i), value[i]);
    }
    out += line.substr(1) + "\n";
  }
  return heading + "\n" + out;
}

}  // namespace jalon::cli
