// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/schema.h"

#include <cmath>
#include <limits>

#include "base/json_reader.h"
#include "formats/files/endian.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

template <class T>
ColumnPtr column_of(const char* name, uint32_t components, std::vector<T> values) {
  return make_column<T>({name, ElementType::kUint8, components, "", ""}, values);
}

Cloud four_points() {
  Buffer<double> xyz(12);
  const double at[] = {10, 20, 30, 11.5, 20.25, 30, 12, 20, 31.00004, 10, 22, 30};
  for (size_t i = 0; i < 12; ++i) xyz[i] = at[i];
  Cloud cloud = make_cloud(std::move(xyz));
  cloud.fields.set(column_of<uint8_t>("classification", 1, {2, 6, 2, 2}));
  cloud.fields.set(column_of<float>("normal", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1}));
  cloud.fields.set(
      column_of<double>("distance", 1, {0.5, std::numeric_limits<double>::quiet_NaN(), -1.5, 1}));
  cloud.fields.set(column_of<int16_t>("X", 2, {1, 2, 3, 4, 5, 6, 7, 8}));
  return cloud;
}

const JsonValue& row(const std::vector<JsonValue>& json, const char* name) {
  for (const JsonValue& child : JsonChildren(json.front()))
    if (find_member(child, "name")->text == name) return child;
  FAIL("no dimension ", name);
  return json.front();
}

double number(const JsonValue& object, const char* name) {
  const JsonValue* member = find_member(object, name);
  return member == nullptr ? std::nan("") : member->number;
}

}  // namespace

TEST_CASE("ept_schema__dimensions_have_the_names_that_readers_know_and_follow_one_another") {
  Task task;
  const ept::Schema schema = ept::make_schema(four_points(), "ept.json", {}, task);
  std::string names;
  size_t end = 12;
  for (const ept::Dimension& dimension : schema.dimensions) {
    names += dimension.name + " ";
    CHECK(dimension.offset == end);
    end += size_of(dimension.column->info().type);
  }
  CHECK(names == "Classification NormalX NormalY NormalZ distance X_0 X_1 ");
  CHECK(schema.record_bytes == end);
  CHECK(schema.station.empty());
}

TEST_CASE("ept_schema__records_hold_the_chosen_points_in_steps_and_their_fields") {
  Task task;
  const Cloud cloud = four_points();
  WriteSettings settings;
  settings.scale = 0.001;
  const ept::Schema schema = ept::make_schema(cloud, "ept.json", settings, task);
  const uint32_t points[] = {2, 1};
  std::vector<std::byte> bytes(2 * schema.record_bytes);
  ept::put_records(schema, cloud, points, bytes.data());
  const std::byte* second = bytes.data() + schema.record_bytes;
  CHECK(load<int32_t>(bytes.data()) * 0.001 + schema.steps.offset.x == doctest::Approx(12));
  CHECK(std::fabs(load<int32_t>(bytes.data() + 8) * 0.001 + schema.steps.offset.z - 31.00004) <=
        0.0005);
  CHECK(load<int32_t>(second + 4) * 0.001 + schema.steps.offset.y == doctest::Approx(20.25));
  CHECK(load<uint8_t>(second + 12) == 6);
  CHECK(load<float>(bytes.data() + 21) == 1);  // NormalZ
  CHECK(load<double>(bytes.data() + 25) == -1.5);
  CHECK(std::isnan(load<double>(second + 25)));
  CHECK(load<int16_t>(second + 35) == 4);
}

TEST_CASE("ept_schema__statistics_are_of_finite_values_and_classes_are_counted") {
  Task task;
  const ept::Schema schema = ept::make_schema(four_points(), "ept.json", {}, task);
  JsonWriter writer;
  ept::add_schema(schema, writer, task);
  const std::vector<JsonValue> json = read_json(writer.take());
  const JsonValue& distance = row(json, "distance");
  CHECK(find_member(distance, "type")->text == "float");
  CHECK(number(distance, "size") == 8);
  CHECK(number(distance, "count") == 3);
  CHECK(number(distance, "minimum") == -1.5);
  CHECK(number(distance, "maximum") == 1);
  CHECK(number(distance, "mean") == 0);
  CHECK(number(distance, "variance") == doctest::Approx((0.25 + 2.25 + 1) / 3));
  CHECK(find_member(row(json, "X_1"), "type")->text == "signed");
  const JsonValue& x = row(json, "X");
  CHECK(number(x, "scale") == 0.0001);
  CHECK(number(x, "offset") == 11);
  const JsonValue* counts = find_member(row(json, "Classification"), "counts");
  REQUIRE(counts != nullptr);
  std::string text;
  for (const JsonValue& one : JsonChildren(*counts))
    text += std::to_string(find_member(one, "value")->integer) + ":" +
            std::to_string(find_member(one, "count")->integer) + " ";
  CHECK(text == "2:3 6:1 ");
}
