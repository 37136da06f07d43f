// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Where fields go in a LAS record: against the bits of ASPRS LAS 1.4 R15, and by what a layout must keep.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "formats/files/utf8.h"
#include "formats/las/plan.h"
#include "unit/formats/las/las_bytes.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

template <class T>
ColumnPtr single(const std::string& name, T value) {
  const T values[] = {value};
  return make_column<T>({name}, values);
}

// True when a standard dimension of the format takes the field, and all of it.
template <class T>
bool is_standard(unsigned format, const std::string& name, T value) {
  FieldTable fields;
  fields.set(single(name, value));
  std::vector<ColumnPtr> left;
  Task task;
  const bool placed = !las::standard_columns(fields, format, left, task).empty();
  CHECK((placed || left.size() == 1));
  return placed && left.empty();
}

ColumnPtr empty_column(const std::string& name, ElementType type, uint32_t components) {
  return std::make_shared<Column>(FieldInfo{name, type, components, "", ""}, 0);
}

std::vector<las::ExtraColumn> laid_out(const std::vector<ColumnPtr>& fields,
                                       const std::vector<las::ExtraDimension>& known = {}) {
  Task task;
  return las::extra_columns(fields, known, 0, task);
}

// Names in the descriptors, in the order of the file.
std::vector<std::string> names_in(const std::vector<las::ExtraColumn>& columns) {
  std::vector<std::string> names;
  for (const las::ExtraColumn& column : columns)
    for (size_t at = 0; at < column.descriptor.size(); at += las::kDescriptorBytes)
      names.push_back(text_field(column.descriptor.data() + at + 4, 32));
  return names;
}

}  // namespace

TEST_CASE("las_columns__a_field_is_standard_up_to_the_greatest_number_of_its_bits") {
  constexpr struct {
    const char* name;
    int old_max, new_max;  // of formats 0-5 and 6-10; 0: not there
  } kRows[] = {{"intensity", 65535, 65535},
               {"return_number", 7, 15},
               {"number_of_returns", 7, 15},
               {"scan_direction", 1, 1},
               {"classification", 31, 255},
               {"withheld", 1, 1},
               {"overlap", 0, 1},
               {"scanner_channel", 0, 3},
               {"user_data", 255, 255},
               {"point_source_id", 65535, 65535}};
  for (const auto& row : kRows)
    for (const unsigned format : {0u, 6u}) {
      const int max = format == 0 ? row.old_max : row.new_max;
      CAPTURE(row.name);
      CAPTURE(format);
      CHECK(is_standard(format, row.name, int32_t{max}) == (max != 0));
      CHECK(is_standard(format, row.name, double(max)) == (max != 0));
      CHECK_FALSE(is_standard(format, row.name, int32_t{max + 1}));
      CHECK_FALSE(is_standard(format, row.name, int32_t{-1}));
      CHECK_FALSE(is_standard(format, row.name, 0.5));
      CHECK_FALSE(is_standard(format, row.name, std::nan("")));
      CHECK_FALSE(is_standard(format, row.name, -0.0));  // its sign would be lost
    }
  CHECK(is_standard(1, "gps_time", std::nan("")));  // a double as it is
  CHECK_FALSE(is_standard(1, "gps_time", int64_t{1}));
  CHECK(is_standard(0, "scan_angle", -128.0f));
  CHECK_FALSE(is_standard(0, "scan_angle", 0.006f));
  CHECK(is_standard(6, "scan_angle", 0.006f));  // steps of 0.006 degrees
  CHECK_FALSE(is_standard(6, "scan_angle", 0.005f));
  CHECK_FALSE(is_standard(0, "amplitude", uint8_t{1}));
}

TEST_CASE(
    "las_columns__angles_between_steps_are_rounded_and_kept_exactly_under_a_name_of_their_own") {
  FieldTable fields;
  fields.set(single("scan_angle", 5.0f));
  fields.set(single("intensity", 0.5f));
  std::vector<ColumnPtr> left;
  Task task;
  const auto placed = las::standard_columns(fields, 6, left, task);
  REQUIRE(placed.size() == 1);
  CHECK(placed[0].column->info().name == "scan_angle");
  REQUIRE(left.size() == 2);
  CHECK(names_in(las::extra_columns(left, {}, 6, task)) ==
        std::vector<std::string>{"scan_angle_exact", "intensity_exact"});
  fields.set(single("scan_angle", 200.0f));  // beyond what 16 bits hold
  left.clear();
  CHECK(las::standard_columns(fields, 6, left, task).empty());
  CHECK(left.size() == 2);
}

