// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/slide.h"

#include <doctest/doctest.h>

#include "unit/registration/registration_scenes.h"
#include "unit/registration/verdict/judged_rooms.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Slide slid(const JudgedScan& reference, const JudgedScan& moving, const Vec3& way,
           const Vec3& off = {}) {
  Task task;
  Transform pose = shift_between(reference, moving);
  for (int axis = 0; axis < 3; ++axis) pose.m[static_cast<size_t>(4 * axis + 3)] += off[axis];
  return slide_along(reference.judged, moving.judged, pose, {reference.station, {}, way}, 3, task);
}

std::shared_ptr<JudgedScan> sampled_scan(const scenes::Scene& scene, uint64_t seed) {
  return judged_cloud_of(std::make_shared<const Cloud>(scenes::sampled(scene, seed)));
}

}  // namespace

TEST_CASE("slide__of_a_furnished_room_is_fixed_whichever_way") {
  const PairScene room = furnished(7, 7);
  const auto a = judged_scan(room, 0, 1), b = judged_scan(room, 1, 2);
  for (const Vec3& way : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    const Slide found = slid(*a, *b, way);
    CHECK(found.is_fixed);
    CHECK(found.better_m == 0);
  }
}

TEST_CASE("slide__of_surfaces_that_slide_on_themselves_is_open") {
  const Vec3 along{1, 0, 0};
  for (uint64_t seed = 1; seed < 11; ++seed) {
    const auto a = sampled_scan(scenes::corridor(), 2 * seed),
               b = sampled_scan(scenes::corridor(), 2 * seed + 1);
    const Slide found = slid(*a, *b, along);
    CHECK(!found.is_fixed);
    CHECK(found.better_m == 0);
    const auto c = sampled_scan(scenes::one_plane(), seed),
               d = sampled_scan(scenes::one_plane(), seed + 20);
    CHECK(!slid(*c, *d, along).is_fixed);
    CHECK(!slid(*c, *d, {0, 0, 1}).is_fixed);
  }
}

TEST_CASE("slide__finds_the_place_where_the_doors_of_a_corridor_meet") {
  const PairScene corridor = corridor_with_doors(4, 4);
  const auto a = judged_scan(corridor, 0, 1), b = judged_scan(corridor, 1, 2);
  for (const double off_m : {0.6, -0.9}) {
    const Slide found = slid(*a, *b, {1, 0, 0}, {off_m, 0, 0});
    CHECK(!found.is_fixed);
    CHECK(std::abs(found.better_m + off_m) < 0.2);  // a step of the search
  }
}
