// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/whole_numbers.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>

#include "base/error.h"
#include "base/numbers.h"
#include "segment/labels/key_counts.h"

using namespace jalon;

namespace {

template <class T>
std::vector<uint64_t> keys_of(const std::vector<T>& values, std::vector<double> left_out = {}) {
  const ColumnPtr column = make_column<T>({"class"}, values);
  std::vector<uint64_t> keys(values.size());
  WholeNumbers(*column, left_out).keys(0, values.size(), keys.data());
  return keys;
}

template <class T>
std::string refusal(const std::vector<T>& values, std::vector<double> left_out = {}) {
  try {
    keys_of(values, left_out);
  } catch (const Error& error) {
    CHECK(error.status() == Status::kInvalidArgument);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("whole_numbers__keys_ascend_as_the_numbers_do_and_lead_back") {
  const std::vector<int64_t> values{std::numeric_limits<int64_t>::min(),    -300, -1, 0, 1, 255,
                                    std::numeric_limits<int64_t>::max() - 1};
  const auto keys = keys_of(values);
  for (size_t i = 0; i < values.size(); ++i) {
    CHECK(WholeNumbers::value_of(keys[i]) == values[i]);
    if (i > 0) CHECK(keys[i - 1] < keys[i]);
  }
}

TEST_CASE("whole_numbers__every_element_type_gives_the_same_keys") {
  const auto expected = keys_of<int64_t>({0, 7, 100});
  CHECK(keys_of<uint8_t>({0, 7, 100}) == expected);
  CHECK(keys_of<int16_t>({0, 7, 100}) == expected);
  CHECK(keys_of<uint64_t>({0, 7, 100}) == expected);
  CHECK(keys_of<float>({0, 7, 100}) == expected);
  CHECK(keys_of<double>({-0.0, 7, 100}) == expected);
}

TEST_CASE("whole_numbers__values_given_and_NaN_are_left_out") {
  const auto keys = keys_of<double>({1, kNaN, 2, -3}, {2, -3});
  CHECK(keys[0] == WholeNumbers::key_of(1));
  for (size_t i = 1; i < 4; ++i) CHECK(keys[i] == kNoKey);
}

TEST_CASE("whole_numbers__what_is_none_is_refused_with_its_point") {
  CHECK(refusal<double>({1, 2.5}).find("point 1") != std::string::npos);
  CHECK(refusal<double>({0, 0, std::numeric_limits<double>::infinity()}).find("point 2") !=
        std::string::npos);
  CHECK(refusal<double>({0x1p53}).empty());
  CHECK_FALSE(refusal<double>({0x1p54}).empty());
  CHECK_FALSE(refusal<uint64_t>({~uint64_t{0}}).empty());
  CHECK_FALSE(refusal<int64_t>({1}, {0.5}).empty());
  const ColumnPtr pairs =
      make_column<double>({"normal", ElementType::kFloat64, 2}, std::vector<double>{1, 2});
  CHECK_THROWS_AS(WholeNumbers(*pairs, {}), Error);
}
