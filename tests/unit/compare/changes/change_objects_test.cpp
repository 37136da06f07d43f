// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Whole objects from changed regions, against scenes in which it is known which points are of which thing.
#include "compare/changes/change_objects.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "unit/compare/changes/epochs.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<Vec3> floor_of(double half, RandomStream& random) {
  std::vector<Vec3> points;
  add_sheet(points, {-half, -half, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}, random);
  return points;
}

// A box of 1.2 x 0.4 x 0.4 m on a floor is pushed by 0.3 m along its length; a small one is put beside it.
struct PushedBox {
  std::vector<Vec3> was, is;
  size_t box_from[2] = {0, 0}, box_to[2] = {0, 0};

  PushedBox() {
    RandomStream first(1, 0), second(1, 1);
    was = floor_of(1.8, first);
    is = floor_of(1.8, second);
    box_from[0] = was.size();
    add_box(was, {-0.6, -0.2, 0}, {1.2, 0.4, 0.4}, first);
    box_to[0] = was.size();
    box_from[1] = is.size();
    add_box(is, {-0.3, -0.2, 0}, {1.2, 0.4, 0.4}, second);
    box_to[1] = is.size();
    add_box(is, {1.2, 1.2, 0}, {0.3, 0.3, 0.3}, second);
  }
};

// The points of a thing that no support holds.
std::vector<uint32_t> above_supports(const Epoch& epoch, size_t from, size_t to,
                                     const std::vector<Support>& supports) {
  std::vector<uint32_t> out;
  for (size_t i = from; i < to; ++i)
    if (std::ranges::none_of(supports, [&](const Support& s) { return s.holds(epoch.local(i)); }))
      out.push_back(static_cast<uint32_t>(i));
  return out;
}

// A pipe of 0.1 m along x, and a collar of 0.3 m with both its ends around the middle of it.
std::vector<Vec3> pipe_of(double length_m, bool with_collar, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  const auto turned = [](double x, double r, double turn) {
    const double a = 2 * std::numbers::pi * turn;
    return Vec3{x, r * std::cos(a), r * std::sin(a)};
  };
  add_surface(points, length_m, 2 * std::numbers::pi * 0.1, random,
              [&](double s, double t) { return turned(length_m * (s - 0.5), 0.1, t); });
  if (!with_collar) return points;
  const double around = 2 * std::numbers::pi * 0.3;
  add_surface(points, 0.3, around, random,
              [&](double s, double t) { return turned(0.3 * (s - 0.5), 0.3, t); });
  for (const double end : {-0.15, 0.15})
    add_surface(points, 0.2, around, random,
                [&](double s, double t) { return turned(end, 0.1 + 0.2 * s, t); });
  return points;
}

}  // namespace

TEST_CASE("whole_objects__are_the_pushed_box_in_both_epochs_without_its_floor_and_the_new_one") {
  const PushedBox scene;
  const TwoEpochs epochs(scene.was, scene.is);
  Task task;
  const auto objects = whole_objects(epochs.before, epochs.after, kApart_m / 2, task);
  REQUIRE(objects.size() == 2);
  const ChangedObject &pushed = objects[0], &fresh = objects[1];  // the largest first
  REQUIRE(pushed.supports.size() == 1);
  CHECK(std::abs(pushed.supports[0].plane.normal.z) > 0.999);
  // Most of the box lies where it lay: its unchanged points belong to it too.
  CHECK(pushed.before ==
        above_supports(epochs.before, scene.box_from[0], scene.box_to[0], pushed.supports));
  CHECK(pushed.after ==
        above_supports(epochs.after, scene.box_from[1], scene.box_to[1], pushed.supports));
  // One end lies beyond the box of the other epoch and the other inside it, farther than that from its sides.
  CHECK(pushed.regions_before.size() == 2);
  CHECK(pushed.regions_after.size() == 2);
  CHECK(fresh.before.empty());
  CHECK(fresh.regions_before.empty());
  CHECK(fresh.regions_after.size() == 1);
  CHECK(fresh.after ==
        above_supports(epochs.after, scene.box_to[1], scene.is.size(), fresh.supports));
}

