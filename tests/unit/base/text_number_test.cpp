// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/text_number.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "base/random.h"

using namespace jalon;

namespace {

bool is_number(std::string_view text) {
  double unused = 0;
  return parse_number(text, unused);
}

bool is_integer(std::string_view text) {
  int64_t unused = 0;
  return parse_integer(text, unused);
}

}  // namespace

TEST_CASE("text_of__any_bits_of_a_double__read_back_the_same") {
  RandomStream random(3, 1);
  for (int i = 0; i < 20000; ++i) {
    const auto bits = random.below(~uint64_t{0});
    const auto value = std::bit_cast<double>(bits);
    double back = 0;
    REQUIRE(parse_number(text_of(value), back));
    if (std::isnan(value)) CHECK(std::isnan(back));
    else CHECK(std::bit_cast<uint64_t>(back) == bits);
  }
  CHECK(text_of(0.1) == "0.1");  // the shortest, not 0.1000000000000000055
}

TEST_CASE("text_of__decimals__fixed_notation_without_negative_zero") {
  CHECK(text_of(2.0 / 3, 3) == "0.667");
  CHECK(text_of(1e14, 0) == "100000000000000");
  CHECK(text_of(-0.004, 2) == "0.00");
  CHECK(text_of(-0.006, 2) == "-0.01");
  CHECK(text_of(-0.0, 0) == "0");
  CHECK(text_of(-10.0, 1) == "-10.0");  // zeros behind a digit keep their sign
  double back = 0;
  for (const double large : {1e300, -1e300, std::numeric_limits<double>::infinity()}) {
    REQUIRE(parse_number(text_of(large, 3), back));
    CHECK(back == large);
  }
}

TEST_CASE("parse_number__the_whole_text_or_nothing") {
  double value = 0;
  REQUIRE(parse_number("+1.5e-3", value));
  CHECK(value == 0.0015);
  REQUIRE(parse_number("-inf", value));
  CHECK(value == -std::numeric_limits<double>::infinity());
  REQUIRE(parse_number("nan", value));
  CHECK(std::isnan(value));
  for (const char* text : {"", "+", "-", " 1", "1 ", "1,5", "1.5m", "0x10", "--1", "1e"})
    CHECK_MESSAGE(!is_number(text), text);
}

TEST_CASE("parse_integer__all_64_bits_and_no_fractions") {
  int64_t value = 0;
  for (const int64_t limit :
       {std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()}) {
    REQUIRE(parse_integer(std::to_string(limit), value));
    CHECK(value == limit);
  }
  REQUIRE(parse_integer("+42", value));
  CHECK(value == 42);
  for (const char* text : {"", "+", "9223372036854775808", "1.0", "1e3", " 7", "7 "})
    CHECK_MESSAGE(!is_integer(text), text);
}
