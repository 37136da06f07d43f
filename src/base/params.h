// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jalon {

/// The numbers of jalon/params.h.
enum class ParamType : int32_t { kDouble = 1, kInt64 = 2, kBool = 3, kString = 4, kChoice = 5, kDoubles = 6 };

/// One row of a parameter table. Tables are constexpr arrays, made with the functions below.
struct ParamRow {
  const char* name;
  ParamType type;
  const char* unit;
  const char* methods;  ///< comma-separated; "" = all
  const char* help;
  double number = 0;           ///< default of double, int64, bool
  const char* text = "";       ///< default of string and choice; of doubles: numbers separated by spaces
  const char* choices = "";    ///< separated by '|'
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
};

constexpr ParamRow number_row(const char* name, double value, double minimum, double maximum, const char* unit,
                              const char* methods, const char* help) {
  return {name, ParamType::kDouble, unit, methods, help, value, "", "", minimum, maximum};
}
constexpr ParamRow integer_row(const char* name, int64_t value, double minimum, double maximum, const char* unit,
                               const char* methods, const char* help) {
  return {name, ParamType::kInt64, unit, methods, help, static_cast<double>(value), "", "", minimum, maximum};
}
constexpr ParamRow bool_row(const char* name, bool value, const char* methods, const char* help) {
  return {name, ParamType::kBool, "", methods, help, value ? 1.0 : 0.0};
}
constexpr ParamRow string_row(const char* name, const char* value, const char* methods, const char* help) {
  return {name, ParamType::kString, "", methods, help, 0, value};
}
constexpr ParamRow choice_row(const char* name, const char* value, const char* choices, const char* methods,
                              const char* help) {
  return {name, ParamType::kChoice, "", methods, help, 0, value, choices};
}
constexpr ParamRow doubles_row(const char* name, const char* values, double minimum, double maximum, const char* unit,
                               const char* methods, const char* help) {
  return {name, ParamType::kDoubles, unit, methods, help, 0, values, "", minimum, maximum};
}

/// Values of a table's rows. Setters check name, type and range and throw Error(kInvalidArgument) or, for an unknown
/// name, Error(kNotFound) listing the names. Getters of code that owns the table never fail but on a wrong name
/// (kInternal).
class ParamSet {
 public:
  /// The member of the row's type counts. (A std::variant would do, but libstdc++ leaves one without a value when a
  /// copy runs out of memory.)
  struct Value {
    double number = 0;
    int64_t integer = 0;
    bool flag = false;
    std::string text;
    std::vector<double> numbers;
  };

  /// rows must live as long as the set (static tables do).
  ParamSet(const char* owner, std::span<const ParamRow> rows);

  std::span<const ParamRow> rows() const { return rows_; }
  size_t index_of(std::string_view name) const;  ///< throws kNotFound
  const Value& value(size_t i) const { return values_[i]; }

  void set_number(std::string_view name, double value);    ///< also accepted by int64 rows when whole
  void set_integer(std::string_view name, int64_t value);  ///< also accepted by double rows
  void set_bool(std::string_view name, bool value);
  void set_text(std::string_view name, std::string_view value);
  void set_numbers(std::string_view name, std::span<const double> values);

  double number(std::string_view name) const;
  int64_t integer(std::string_view name) const;
  bool flag(std::string_view name) const;
  const std::string& text(std::string_view name) const;
  const std::vector<double>& numbers(std::string_view name) const;

  void reset();
  std::string to_json() const;
  void from_json(std::string_view json);  ///< all or nothing
  /// The default of row i as JSON text.
  std::string default_text(size_t i) const;

 private:
  const Value& typed(std::string_view name, ParamType type) const;
  const char* owner_;
  std::span<const ParamRow> rows_;
  std::vector<Value> values_;
};

}  // namespace jalon
