// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_groups.h"

#include <doctest/doctest.h>

#include "unit/compare/changes/told_epochs.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("change_groups__of_a_box_that_came_and_one_that_went_are_two_one_sided_ones") {
  const BoxOnFloor gone{{-1.4, -1.4, 0}, {0.6, 0.5, 0.5}}, come{{0.8, 0.7, 0}, {0.5, 0.6, 0.7}};
  const ToldEpochs epochs(floor_with({gone}, 1), floor_with({come}, 2));
  Task task;
  const std::vector<ChangeGroup> groups = change_groups(epochs.job(task));
  size_t before = 0, after = 0;
  for (const ChangeGroup& group : groups) {
    if (group.points() < 64) continue;
    before += group.only_before() ? 1 : 0;
    after += group.only_after() ? 1 : 0;
    CHECK(group.moved_share == 0);
    CHECK(std::is_sorted(group.object.before.begin(), group.object.before.end()));
    for (const uint32_t i : group.object.after) CHECK(group.box.contains(epochs.after.local(i)));
  }
  CHECK(before == 1);
  CHECK(after == 1);
}

TEST_CASE("change_groups__lies_in_asks_for_more_than_half") {
  ChangedObject part, whole;
  part.before = {1, 2};
  part.after = {5, 6};
  whole.before = {1, 2, 3};
  whole.after = {7};
  CHECK_FALSE(lies_in(part, whole));
  whole.after = {6, 7};
  CHECK(lies_in(part, whole));
}