TEST_CASE("whole_objects__of_a_pipe_that_ends_nowhere_within_reach_stay_the_region") {
  Task task;
  const TwoEpochs near(pipe_of(3, false, 1), pipe_of(3, true, 2));
  const auto whole = whole_objects(near.before, near.after, kApart_m / 2, task);
  REQUIRE(whole.size() == 1);
  CHECK(whole[0].before.size() == near.before.cloud().size());
  CHECK(whole[0].after.size() == near.after.cloud().size());
  // The first window is 1.5 m long along it, and six widenings by one and a half make 19 m of that.
  const TwoEpochs far(pipe_of(25, false, 1), pipe_of(25, true, 2));
  const auto cut = whole_objects(far.before, far.after, kApart_m / 2, task);
  REQUIRE(cut.size() == 1);
  CHECK(cut[0].before.empty());
  CHECK(cut[0].after == far.after.regions.regions[0].indices);
  CHECK(cut[0].supports.empty());
}

TEST_CASE("single_regions__hold_one_region_each_and_the_unchanged_points_beside_it") {
  const PushedBox scene;
  const TwoEpochs epochs(scene.was, scene.is);
  Task task;
  const ChangedObject whole =
      whole_objects(epochs.before, epochs.after, kApart_m / 2, task).front();
  const auto ends = single_regions(epochs.before, epochs.after, whole, kApart_m);
  REQUIRE(ends.size() == 4);
  for (size_t k = 0; k < 4; ++k) {
    const bool is_after = k >= 2;
    const Epoch& epoch = is_after ? epochs.after : epochs.before;
    const auto& own = is_after ? ends[k].after : ends[k].before;
    CHECK((is_after ? ends[k].before : ends[k].after).empty());
    const uint32_t label = (is_after ? whole.regions_after : whole.regions_before)[k % 2];
    CHECK((is_after ? ends[k].regions_after : ends[k].regions_before) == std::vector{label});
    CHECK((is_after ? ends[k].regions_before : ends[k].regions_after).empty());
    CHECK(ends[k].supports.size() == whole.supports.size());
    const ChangeRegion& region = epoch.regions.regions[label - 1];
    CHECK(std::ranges::includes(own, region.indices));
    CHECK(own.size() > region.indices.size());
    CHECK(std::ranges::includes(is_after ? whole.after : whole.before, own));
    for (const uint32_t i : own) {
      if (epoch.regions.labels[i] == label) continue;
      const Vec3 p = epoch.local(i);
      REQUIRE(epoch.regions.changed[i] == 0);
      for (int axis = 0; axis < 3; ++axis) {
        REQUIRE(p[axis] >= region.box.min[axis] - 2.000001 * kApart_m);
        REQUIRE(p[axis] <= region.box.max[axis] + 2.000001 * kApart_m);
      }
    }
  }
}

TEST_CASE("changed_area__and_volume_of_two_blocks_on_a_floor_add_up") {
  RandomStream first(3, 0), second(3, 1);
  const std::vector<Vec3> was = floor_of(2, first);
  std::vector<Vec3> is = floor_of(2, second);
  add_box(is, {-1.5, -1.5, 0}, {1.2, 1.2, 0.2}, second);
  add_box(is, {0.5, 0.5, 0}, {0.8, 0.8, 0.2}, second);
  const TwoEpochs epochs(was, is, {100, 200, 0});
  REQUIRE(epochs.after.regions.regions.size() == 2);
  const double large = changed_area(epochs.after, {1}), small = changed_area(epochs.after, {2});
  // What is less than the threshold above the floor is no change. Discs are those of 16 neighbours, of 0.1 m
  // beside edges of 1 m: some percent.
  const double side_m = 0.2 - kApart_m;
  CHECK(large == doctest::Approx(1.2 * 1.2 + 4 * 1.2 * side_m).epsilon(0.06).scale(0));
  CHECK(small == doctest::Approx(0.8 * 0.8 + 4 * 0.8 * side_m).epsilon(0.06).scale(0));
  CHECK(changed_area(epochs.after, {1, 2}) == large + small);
  CHECK(changed_area(epochs.after, {}) == 0);
  CHECK(changed_volume(epochs.after, {1, 2}) ==
        doctest::Approx((1.2 * 1.2 + 0.8 * 0.8) * 0.2).epsilon(0.08).scale(0));
  CHECK(changed_volume(epochs.before, {}) == 0);
}
