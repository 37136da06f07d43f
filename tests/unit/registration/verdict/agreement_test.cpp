// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/agreement.h"

#include <doctest/doctest.h>

#include "unit/registration/verdict/judged_rooms.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Agreement agree(const JudgedScan& of, const JudgedScan& with, const Vec3& off = {}) {
  Task task;
  Transform pose = shift_between(with, of);
  for (int axis = 0; axis < 3; ++axis) pose.m[static_cast<size_t>(4 * axis + 3)] += off[axis];
  return agreement_of(of.judged, with.judged, pose, task);
}

}  // namespace

TEST_CASE("agreement__of_two_scans_of_a_room_is_whole") {
  const PairScene room = furnished(7, 7);
  const auto a = judged_scan(room, 0, 1), b = judged_scan(room, 1, 2);
  for (const Agreement& found : {agree(*a, *b), agree(*b, *a)}) {
    CHECK(found.explained_share() > 0.95);
    CHECK(found.pierced_share() < 0.01);
    CHECK(found.contradicted_share() < 0.02);
    CHECK(found.near_share() > 0.5);
    CHECK(found.seen > 1000);
  }
}

TEST_CASE("agreement__is_lost_when_one_scan_is_moved") {
  const PairScene room = furnished(7, 7);
  const auto a = judged_scan(room, 0, 1), b = judged_scan(room, 1, 2);
  const Agreement found = agree(*a, *b, {0.1, 0.1, 0.1});
  CHECK(found.explained_share() < 0.5);
  CHECK(found.contradicted_share() > 0.5);
  CHECK(found.pierced_share() + agree(*b, *a, {-0.1, -0.1, -0.1}).pierced_share() > 0.05);
}

TEST_CASE("agreement__finds_the_furniture_of_another_floor") {
  const auto a = judged_scan(furnished(7, 7), 0, 1), b = judged_scan(furnished(7, 500), 1, 2);
  const Agreement forth = agree(*a, *b), back = agree(*b, *a);
  CHECK(std::max(forth.worst_pierced, back.worst_pierced) > 0.03);
  CHECK(std::max(forth.contradicted_share(), back.contradicted_share()) > 0.03);
}

TEST_CASE("agreement__without_stations_rests_on_neighbours_alone") {
  const PairScene room = furnished(7, 7);
  const auto a = judged_scan(room, 0, 1), b = judged_scan(room, 1, 2);
  for (JudgedScan* scan : {a.get(), b.get()}) {
    scan->judged.sights.clear();
    for (Surfel& surfel : scan->judged.surfels) surfel.sight = -1;
  }
  const Agreement found = agree(*a, *b);
  CHECK(found.explained_share() > 0.9);
  CHECK(found.seen == 0);
  CHECK(found.pierced == 0);
}

TEST_CASE("agreement__counts_the_back_of_a_wall_as_another_face") {
  // Both scans see one side of the same thin wall, each its own: laid on each other they agree in place alone.
  PairScene wall;
  wall.sheet({-10, 0, 0}, {20, 0, 0}, {0, 0, 5});
  wall.sheet({-10, -10, 0}, {20, 0, 0}, {0, 20, 0});
  wall.standpoints = {{0, -5, 1.5}, {1, 5, 1.5}};
  const auto a = judged_scan(wall, 0, 1), b = judged_scan(wall, 1, 2);
  const size_t found_stations = agree(*a, *b).contradicted;
  a->judged.are_told = b->judged.are_told = true;
  CHECK(agree(*a, *b).contradicted > found_stations + 100);
}

TEST_CASE("agreement__of_clouds_far_apart_says_nothing") {
  const PairScene room = furnished(7, 7);
  const auto a = judged_scan(room, 0, 1), b = judged_scan(room, 1, 2);
  const Agreement found = agree(*a, *b, {1000, 0, 0});
  CHECK(found.near == 0);
  CHECK(found.explained_share() == 0);
  CHECK(found.contradicted_share() == 0);
}
