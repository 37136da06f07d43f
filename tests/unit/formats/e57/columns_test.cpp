// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Which field becomes which column: those of the standard only where it allows their values.
#include "formats/e57/columns.h"

#include <doctest/doctest.h>

#include <string>

#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

template <class T>
void set_field(Cloud& cloud, const char* name, const std::vector<T>& values) {
  cloud.fields.set(make_column<T>({name}, values));
}

std::string names_of(const Cloud& cloud) {
  Task task;
  std::string text;
  for (const e57::OutColumn& column : e57::columns_of(cloud, task).fields)
    text += std::string(text.empty() ? "" : " ") + column.column.name;
  return text;
}

}  // namespace

TEST_CASE("e57_columns__fields_of_the_standard_stand_first_and_others_under_our_name") {
  Cloud cloud = random_points(2, 1);
  set_field<int32_t>(cloud, "label", {1, -1});
  set_field<float>(cloud, "intensity", {0.5f, std::nanf("")});
  set_field<uint32_t>(cloud, "row", {0, 3});
  set_field<uint8_t>(cloud, "return_number", {1, 2});
  set_field<uint8_t>(cloud, "number_of_returns", {1, 2});
  set_field<double>(cloud, "time", {0, 2.5});
  CHECK(names_of(cloud) ==
        "intensity isIntensityInvalid rowIndex returnIndex returnCount timeStamp jalon:label");
  Task task;
  for (const e57::OutColumn& column : e57::columns_of(cloud, task).fields) {
    if (std::string(column.column.name) == "returnIndex") CHECK(column.shift == -1);
    if (std::string(column.column.name) == "rowIndex") CHECK(column.column.max == 3);
  }
}

TEST_CASE("e57_columns__values_that_the_standard_refuses_stay_fields_of_our_own") {
  Cloud cloud = random_points(2, 1);
  set_field<uint8_t>(cloud, "return_number", {0, 2});
  set_field<uint8_t>(cloud, "number_of_returns", {1, 2});
  set_field<double>(cloud, "time", {-1, 2});
  set_field<uint16_t>(cloud, "red", {1, 2});
  set_field<int32_t>(cloud, "column", {-1, 2});
  CHECK(names_of(cloud) ==
        "jalon:return_number jalon:number_of_returns jalon:time jalon:red jalon:column");
}

TEST_CASE("e57_columns__names_become_xml_names_each_once") {
  Cloud cloud = random_points(1, 1);
  for (const char* name : {"a b", "a.b", "1st", "XMLish", "é"}) set_field<float>(cloud, name, {1});
  CHECK(names_of(cloud) == "jalon:a_b jalon:a_b_2 jalon:_1st jalon:_XMLish jalon:__");
}

TEST_CASE("e57_columns__integers_beyond_a_double_are_left_out") {
  Cloud cloud = random_points(1, 1);
  set_field<uint64_t>(cloud, "huge", {uint64_t{1} << 60});
  set_field<int64_t>(cloud, "large", {-(int64_t{1} << 50)});
  CHECK(names_of(cloud) == "jalon:large");
}
