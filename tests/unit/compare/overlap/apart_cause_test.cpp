// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/overlap/apart_cause.h"

#include <doctest/doctest.h>

#include "unit/compare/overlap/overlap_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

template <class F>
CloudsOverlap hall_and(F&& moved) {
  Task task;
  const CloudsOverlap found =
      clouds_overlap(cloud_by(hall_points(1)), cloud_by(hall_points(2), moved), task);
  CHECK(found.is_apart);
  return found;
}

}  // namespace

TEST_CASE("find_cause__tells_which_axes_are_swapped_or_turned_round") {
  const CloudsOverlap swapped = hall_and([](const Vec3& p) { return Vec3{p.y, p.x, p.z}; });
  CHECK(swapped.cause == ApartCause::kAxes);
  CHECK(swapped.axes == std::array<int8_t, 3>{2, 1, 3});
  const CloudsOverlap y_up = hall_and([](const Vec3& p) { return Vec3{p.x, p.z, -p.y}; });
  CHECK(y_up.cause == ApartCause::kAxes);
  CHECK(y_up.axes == std::array<int8_t, 3>{1, -3, 2});
}

TEST_CASE("find_cause__tells_the_unit_with_one_origin_or_another") {
  const CloudsOverlap feet = hall_and([](const Vec3& p) { return p / 0.3048; });
  CHECK(feet.cause == ApartCause::kUnit);
  CHECK(feet.factor == doctest::Approx(0.3048).epsilon(1e-4).scale(0));
  const CloudsOverlap millimetres = hall_and([](const Vec3& p) { return p * 1000; });
  CHECK(millimetres.cause == ApartCause::kUnit);
  CHECK(millimetres.factor == doctest::Approx(0.001).scale(0));
  const CloudsOverlap moved = hall_and([](const Vec3& p) { return p * 1000 + Vec3{-7e5, 4e6, 0}; });
  CHECK(moved.cause == ApartCause::kUnit);
  CHECK(moved.factor == doctest::Approx(0.001).scale(0));
}

TEST_CASE("find_cause__of_clouds_that_share_a_place_tells_what_would_make_them_share_more") {
  const auto about_origin = [](const Vec3& p) { return p - Vec3{30, 50, 2}; };
  Task task;
  const auto found = [&](auto&& moved) {
    const CloudsOverlap out = clouds_overlap(
        cloud_by(hall_points(1), about_origin),
        cloud_by(hall_points(2), [&](const Vec3& p) { return moved(about_origin(p)); }), task);
    CHECK_FALSE(out.is_apart);
    return out;
  };
  const CloudsOverlap feet = found([](const Vec3& p) { return p / 0.3048; });
  CHECK(feet.cause == ApartCause::kUnit);
  CHECK(feet.factor == doctest::Approx(0.3048).epsilon(1e-4).scale(0));
  const CloudsOverlap swapped = found([](const Vec3& p) { return Vec3{p.y, p.z, p.x}; });
  CHECK(swapped.cause == ApartCause::kAxes);
  CHECK(swapped.axes == std::array<int8_t, 3>{3, 1, 2});
}

TEST_CASE("find_cause__claims_none_of_scans_that_overlap_in_part") {
  Task task;
  std::vector<Vec3> near_end, far_end;
  for (const Vec3& p : hall_points(3, 60000)) {
    if (p.x < 41) near_end.push_back(p);
    if (p.x > 38) far_end.push_back(p);
  }
  for (const Vec3& origin : {Vec3{}, Vec3{30, 50, 2}, Vec3{39.5, 54, 4}}) {
    const auto moved = [&](const Vec3& p) { return p - origin; };
    CHECK(clouds_overlap(cloud_by(near_end, moved), cloud_by(far_end, moved), task).cause ==
          ApartCause::kUnknown);
  }
}

TEST_CASE("find_cause__tells_another_origin_by_the_same_extent") {
  const CloudsOverlap found = hall_and([](const Vec3& p) { return p + Vec3{652000, 6862000, 35}; });
  CHECK(found.cause == ApartCause::kOrigin);
  CHECK(norm(found.shift - Vec3{-652000, -6862000, -35}) < 0.1);
}

TEST_CASE("find_cause__tells_degrees_beside_a_grid") {
  Task task;
  const auto grid = [](const Vec3& p) { return p + Vec3{652000, 6862000, 0}; };
  const auto degrees = [](const Vec3& p) {
    return Vec3{2.35 + p.x / 73000, 48.86 + p.y / 111000, p.z};
  };
  CHECK(clouds_overlap(cloud_by(hall_points(1), grid), cloud_by(hall_points(2), degrees), task)
            .cause == ApartCause::kDegrees);
}

TEST_CASE("find_cause__claims_none_for_different_things") {
  const CloudsOverlap found = hall_and([](const Vec3& p) {
    return Vec3{0.3 * p.x + 200, 2.1 * p.y + 0.4 * p.x, 1.7 * p.z};
  });
  CHECK(found.cause == ApartCause::kUnknown);
}
