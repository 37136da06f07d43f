// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/moved_things.h"

#include <doctest/doctest.h>

#include "compare/changes/change_confidence.h"
#include "unit/compare/changes/told_epochs.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct Found {
  MovedThings things;
  size_t groups_left = 0;  ///< of those that anything is told of
};

Found found(const ToldEpochs& epochs, double reach = 1.5) {
  Task task;
  const ObjectMotionJob job = epochs.job(task);
  std::vector<ChangeGroup> groups = change_groups(job);
  Found out;
  out.things = take_moved_things(job, reach, groups);
  for (const ChangeGroup& group : groups)
    out.groups_left += group.points() >= kLeastToldPoints ? 1 : 0;
  return out;
}

constexpr Vec3 kSize{0.8, 0.55, 0.4};

}  // namespace

TEST_CASE("moved_things__of_a_box_that_was_pushed_are_one_and_its_ends_leave_the_groups") {
  const Vec3 from{-0.5, -0.4, 0}, by{0.3, 0.2, 0};
  const ToldEpochs epochs(floor_with({{from, kSize}}, 3), floor_with({{from + by, kSize}}, 4));
  const Found out = found(epochs);
  REQUIRE(out.things.moved.size() == 1);
  const Change& moved = out.things.moved.front();
  CHECK(is_told(moved));
  CHECK(norm(moved.match.displacement - by) < 0.005);
  CHECK(moved.motion.way_m > 0.3);
  CHECK_FALSE(moved.object.regions_after.empty());
  CHECK(out.groups_left == 0);
}

TEST_CASE("moved_things__a_box_carried_within_reach_is_found_again_and_not_beyond_it") {
  const Vec3 from{-1.4, -1.4, 0}, to{-0.2, -1.3, 0};
  const ToldEpochs epochs(floor_with({{from, kSize}}, 5), floor_with({{to, kSize}}, 6));
  const Found near = found(epochs);
  REQUIRE(near.things.moved.size() == 1);
  CHECK(norm(near.things.moved[0].match.displacement - (to - from)) < 0.005);
  const Found far = found(epochs, 0.5);
  CHECK(far.things.moved.empty());
  CHECK(far.groups_left == 2);
}

TEST_CASE("moved_things__another_box_beside_where_one_stood_is_none_of_them") {
  const ToldEpochs epochs(floor_with({{{-1.4, -1.4, 0}, kSize}}, 7),
                          floor_with({{{-0.2, -1.3, 0}, {0.35, 0.35, 1.2}}}, 8));
  const Found out = found(epochs);
  CHECK(out.things.moved.empty());
  CHECK(out.groups_left > 0);
  for (const Change& other : out.things.others) CHECK_FALSE(is_told(other));
}
