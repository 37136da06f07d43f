// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/params.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/json_reader.h"
#include "base/json_writer.h"
#include "base/settings_json.h"
#include "base/text_number.h"

namespace jalon {

namespace {

const char* type_name(ParamType type) {
  static constexpr const char* kNames[] = {
      "", "a number", "an integer", "true or false", "a text", "a choice", "an array of numbers"};
  return kNames[static_cast<int32_t>(type)];
}

[[noreturn]] void wrong_type(const ParamRow& row, const char* given) {
  fail(Status::kInvalidArgument, "parameter \"%s\" is %s, not %s", row.name, type_name(row.type),
       given);
}

void check_range(const ParamRow& row, double value) {
  // NaN is in no range; infinity passes only where the row has no limit on that side.
  if (value >= row.minimum && value <= row.maximum) return;
  const std::string unit = std::string_view(row.unit) == "1" ? "" : row.unit;
  fail(Status::kInvalidArgument, "parameter \"%s\" = %s%s%s is outside %s ... %s", row.name,
       text_of(value).c_str(), unit.empty() ? "" : " ", unit.c_str(), text_of(row.minimum).c_str(),
       text_of(row.maximum).c_str());
}

void write_value(JsonWriter& json, ParamType type, const ParamSet::Value& value) {
  switch (type) {
    case ParamType::kDouble:  // JSON has no infinity: it travels as text
      std::isfinite(value.number) ? json.value(value.number) : json.value(text_of(value.number));
      break;
    case ParamType::kInt64:
      json.value(value.integer);
      break;
    case ParamType::kBool:
      json.value(value.flag);
      break;
    case ParamType::kString:
    case ParamType::kChoice:
      json.value(value.text);
      break;
    case ParamType::kDoubles:
      json.begin_array();
      for (const double number : value.numbers) json.value(number);
      json.end_array();
  }
}

void set_from_json(ParamSet& set, const JsonValue& value) {
  using Kind = JsonValue::Kind;
  const std::string& name = value.name;
  switch (value.kind) {
    case Kind::kBool:
      return set.set_bool(name, value.flag);
    case Kind::kInteger:
      return set.set_integer(name, value.integer);
    case Kind::kNumber:
      return set.set_number(name, value.number);
    case Kind::kArray: {
      std::vector<double> numbers;
      for (const JsonValue& element : JsonChildren(value)) {
        if (!element.is_number())
          fail(Status::kInvalidArgument,
               "parameter \"%.100s\": every array element must be a number", name.c_str());
        numbers.push_back(element.number);
      }
      return set.set_numbers(name, numbers);
    }
    case Kind::kText: {
      double number = 0;
      if (set.rows()[set.index_of(name)].type == ParamType::kDouble &&
          parse_number(value.text, number))
        return set.set_number(name, number);
      return set.set_text(name, value.text);
    }
    case Kind::kNull:
    case Kind::kObject:
      break;
  }
  fail(Status::kInvalidArgument, "parameter \"%.100s\": a JSON value of this kind is not accepted",
       name.c_str());
}

}  // namespace

size_t choice_place(const ParamRow& row, std::string_view choice) {
  std::string_view rest = row.choices;
  for (size_t place = 0;; ++place) {
    const size_t end = std::min(rest.find('|'), rest.size());
    if (rest.substr(0, end) == choice) return place;
    if (end == rest.size()) return place + 1;
    rest.remove_prefix(end + 1);
  }
}

std::string choice_at(const ParamRow& row, size_t place) {
  std::string_view rest = row.choices;
  for (;; --place) {
    const size_t end = std::min(rest.find('|'), rest.size());
    if (place == 0) return std::string(rest.substr(0, end));
    if (end == rest.size()) return "";
    rest.remove_prefix(end + 1);
  }
}

ParamSet::ParamSet(const char* owner, std::span<const ParamRow> rows) : owner_(owner), rows_(rows) {
  reset();
}

void ParamSet::reset() {
  std::vector<Value> values;
  values.reserve(rows_.size());
  for (const auto& row : rows_) values.push_back(row.initial(row));
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
  values_[i].number = value;
}

void ParamSet::set_integer(std::string_view name, int64_t value) {
  const size_t i = index_of(name);
  const ParamRow& row = rows_[i];
  if (row.type != ParamType::kInt64 && row.type != ParamType::kDouble)
    wrong_type(row, "an integer");
  check_range(row, static_cast<double>(value));
  if (row.type == ParamType::kDouble) values_[i].number = static_cast<double>(value);
  else values_[i].integer = value;
}

void ParamSet::set_bool(std::string_view name, bool value) {
  const size_t i = index_of(name);
  if (rows_[i].type != ParamType::kBool) wrong_type(rows_[i], "true or false");
  values_[i].flag = value;
}

void ParamSet::set_text(std::string_view name, std::string_view value) {
  const size_t i = index_of(name);
  const ParamRow& row = rows_[i];
  if (row.type != ParamType::kString && row.type != ParamType::kChoice) wrong_type(row, "a text");
  if (row.type == ParamType::kChoice && choice_at(row, choice_place(row, value)).empty())
    fail(Status::kInvalidArgument, "parameter \"%s\" = \"%.*s\" is none of %s", row.name,
         static_cast<int>(std::min<size_t>(value.size(), 100)), value.data(), row.choices);
  values_[i].text = std::string(value);
}

void ParamSet::set_numbers(std::string_view name, std::span<const double> values) {
  const size_t i = index_of(name);
  const ParamRow& row = rows_[i];
  if (row.type != ParamType::kDoubles) wrong_type(row, "an array of numbers");
  for (double value : values) check_range(row, value);
  values_[i].numbers = std::vector<double>(values.begin(), values.end());
}

const ParamSet::Value& ParamSet::typed(std::string_view name, ParamType type) const {
  const size_t i = index_of(name);
  const bool both_text = (type == ParamType::kString && rows_[i].type == ParamType::kChoice);
  if (rows_[i].type != type && !both_text) wrong_type(rows_[i], type_name(type));
  return values_[i];
}

double ParamSet::number(std::string_view name) const {
  return typed(name, ParamType::kDouble).number;
}
int64_t ParamSet::integer(std::string_view name) const {
  return typed(name, ParamType::kInt64).integer;
}
bool ParamSet::flag(std::string_view name) const { return typed(name, ParamType::kBool).flag; }
const std::string& ParamSet::text(std::string_view name) const {
  return typed(name, ParamType::kString).text;
}
const std::vector<double>& ParamSet::numbers(std::string_view name) const {
  return typed(name, ParamType::kDoubles).numbers;
}

std::string ParamSet::to_json() const {
  JsonWriter json;
  json.begin_object();
  for (size_t i = 0; i < rows_.size(); ++i) {
    json.name(rows_[i].name);
    write_value(json, rows_[i].type, values_[i]);
  }
  return json.end_object().take();
}

void ParamSet::from_json(std::string_view json) {
  const std::vector<JsonValue> values = read_json(json);
  if (values[0].kind != JsonValue::Kind::kObject)
    fail(Status::kInvalidArgument, "the parameters are not one JSON object");
  ParamSet trial = *this;
  for (const JsonValue& value : JsonChildren(values[0])) set_from_json(trial, value);
  values_.swap(trial.values_);
}

void ParamSet::load_into(void* settings, const char* tag) const {
  for (size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].settings != tag)
      fail(Status::kInternal, "parameter \"%s\" belongs to other settings", rows_[i].name);
    rows_[i].load(rows_[i], values_[i], settings);
  }
}

std::string settings_json(std::span<const ParamRow> rows, const void* settings, const char* tag) {
  JsonWriter json;
  json.begin_object();
  for (const ParamRow& row : rows) {
    if (row.settings != tag)
      fail(Status::kInternal, "parameter \"%s\" belongs to other settings", row.name);
    json.name(row.name);
    write_value(json, row.type, row.save(row, settings));
  }
  return json.end_object().take();
}

std::string ParamSet::default_text(size_t i) const {
  JsonWriter json;
  write_value(json, rows_[i].type, rows_[i].initial(rows_[i]));
  return json.take();
}

}  // namespace jalon
