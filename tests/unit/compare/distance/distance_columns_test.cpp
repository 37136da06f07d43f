// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The columns of method "distance": what is written through the pointers is what the table has.
#include "compare/distance/distance_columns.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace jalon;

TEST_CASE("distance_columns__give_the_table_what_is_written_in_the_order_of_the_methods") {
  const DistanceColumns columns(3, true);
  for (uint32_t i = 0; i < 3; ++i) {
    columns.distances[i] = 10 + i;
    columns.nearests[i] = 20 + i;
    columns.statuses[i] = static_cast<uint8_t>(30 + i);
    columns.set_difference(i, {40.0 + i, 50.0 + i, 60.0 + i});
  }
  FieldTable table;
  columns.attach(table);
  const std::vector<std::string> names = {"distance",     "status",       "nearest",
                                          "difference_x", "difference_y", "difference_z"};
  const double firsts[] = {10, 30, 20, 40, 50, 60};
  REQUIRE(table.size() == names.size());
  for (size_t c = 0; c < names.size(); ++c) {
    CHECK(table.at(c)->info().name == names[c]);
    CHECK(table.at(c)->count() == 3);
    for (size_t i = 0; i < 3; ++i)
      CHECK(table.at(c)->number(i) == firsts[c] + static_cast<double>(i));
  }
  CHECK(table.require("distance").info().unit == "m");
  CHECK(table.require("nearest").info().type == ElementType::kUint32);
  CHECK(table.require("status").info().type == ElementType::kUint8);
}

TEST_CASE("distance_columns__without_differences_take_none_and_have_no_columns_for_them") {
  const DistanceColumns columns(2, false);
  columns.distances[0] = columns.distances[1] = 7;
  columns.set_difference(1, {1, 2, 3});
  FieldTable table;
  columns.attach(table);
  CHECK(table.size() == 3);
  CHECK(table.find("difference_x") == nullptr);
  CHECK(table.require("distance").number(1) == 7);
}
