// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

namespace jalon::cli {

namespace {

std::string text_of(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  char text[32];
  const auto end =
      std::to_chars(text, text + sizeof text, value);  // the shortest that reads back the same
  return {text, end.ptr};
}

}  // namespace

Table::Table(Fields fields) : fields_(std::move(fields)) {
  uint64_t count = 0;
  must(jalon_fields_count(fields_.get(), &count));
  for (uint64_t i = 0; i < count; ++i) {
    jalon_field_info info{};
    info.struct_size = sizeof info;
    must(jalon_fields_info(fields_.get(), i, &info));
    Column column{info.name, info.components, info.type < JALON_FLOAT32, false, {}, {}};
    rows_ = info.count;
    const uint64_t elements = info.count * info.components;
    if (column.is_integer) {
      column.integers.resize(elements);
      // UINT64_MAX, which stands for none, becomes -1; no count is so large that it would be negative too.
      const int32_t type = info.type == JALON_UINT64 ? JALON_UINT64 : JALON_INT64;
      column.may_be_none = info.type == JALON_UINT64;
      must(jalon_fields_copy(fields_.get(), info.name, type, column.integers.data(), elements));
    } else {
      column.numbers.resize(elements);
      must(jalon_fields_copy(fields_.get(), info.name, JALON_FLOAT64, column.numbers.data(),
                             elements));
    }
    columns_.push_back(std::move(column));
  }
}

const Table::Column& Table::column(const char* name) const {
  for (const Column& column : columns_)
    if (column.name == name) return column;
  throw Failure{JALON_ERROR_INTERNAL, std::string("no column ") + name};
}

bool Table::has(const char* name) const {
  return std::any_of(columns_.begin(), columns_.end(),
                     [&](const Column& column) { return column.name == name; });
}

double Table::number(const char* name, uint64_t row, uint32_t component) const {
  const Column& c = column(name);
  const uint64_t at = row * c.components + component;
  return c.is_integer ? static_cast<double>(c.integers[at]) : c.numbers[at];
}

nlohmann::ordered_json Table::object(uint64_t row) const {
  auto out = nlohmann::ordered_json::object();
  for (const Column& c : columns_) {
    auto values = nlohmann::ordered_json::array();
    for (uint32_t k = 0; k < c.components; ++k) {
      const uint64_t at = row * c.components + k;
      if (c.is_none(at)) values.push_back(nullptr);
      else if (c.is_integer) values.push_back(c.integers[at]);
      else values.push_back(c.numbers[at]);
    }
    out[c.name] = c.components == 1 ? values[0] : values;
  }
  return out;
}

nlohmann::ordered_json Table::list() const {
  auto out = nlohmann::ordered_json::array();
  for (uint64_t row = 0; row < rows_; ++row) out.push_back(object(row));
  return out;
}

std::string Table::csv() const {
  std::string out;
  for (const Column& c : columns_)
    for (uint32_t k = 0; k < c.components; ++k) {
      if (!out.empty()) out += ',';
      out += c.components == 1 ? c.name : c.name + "_" + std::to_string(k);
    }
  out += '\n';
  for (uint64_t row = 0; row < rows_; ++row) {
    const char* separator = "";
    for (const Column& c : columns_)
      for (uint32_t k = 0; k < c.components; ++k, separator = ",") {
        const uint64_t at = row * c.components + k;
        out += separator;
        if (!c.is_none(at))
          out += c.is_integer ? std::to_string(c.integers[at]) : text_of(c.numbers[at]);
      }
    out += '\n';
  }
  return out;
}

nlohmann::ordered_json json_of(jalon_params* params) {
  const char* json = nullptr;
  must(jalon_params_to_json(params, &json));
  return nlohmann::ordered_json::parse(json);
}

}  // namespace jalon::cli
