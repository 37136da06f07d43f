// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/params.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

using Json = nlohmann::ordered_json;

ParamSet::Value default_of(const ParamRow& row) {
  switch (row.type) {
    case ParamType::kDouble: return row.number;
    case ParamType::kInt64: return static_cast<int64_t>(row.number);
    case ParamType::kBool: return row.number != 0;
    case ParamType::kString:
    case ParamType::kChoice: return std::string(row.text);
    case ParamType::kDoubles: break;
  }
  std::vector<double> numbers;
  std::string_view rest = row.text;
  while (!rest.empty()) {
    const size_t end = std::min(rest.find(' '), rest.size());
    double number = 0;
    if (end > 0 && parse_number(rest.substr(0, end), number)) numbers.push_back(number);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return numbers;
}

const char* type_name(ParamType type) {
  static constexpr const char* kNames[] = {"",       "a number", "an integer", "true or false",
                                           "a text", "a choice", "an array of numbers"};
  return kNames[static_cast<int32_t>(type)];
}

[[noreturn]] void wrong_type(const ParamRow& row, const char* given) {
  fail(Status::kInvalidArgument, "parameter \"%s\" is %s, not %s", row.name, type_name(row.type), given);
}

void check_range(const ParamRow& row, double value) {
  // The negated form also refuses NaN; infinity passes only where the row has no limit on that side.
  if (!(value >= row.minimum && value <= row.maximum))
    fail(Status::kInvalidArgument, "parameter \"%s\" = %s%s%s is outside %s ... %s", row.name,
         text_of(value).c_str(), *row.unit ? " " : "", row.unit, text_of(row.minimum).c_str(),
         text_of(row.maximum).c_str());
}

bool is_choice(const ParamRow& row, std::string_view value) {
  std::string_view rest = row.choices;
  for (;;) {
    const size_t end = std::min(rest.find('|'), rest.size());
    if (rest.substr(0, end) == value) return true;
    if (end == rest.size()) return false;
    rest.remove_prefix(end + 1);
  }
}

Json json_of(const ParamSet::Value& value) {
  return std::visit(
      [](const auto& v) -> Json {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, double>)  // JSON has no infinity: it travels as text
          return std::isfinite(v) ? Json(v) : Json(text_of(v));
        else
          return Json(v);
      },
      value);
}

void set_from_json(ParamSet& set, const std::string& name, const Json& value) {
  if (value.is_boolean()) return set.set_bool(name, value.get<bool>());
  if (value.is_number_integer()) {
    if (value.is_number_unsigned() && value.get<uint64_t>() > uint64_t{INT64_MAX})
      return set.set_number(name, value.get<double>());
    return set.set_integer(name, value.get<int64_t>());
  }
  if (value.is_number()) return set.set_number(name, value.get<double>());
  if (value.is_array()) {
    std::vector<double> numbers;
    for (const Json& element : value) {
      if (!element.is_number())
        fail(Status::kInvalidArgument, "parameter \"%s\": every array element must be a number", name.c_str());
      numbers.push_back(element.get<double>());
    }
    return set.set_numbers(name, numbers);
  }
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    double number = 0;
    if (set.rows()[set.index_of(name)].type == ParamType::kDouble && parse_number(text, number))
      return set.set_number(name, number);
    return set.set_text(name, text);
  }
  fail(Status::kInvalidArgument, "parameter \"%s\": a JSON value of this kind is not accepted", name.c_str());
}

}  // namespace

ParamSet::ParamSet(const char* owner, std::span<const ParamRow> rows) : owner_(owner), rows_(rows) { reset(); }

void ParamSet::reset() {
  std::vector<Value> values;
  values.reserve(rows_.size());
  for (const auto& row : rows_) values.push_back(default_of(row));
  values_.swap(values);
}

