// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Windows about changes, against brute force over all points of two boxes that touch a floor.
#include "compare/changes/epoch_window.h"

#include <doctest/doctest.h>

#include "unit/compare/changes/epochs.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kFloor = 0.02;  // half-thickness of the floor that is taken away

struct TwoBoxes {
  std::vector<Vec3> was, is;
  size_t first = 0, second = 0, end = 0;  ///< of was: where the boxes begin and the second ends

  TwoBoxes() {
    RandomStream before(3, 0), after(3, 1);
    add_sheet(was, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, before);
    first = was.size();
    add_box(was, {-1, -1, 0.1}, {0.5, 0.5, 0.5}, before);
    second = was.size();
    add_box(was, {0.8, 0.8, 0.1}, {0.5, 0.5, 0.5}, before);
    end = was.size();
    add_sheet(is, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, after);
    add_box(is, {-1, -1, 0.1}, {0.5, 0.5, 0.5}, after);
    add_box(is, {0.8, 0.8, 0.1}, {0.5, 0.5, 0.5}, after);
  }
};

std::vector<Support> floor_support() {
  Support floor;
  floor.plane.normal = {0, 0, 1};
  floor.tolerance_m = kFloor;
  return {floor};
}

}  // namespace

TEST_CASE("epoch_window__has_the_unchanged_points_of_its_box_in_their_order") {
  const TwoBoxes scene;
  const TwoEpochs epochs(scene.was, scene.is);
  Task task;
  EpochWindow window(epochs.before);
  for (const Box3& box : {Box3{{-1.2, -1.2, -0.1}, {0.9, 0.9, 0.3}}, Box3{{5, 5, 5}, {6, 6, 6}},
                          Box3{{-9, -9, -9}, {9, 9, 9}}}) {
    window.look(box, task);
    std::vector<Vec3> found, wanted;
    window.for_each_unchanged([&](const Vec3& p) { found.push_back(p); });
    for (size_t i = 0; i < scene.was.size(); ++i)
      if (const Vec3 p = epochs.before.local(i);
          box.contains(p) && epochs.before.is_compared(i) && epochs.before.regions.changed[i] == 0)
        wanted.push_back(p);
    CHECK(found == wanted);
  }
}

TEST_CASE("epoch_window__takes_the_piece_of_a_point_and_its_counterpart_in_the_other_epoch") {
  const TwoBoxes scene;
  const TwoEpochs epochs(scene.was, scene.is);
  Task task;
  EpochWindow before(epochs.before), after(epochs.after);
  for (EpochWindow* window : {&before, &after}) {
    window->look({{-3, -3, -1}, {3, 3, 2}}, task);
    window->part(floor_support(), kApart_m, task);
  }
  before.take(0);  // of the floor: there is no piece
  CHECK_FALSE(before.take_counterparts(after));
  before.take(static_cast<uint32_t>(scene.second));
  CHECK(before.whole().empty());
  REQUIRE(before.take_counterparts(after));
  std::vector<uint32_t> box;
  for (size_t i = scene.second; i < scene.end; ++i) box.push_back(static_cast<uint32_t>(i));
  CHECK(before.whole() == box);
  REQUIRE(after.take_counterparts(before));
  CHECK(after.whole().size() > box.size() / 2);
  for (const uint32_t i : after.whole()) CHECK(epochs.after.local(i).x > 0.7);
  CHECK_FALSE(before.take_counterparts(after));  // nothing new
}
