// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The reference points that compared points are nearest to, against a search through all pairs.
#include "compare/distance/closest_points.h"

#include <doctest/doctest.h>

#include "unit/compare/distance_fixture.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// The reference with its row numbers as a field.
Cloud numbered(const Cloud& reference) {
  std::vector<uint32_t> rows(reference.size());
  for (uint32_t i = 0; i < rows.size(); ++i) rows[i] = i;
  Cloud out = reference;
  out.fields.set(make_column<uint32_t>({"row", ElementType::kUint32, 1, "", ""}, rows));
  return out;
}

}  // namespace

TEST_CASE("closest_points__are_those_of_brute_force_once_each_in_order_with_their_fields") {
  const auto reference = cloud_of(random_square(400, 10, 0, 1, 0.1)),
             other = cloud_of(random_square(300, 12, 0.2, 2, 0.1));
  DistanceSettings settings;
  settings.max_distance_m = 0.5;  // some find nothing
  std::vector<uint32_t> expected;
  for (uint32_t r = 0; r < reference->size(); ++r) {
    bool wanted = false;
    for (size_t i = 0; i < other->size() && !wanted; ++i) {
      const double d2 = squared_norm(other->point(i) - reference->point(r));
      bool is_nearest = d2 <= 0.25;
      for (size_t k = 0; k < reference->size() && is_nearest; ++k)
        is_nearest = d2 <= squared_norm(other->point(i) - reference->point(k));
      wanted = is_nearest;
    }
    if (wanted) expected.push_back(r);
  }
  Task task;
  const Comparison made = compared(reference, other, settings);
  REQUIRE(summary(made, "nothing_near") > 0);
  const Cloud found = closest_points(made, numbered(*reference), task);
  REQUIRE(found.size() == expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    REQUIRE(found.fields.require("row").number(i) == expected[i]);
    REQUIRE(found.point(i) == reference->point(expected[i]));
  }
}

TEST_CASE("closest_points__of_nothing_near_are_none_and_another_reference_is_refused") {
  const auto reference = cloud_of({0, 0, 0, 9, 0, 0, 18, 0, 0}), other = cloud_of({17, 0, 0});
  DistanceSettings settings;
  settings.max_distance_m = 0.5;
  Task task;
  CHECK(closest_points(compared(reference, other, settings), *reference, task).size() == 0);
  const Comparison made = compared(reference, other);
  CHECK(closest_points(made, *reference, task).point(0) == Vec3{18, 0, 0});
  CHECK(refuses(
      [&] {
        closest_points(made, *cloud_of({0, 0, 0, 9, 0, 0}), task);
      },
      Status::kInvalidArgument, "point 2 of 2"));
}
