// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/tables.h"

#include <doctest/doctest.h>

#include <cstring>

namespace jalon {
namespace {

Buffer<uint8_t> bytes_of_table(const FieldTable& table, Task& task) {
  ByteWriter writer;
  write_table(writer, table);
  return writer.sealed(BytesKind::kFields, task);
}

template <class F>
std::string refusal_of_table(const FieldTable& table, F&& use) {
  Task task;
  const Buffer<uint8_t> whole = bytes_of_table(table, task);
  try {
    ByteReader reader({whole.data(), whole.size()}, BytesKind::kFields, task);
    use(reader, read_table(reader, task));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

ColumnPtr column_of(const char* name, std::vector<float> values, uint32_t components = 1) {
  return make_column<float>({name, ElementType::kFloat32, components, "m", "what it means"},
                            values);
}

TEST_CASE("tables__keep_names_units_meanings_and_bits") {
  FieldTable table;
  table.set(column_of("a", {1, 2, 3, 4, 5, 6}, 3));
  table.set(column_of("b", {-0.0f, 7}));
  CHECK(refusal_of_table(table, [&](ByteReader& reader, const FieldTable& back) {
          reader.end();
          REQUIRE(back.size() == 2);
          CHECK(back.at(0)->info().components == 3);
          CHECK(back.at(1)->info().unit == "m");
          CHECK(back.at(1)->info().meaning == "what it means");
          for (size_t i = 0; i < 2; ++i)
            CHECK(std::memcmp(back.at(i)->raw(), table.at(i)->raw(), table.at(i)->bytes()) == 0);
        }) == "");
}

TEST_CASE("tables__refuse_two_columns_of_a_name_or_of_two_lengths") {
  FieldTable twins, lengths;
  twins.add(column_of("a", {1}));
  twins.add(column_of("a", {2}));
  lengths.add(column_of("a", {1}));
  lengths.add(column_of("b", {2, 3}));
  const auto nothing = [](const ByteReader&, const FieldTable&) {};
  CHECK(refusal_of_table(twins, nothing).find("two columns are named \"a\"") != std::string::npos);
  CHECK(refusal_of_table(lengths, nothing).find("\"b\" has 2 rows, the first one 1") !=
        std::string::npos);
}

TEST_CASE("tables__of_other_columns_than_code_reads_are_refused") {
  FieldTable table;
  table.set(column_of("a", {1, 2}));
  const auto held = [&](KnownColumn known) {
    return refusal_of_table(table, [&](const ByteReader& reader, const FieldTable& back) {
      require_known(reader, back, std::span(&known, 1));
    });
  };
  CHECK(held({"a", ElementType::kFloat32, 1, true}) == "");
  CHECK(held({"b", ElementType::kFloat32}) == "");
  CHECK(held({"b", ElementType::kFloat32, 1, true}).find("no column \"b\"") != std::string::npos);
  CHECK(held({"a", ElementType::kFloat64}).find("float32 x 1, not of float64 x 1") !=
        std::string::npos);
  CHECK(held({"a", ElementType::kFloat32, 3}) != "");
  CHECK(refusal_of_table(table, [](const ByteReader& reader, const FieldTable& back) {
          require_rows(reader, back, "fields", 3);
        }).find("the fields have 2 rows where there must be 3") != std::string::npos);
}

}  // namespace
}  // namespace jalon
