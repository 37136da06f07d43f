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
enum class ParamType : int32_t {
  kDouble = 1,
  kInt64 = 2,
  kBool = 3,
  kString = 4,
  kChoice = 5,
  kDoubles = 6
};

/// A value of a row; the member of the row's type counts. (A std::variant would do, but libstdc++
/// leaves one without a value when a copy runs out of memory.)
struct ParamValue {
  double number = 0;
  int64_t integer = 0;
  bool flag = false;
  std::string text;
  std::vector<double> numbers;
};

/// One row of a parameter table. Tables are constexpr arrays, made with the functions of
/// base/setting_rows.h, which bind each row to a member of a settings struct.
struct ParamRow {
  const char* name = "";
  ParamType type = ParamType::kDouble;
  const char* unit = "";
  const char* methods = "";  ///< comma-separated; "" = all
  const char* help = "";
  const char* choices = "";  ///< separated by '|'
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  ParamValue (*initial)(const ParamRow&) = nullptr;  ///< what a new settings struct holds
  ParamValue (*save)(const ParamRow&, const void* settings) = nullptr;  ///< what this one holds
  void (*load)(const ParamRow&, const ParamValue&, void* settings) = nullptr;
  const char* settings = nullptr;  ///< &kSettingsTag of the struct
};
/// Its address tells the settings struct.
template <class S>
inline constexpr char kSettingsTag = 0;

/// The place of a choice among the row's, from 0, or the number of choices; and the choice at a place.
size_t choice_place(const ParamRow& row, std::string_view choice);
std::string choice_at(const ParamRow& row, size_t place);

/// Values of a table's rows. Setters check name, type and range and throw Error(kInvalidArgument) or, for an unknown
/// name, Error(kNotFound) listing the names. Getters of code that owns the table never fail but on a wrong name
/// (kInternal).
class ParamSet {
 public:
  using Value = ParamValue;

  /// rows must live as long as the set (static tables do).
  ParamSet(const char* owner, std::span<const ParamRow> rows);

  std::span<const ParamRow> rows() const { return rows_; }
  size_t index_of(std::string_view name) const;  ///< throws kNotFound
  const Value& value(size_t i) const { return values_[i]; }

  void set_number(std::string_view name, double value);  ///< also accepted by int64 rows when whole
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
  /// Fills a settings struct that all rows are bound to; see settings_from.
  void load_into(void* settings, const char* tag) const;

 private:
  const Value& typed(std::string_view name, ParamType type) const;
  const char* owner_;
  std::span<const ParamRow> rows_;
  std::vector<Value> values_;
};

/// The values as the settings struct that the table's rows are bound to.
template <class S>
S settings_from(const ParamSet& params) {
  S settings{};
  params.load_into(&settings, &kSettingsTag<S>);
  return settings;
}

}  // namespace jalon