TEST_CASE("las_columns__extra_fields_lie_side_by_side_behind_the_core_and_undescribed_ones_last") {
  RandomStream random(5, 1);
  for (int round = 0; round < 50; ++round) {
    std::vector<ColumnPtr> fields{empty_column("extra_bytes", ElementType::kUint8, 3)};
    size_t bytes = 3;
    for (uint64_t f = random.below(8); f > 0; --f) {
      const auto type = static_cast<ElementType>(1 + random.below(10));
      const auto components = static_cast<uint32_t>(1 + random.below(6));
      fields.push_back(empty_column("f" + std::to_string(f), type, components));
      bytes += size_of(type) * components;
    }
    const auto columns = laid_out(fields);
    size_t at = 20;
    std::map<std::string, uint32_t> components;
    for (const las::ExtraColumn& column : columns) {
      CHECK(column.offset == at);
      CHECK(column.component == components[column.column->info().name]);
      components[column.column->info().name] += column.components;
      at += size_of(column.raw_type) * column.components;
    }
    CHECK(at == 20 + bytes);
    for (const ColumnPtr& field : fields)
      CHECK(components[field->info().name] == field->info().components);
    CHECK(columns.back().column == fields[0]);
    CHECK(columns.back().descriptor.empty());
  }
}

TEST_CASE("las_columns__names_of_32_bytes_stay_apart_and_normals_have_those_of_other_programs") {
  const std::string same(40, 'n');
  const std::string accent =
      std::string(31, 'm') + "\xC3\xA9";  // its last letter is cut in two at 32 bytes
  std::vector<ColumnPtr> fields{empty_column("normal", ElementType::kFloat32, 3),
                                empty_column(accent, ElementType::kInt8, 4)};
  for (int i = 0; i < 12; ++i)
    fields.push_back(empty_column(same + std::to_string(i), ElementType::kFloat64, 1));
  fields.push_back(empty_column("waveform", ElementType::kUint8, 255));
  const auto columns = laid_out(fields);
  const std::vector<std::string> names = names_in(columns);
  REQUIRE(names.size() ==
          3 + 4 + 12 + 1);  // more than three components are one each, but for bytes
  CHECK(names[0] == "NormalX");
  CHECK(names[2] == "NormalZ");
  CHECK(names[3] == std::string(31, 'm'));
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
  for (const std::string& name : names)
    CHECK_FALSE(has_text(name, std::string(kReplacementCharacter)));
  CHECK(columns.back().descriptor[2] == std::byte{0});
  CHECK(columns.back().descriptor[3] == std::byte{255});
}

TEST_CASE("las_columns__a_descriptor_is_kept_while_its_steps_give_the_values_back") {
  las::ExtraDimension known;
  known.field = {"h", ElementType::kFloat64, 1, "", ""};
  known.scaled = true;
  known.raw_type = ElementType::kInt16;
  known.scale[0] = 0.25;
  known.shift[0] = 10;
  known.descriptor = las::descriptor_of({"h", ElementType::kInt16, 1, "", ""}, "h");
  const auto kept = [&](double value) {
    const auto columns = laid_out({single("first", 1.0), single("h", value)}, {known});
    REQUIRE(columns.size() == 2);
    const bool as_known = columns[0].column->info().name == "h";  // known ones stand first
    CHECK(columns[as_known ? 0 : 1].scaled == as_known);
    CHECK(columns[1].offset - 20 == (as_known ? 2 : 8));
    return as_known;
  };
  CHECK(kept(10.25));
  CHECK(kept(10 - 32768 * 0.25));
  CHECK(kept(10 + 32767 * 0.25));
  CHECK_FALSE(kept(10 + 32768 * 0.25));
  CHECK_FALSE(kept(10.3));
  CHECK_FALSE(kept(std::nan("")));
  const auto other_type = laid_out({single("h", 1.0f)}, {known});
  CHECK(other_type[0].raw_type == ElementType::kFloat32);
  const Failure failure =
      failure_of([] { laid_out({empty_column("wide", ElementType::kFloat64, 8190)}); });
  CHECK(failure.status == Status::kLimit);  // 20 + 65520 bytes
  CHECK(has_text(failure.text, "65535 bytes"));
}
