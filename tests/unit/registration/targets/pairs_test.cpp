// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/pairs.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"

using namespace jalon;

namespace {

Status refusal(const std::vector<Target>& targets) {
  try {
    require_distinct(targets, "moving");
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

}  // namespace

TEST_CASE("target_pairs__by_name_come_in_the_order_of_the_moving_ones") {
  const std::vector<Target> reference = {{"A", {}, {}}, {"", {}, {}}, {"B", {}, {}}, {"C", {}, {}}};
  const std::vector<Target> moving = {{"C", {}, {}}, {"", {}, {}}, {"X", {}, {}}, {"A", {}, {}}};
  CHECK(pairs_by_name(reference, moving) == std::vector<IndexPair>{{3, 0}, {0, 3}});
  CHECK(pairs_by_name(reference, {}).empty());
}

TEST_CASE("target_pairs__are_relative_to_whole_metres_and_have_a_covariance_each") {
  std::vector<Target> reference = {{"A", {652000.5, 6861000.25, -3.75}, {}}};
  std::vector<Target> moving = {{"A", {1, 2, 3}, {4, 1, 0, 1, 5, 0, 0, 0, 6}}};
  CHECK(origin_of(reference) == Vec3{652000, 6861000, -4});
  CHECK(origin_of({}) == Vec3{});
  const auto pairs = measured_pairs(reference, moving, std::vector<IndexPair>{{0, 0}},
                                    origin_of(reference), {1, 1, 1}, 0.5);
  REQUIRE(pairs.size() == 1);
  CHECK(pairs[0].reference == Vec3{0.5, 0.25, 0.25});
  CHECK(pairs[0].moving == Vec3{0, 1, 2});
  CHECK(pairs[0].reference_covariance == Square<3>{0.25, 0, 0, 0, 0.25, 0, 0, 0, 0.25});
  CHECK(pairs[0].moving_covariance == Square<3>{4, 1, 0, 1, 5, 0, 0, 0, 6});
}

TEST_CASE("target_pairs__two_of_a_name_or_at_a_place_are_refused_but_not_two_without_a_name") {
  CHECK(refusal({{"A", {0, 0, 0}, {}}, {"A", {1, 0, 0}, {}}}) == Status::kInvalidArgument);
  CHECK(refusal({{"", {0, 0, 0}, {}}, {"", {1, 0, 0}, {}}}) == Status::kOk);
  CHECK(refusal({{"A", {0, 0, 0}, {}}, {"C", {9, 9, 9}, {}}, {"B", {0, 0, 5e-5}, {}}}) ==
        Status::kInvalidArgument);
  CHECK(refusal({{"A", {0, 0, 0}, {}}, {"B", {0, 0, 2e-4}, {}}}) == Status::kOk);
  CHECK(refusal({{"A", {0, std::nan(""), 0}, {}}}) == Status::kInvalidArgument);
}

TEST_CASE("target_pairs__a_covariance_is_symmetric_and_has_no_negative_variance") {
  const auto with = [](const std::array<double, 9>& c) { return refusal({{"A", {}, c}}); };
  CHECK(with({1, 0.5, 0, 0.5, 1, 0, 0, 0, 1}) == Status::kOk);
  CHECK(with({1, 1, 0, 1, 1, 0, 0, 0, 0}) == Status::kOk);  // known in two directions
  CHECK(with({1, 0.5, 0, 0.4, 1, 0, 0, 0, 1}) == Status::kInvalidArgument);
  CHECK(with({1, 2, 0, 2, 1, 0, 0, 0, 1}) == Status::kInvalidArgument);
  CHECK(with({-1, 0, 0, 0, 1, 0, 0, 0, 1}) == Status::kInvalidArgument);
}
