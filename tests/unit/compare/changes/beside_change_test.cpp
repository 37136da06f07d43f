// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What lies beside changed points: what gave way leaves the other epoch's surface along it, what stands on it across.
#include "compare/changes/beside_change.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "unit/compare/changes/told_epochs.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kNear_m = 2 * kApart_m;

// Of all that changed after.
Beside beside_after(const ToldEpochs& epochs) {
  Task task;
  std::vector<uint32_t> points;
  for (const ChangeRegion& region : epochs.after.regions.regions)
    points.insert(points.end(), region.indices.begin(), region.indices.end());
  Beside out;
  add_beside(epochs.after, epochs.before, points, kNear_m, task, out);
  return out;
}

// The floor rises by so much in its middle, in a circle of 1.2 m, without a fold.
std::vector<Vec3> risen_floor(double height_m, uint64_t stream) {
  constexpr double kRadius_m = 1.2;
  std::vector<Vec3> points = floor_with({}, stream);
  for (Vec3& p : points) {
    const double r = std::hypot(p.x, p.y) / kRadius_m;
    if (r < 1) p.z += height_m * (1 + std::cos(std::numbers::pi * r)) / 2;
  }
  return points;
}

}  // namespace

TEST_CASE("beside_change__a_floor_that_rose_leaves_the_old_one_along_it") {
  const Beside beside = beside_after({floor_with({}, 21), risen_floor(0.3, 22)});
  CHECK(beside.same > 0);
  CHECK(beside.borders > 10);
  CHECK(beside.border_along() > 0.5);
  CHECK(beside.border_along() <= 1);
  // The floor that it rose from is seen no more, and both lie as floors do.
  CHECK(beside.measured > 10);
  CHECK(beside.gone_share() > 0.5);
  CHECK(beside.facing_share() > 0.8);
  CHECK(beside.facing_gone_share() > 0.5);
  CHECK(beside.facing_gone_share() <= std::min(beside.gone_share(), beside.facing_share()));
}

TEST_CASE("beside_change__a_box_on_the_floor_leaves_it_across") {
  const Beside beside =
      beside_after({floor_with({}, 23), floor_with({{{-0.4, -0.3, 0}, {0.8, 0.6, 0.5}}}, 24)});
  CHECK(beside.borders > 10);
  CHECK(beside.border_along() < 0.3);
  // What lies nearest to its sides is the floor about it, which is still there.
  CHECK(beside.measured > 10);
  CHECK(beside.gone_share() < 0.5);
  CHECK(beside.facing_gone_share() < 0.3);
}

TEST_CASE("beside_change__without_points_nothing_is_asked_and_few_borders_are_not_sure") {
  const ToldEpochs epochs(floor_with({}, 25), floor_with({}, 26));
  Task task;
  Beside none;
  add_beside(epochs.after, epochs.before, {}, kNear_m, task, none);
  CHECK(none.asked == 0);
  CHECK(none.border_along() == 0);
  CHECK(none.facing_gone_share() == 0);
  Beside one;
  one.borders = 1;
  one.along = 1;
  CHECK(one.border_along() < 0.5);
}