size_t ParamSet::index_of(std::string_view name) const {
  for (size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].name == name) return i;
  std::string names;
  for (const auto& row : rows_) names += (names.empty() ? "" : ", ") + std::string(row.name);
  fail(Status::kNotFound, "%s has no parameter \"%.*s\"; there are: %s", owner_,
       static_cast<int>(std::min<size_t>(name.size(), 100)), name.data(), names.c_str());
}

void ParamSet::set_number(std::string_view name, double value) {
  const size_t i = index_of(name);
  const ParamRow& row = rows_[i];
  if (row.type == ParamType::kInt64 && value == std::trunc(value) && std::fabs(value) < 0x1p63)
    return set_integer(name, static_cast<int64_t>(value));
  if (row.type != ParamType::kDouble) wrong_type(row, "a number");
  check_range(row, value);
  values_[i] = value;
}

void ParamSet::set_integer(std::string_view name, int64_t value) {
  const size_t i = index_of(name);
  const ParamRow& row = rows_[i];
  if (row.type != ParamType::kInt64 && row.type != ParamType::kDouble) wrong_type(row, "an integer");
  check_range(row, static_cast<double>(value));
  if (row.type == ParamType::kDouble)
    values_[i] = static_cast<double>(value);
  else
    values_[i] = value;
}

void ParamSet::set_bool(std::string_view name, bool value) {
  const size_t i = index_of(name);
  if (rows_[i].type != ParamType::kBool) wrong_type(rows_[i], "true or false");
  values_[i] = value;
}

void ParamSet::set_text(std::string_view name, std::string_view value) {
  const size_t i = index_of(name);
  const ParamRow& row = rows_[i];
  if (row.type != ParamType::kString && row.type != ParamType::kChoice) wrong_type(row, "a text");
  if (row.type == ParamType::kChoice && !is_choice(row, value))
    fail(Status::kInvalidArgument, "parameter \"%s\" = \"%.*s\" is none of %s", row.name,
         static_cast<int>(std::min<size_t>(value.size(), 100)), value.data(), row.choices);
  values_[i] = std::string(value);
}

void ParamSet::set_numbers(std::string_view name, std::span<const double> values) {
  const size_t i = index_of(name);
  const ParamRow& row = rows_[i];
  if (row.type != ParamType::kDoubles) wrong_type(row, "an array of numbers");
  for (double value : values) check_range(row, value);
  values_[i] = std::vector<double>(values.begin(), values.end());
}

const ParamSet::Value& ParamSet::typed(std::string_view name, ParamType type) const {
  const size_t i = index_of(name);
  const bool both_text = (type == ParamType::kString && rows_[i].type == ParamType::kChoice);
  if (rows_[i].type != type && !both_text) wrong_type(rows_[i], type_name(type));
  return values_[i];
}

double ParamSet::number(std::string_view name) const { return std::get<double>(typed(name, ParamType::kDouble)); }
int64_t ParamSet::integer(std::string_view name) const { return std::get<int64_t>(typed(name, ParamType::kInt64)); }
bool ParamSet::flag(std::string_view name) const { return std::get<bool>(typed(name, ParamType::kBool)); }
const std::string& ParamSet::text(std::string_view name) const {
  return std::get<std::string>(typed(name, ParamType::kString));
}
const std::vector<double>& ParamSet::numbers(std::string_view name) const {
  return std::get<std::vector<double>>(typed(name, ParamType::kDoubles));
}

std::string ParamSet::to_json() const {
  Json object = Json::object();
  for (size_t i = 0; i < rows_.size(); ++i) object[rows_[i].name] = json_of(values_[i]);
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void ParamSet::from_json(std::string_view json) {
  const Json object = Json::parse(json, nullptr, /*allow_exceptions=*/false);
  if (!object.is_object()) fail(Status::kInvalidArgument, "the parameters are not one JSON object");
  ParamSet trial = *this;
  for (const auto& [name, value] : object.items()) set_from_json(trial, name, value);
  values_.swap(trial.values_);
}

std::string ParamSet::default_text(size_t i) const { return json_of(default_of(rows_[i])).dump(); }

}  // namespace jalon
