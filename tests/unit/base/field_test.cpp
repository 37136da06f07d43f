// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/field.h"
#include "base/text_number.h"

using namespace jalon;

TEST_CASE("a field table finds, replaces and removes columns by name") {
  FieldTable table;
  const std::array<float, 3> a{1, 2, 3};
  const std::array<int32_t, 3> b{4, 5, 6};
  table.set(make_column<float>({"a"}, a));
  table.set(make_column<int32_t>({"b"}, b));
  FieldTable copy = table;
  table.set(make_column<int32_t>({"a"}, b));
  CHECK(table.size() == 2);
  CHECK(table.require("a").info().type == ElementType::kInt32);
  CHECK(copy.require("a").info().type == ElementType::kFloat32);  // the copy keeps what it had
  CHECK(table.remove("a"));
  CHECK_FALSE(table.remove("a"));
  CHECK_THROWS_AS(table.require("a"), Error);
}

TEST_CASE("values convert between all types when they fit, and are refused when not") {
  const double wide[] = {0, 127, -128, 1e3};
  Column narrow({"n", ElementType::kInt8}, 4);
  store_converted(narrow, 0, wide, ElementType::kFloat64, 3, sizeof(double));
  CHECK(narrow.values<int8_t>()[1] == 127);
  CHECK(narrow.values<int8_t>()[2] == -128);
  CHECK_THROWS_AS(store_converted(narrow, 3, wide + 3, ElementType::kFloat64, 1, sizeof(double)),
                  Error);
  const double nan[] = {std::nan("")};
  CHECK_THROWS_AS(store_converted(narrow, 3, nan, ElementType::kFloat64, 1, sizeof(double)), Error);
  const double edge[] = {0x1p63, -0x1p63, 0x1.fffffffffffffp62};
  Column wide_column({"w", ElementType::kInt64}, 3);
  CHECK_THROWS_AS(store_converted(wide_column, 0, edge, ElementType::kFloat64, 1, 8), Error);
  store_converted(wide_column, 1, edge + 1, ElementType::kFloat64, 2, 8);
  CHECK(wide_column.values<int64_t>()[1] == std::numeric_limits<int64_t>::min());
  const uint64_t big[] = {std::numeric_limits<uint64_t>::max()};
  CHECK_THROWS_AS(store_converted(wide_column, 0, big, ElementType::kUint64, 1, 8), Error);
}

TEST_CASE("strided, unaligned input is read as it lies") {
  alignas(8) unsigned char bytes[3 + 2 * 13] = {};
  for (int i = 0; i < 2; ++i) {
    const float xyz[] = {1.5f + static_cast<float>(i), 2.5f, -3.5f};
    std::copy_n(reinterpret_cast<const unsigned char*>(xyz), 12, bytes + 3 + 13 * i);
  }
  Column out({"xyz", ElementType::kFloat64, 3}, 2);
  store_converted(out, 0, bytes + 3, ElementType::kFloat32, 2, 13);
  CHECK(out.number(1, 0) == 2.5);
  CHECK(out.number(1, 2) == -3.5);
}

TEST_CASE("numbers go to text and back without locale") {
  for (const double v : {0.1, 1e300, -2.5e-308, 6861000.123456789, 1.0 / 3}) {
    double back = 0;
    REQUIRE(parse_number(text_of(v), back));
    CHECK(back == v);
  }
  CHECK(text_of(-0.0001, 2) == "0.00");
  CHECK(text_of(1234.5678, 3) == "1234.568");
  CHECK(text_of(std::numeric_limits<double>::infinity(), 3) == "inf");
  double v = 0;
  CHECK_FALSE(parse_number("1,5", v));
  CHECK_FALSE(parse_number("", v));
  CHECK_FALSE(parse_number("1.5 ", v));
  CHECK(parse_number("+1.5", v));
}
