// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/handles.h"
#include "cli/text_file.h"

namespace jalon::cli {

/// A field table for files that people and scripts read: any column, whatever the library adds to it.
class Table {
 public:
  explicit Table(Fields fields);

  uint64_t rows() const { return rows_; }
  jalon_fields* fields() const { return fields_.get(); }
  /// Element as a double; the column must be there.
  bool has(const char* name) const;
  double number(const char* name, uint64_t row, uint32_t component = 0) const;
  uint64_t count(const char* name, uint64_t row) const {
    return static_cast<uint64_t>(number(name, row));
  }
  /// A row as {"name": value or [values]}; what is not finite becomes null.
  nlohmann::ordered_json object(uint64_t row) const;
  nlohmann::ordered_json list() const;
  /// Comma-separated text with a heading; columns of several components as name_0, name_1 ...
  std::string csv() const;

 private:
  struct Column {
    std::string name;
    uint32_t components;
    bool is_integer;
    bool may_be_none;               ///< UINT64_MAX stands for none: null, and nothing in CSV
    std::vector<double> numbers;    ///< of floating columns
    std::vector<int64_t> integers;  ///< of the others
    bool is_none(uint64_t at) const { return may_be_none && integers[at] == -1; }
  };
  const Column& column(const char* name) const;
  Fields fields_;
  uint64_t rows_ = 0;
  std::vector<Column> columns_;
};

/// The values of a set of parameters.
nlohmann::ordered_json json_of(jalon_params* params);

}  // namespace jalon::cli
