// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/param_values.h"

#include <algorithm>
#include <bit>

namespace jalon {

namespace {

// What a value takes at least: the length of its name, its type, a bool.
constexpr size_t kLeastValueBytes = 8 + 4 + 1;

bool same_bits(double a, double b) {
  return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

// A value that a row holds already needs no check, and may be one that nobody can set (a default that says "none").
void set_value(ParamSet& params, size_t row, const std::string& name, const ParamValue& value) {
  const ParamValue& held = params.value(row);
  switch (params.rows()[row].type) {
    case ParamType::kDouble:
      if (!same_bits(value.number, held.number)) params.set_number(name, value.number);
      return;
    case ParamType::kInt64:
      if (value.integer != held.integer) params.set_integer(name, value.integer);
      return;
    case ParamType::kBool:
      return params.set_bool(name, value.flag);
    case ParamType::kString:
    case ParamType::kChoice:
      if (value.text != held.text) params.set_text(name, value.text);
      return;
    case ParamType::kDoubles:
      if (!std::equal(value.numbers.begin(), value.numbers.end(), held.numbers.begin(),
                      held.numbers.end(), same_bits))
        params.set_numbers(name, value.numbers);
  }
}

// The member of the type, for both directions.
template <class Value, class F>
void visit_value(ParamType type, Value& value, F&& f) {
  switch (type) {
    case ParamType::kDouble:
      return f(value.number);
    case ParamType::kInt64:
      return f(value.integer);
    case ParamType::kBool:
      return f(value.flag);
    case ParamType::kString:
    case ParamType::kChoice:
      return f(value.text);
    case ParamType::kDoubles:
      f(value.numbers);
  }
}

}  // namespace

void write_values(ByteWriter& writer, const ParamSet& params) {
  writer.item(static_cast<uint64_t>(params.rows().size()));
  for (size_t i = 0; i < params.rows().size(); ++i) {
    const ParamRow& row = params.rows()[i];
    writer.text(row.name);
    writer.item(row.type);
    visit_value(row.type, params.value(i), [&](const auto& value) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::vector<double>>)
        writer.list(value);
      else writer.item(value);
    });
  }
}

void read_values(ByteReader& reader, ParamSet& params) {
  for (size_t left = reader.count(kLeastValueBytes); left > 0; --left) {
    const std::string name = reader.text();
    const auto type = reader.take<ParamType>();
    try {
      const size_t row = params.index_of(name);
      if (params.rows()[row].type != type)
        reader.refuse("parameter \"%s\" is of type %d here, not %d", name.c_str(),
                      static_cast<int>(params.rows()[row].type), static_cast<int>(type));
      ParamValue value;
      visit_value(type, value, [&](auto& member) {
        if constexpr (std::is_same_v<std::decay_t<decltype(member)>, std::vector<double>>)
          reader.list(member);
        else reader.item(member);
      });
      set_value(params, row, name, value);
    } catch (const Error& error) {
      if (error.status() == Status::kFormat) throw;
      reader.refuse("%.400s", error.what());
    }
  }
}

}  // namespace jalon
