// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <iterator>
#include <memory>
#include <string>

#include "base/field.h"

namespace jalon {

/// Adds a column of one element a row; value(row).
template <class T, class Rows, class F>
void add_column(FieldTable& table, const Rows& rows, const std::string& name, const char* unit,
                const char* meaning, F&& value) {
  auto column = std::make_shared<Column>(FieldInfo{name, element_type_of<T>(), 1, unit, meaning},
                                         std::size(rows));
  const auto out = column->template values<T>();
  size_t i = 0;
  for (const auto& row : rows) out[i++] = static_cast<T>(value(row));
  table.set(std::move(column));
}

/// Adds a column of N elements a row; fill(row, first element).
template <class T, size_t N, class Rows, class F>
void add_columns(FieldTable& table, const Rows& rows, const std::string& name, const char* unit,
                 const char* meaning, F&& fill) {
  auto column = std::make_shared<Column>(FieldInfo{name, element_type_of<T>(), N, unit, meaning},
                                         std::size(rows));
  T* out = column->template values<T>().data();
  for (const auto& row : rows) {
    fill(row, out);
    out += N;
  }
  table.set(std::move(column));
}

/// Adds a number to a table of one row.
template <class T>
void add_value(FieldTable& table, const std::string& name, const char* unit, const char* meaning,
               T value) {
  const T one[] = {value};
  add_column<T>(table, one, name, unit, meaning, [](T v) { return v; });
}

}  // namespace jalon
