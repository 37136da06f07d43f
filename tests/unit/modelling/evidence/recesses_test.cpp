// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Back walls of loggias told from what hangs behind panes.
#include <doctest/doctest.h>

#include "modelling/evidence/evidence.h"
#include "modelling/evidence/recesses.h"
#include "unit/modelling/layers.h"

using namespace jalon;
using layers::add_layer;
using layers::cut;
using layers::evidence_of;
using layers::kStep_m;

namespace {

constexpr double kBack_m = 1.4;

// A wall of 12 x 7 m with two openings of 3 x 2.6 m, and a plane behind them.
struct Front {
  std::vector<Vec3> wall, back, sides;
  Front() {
    add_layer(wall, 0, 0, 12, 7, 0);
    for (const double left : {1.0, 7.0}) {
      cut(wall, left, 3, 3, 2.6);
      add_layer(back, left, 3, 3, 2.6, kBack_m);
      cut(back, left + 1, 3.6, 1, 1.4);
    }
  }
  // The left side of each opening, from the wall so far back.
  void add_sides(double to_m) {
    for (const double left : {1.0, 7.0})
      for (double y = kStep_m / 2; y < to_m; y += kStep_m)
        for (double z = 3 + kStep_m / 2; z < 5.6; z += kStep_m) sides.push_back({left, y, z});
  }
  bool is_recess(unsigned threads = 1) const {
    const auto evidence = evidence_of({wall, back}, threads, sides);
    CHECK(evidence[0].role == PlaneRole::kWall);
    CHECK_FALSE(evidence[0].is_recess);
    return evidence[1].is_recess;
  }
};

}  // namespace

TEST_CASE("tell_recesses__a_wall_to_which_the_sides_of_openings_lead_is_a_loggias") {
  Front front;
  front.add_sides(kBack_m);
  CHECK(front.is_recess());
  CHECK(front.is_recess(4));
}

TEST_CASE("tell_recesses__a_back_wall_too_narrow_to_frame_its_windows_is_a_loggias_too") {
  Front front;
  front.add_sides(kBack_m);
  Segmentation segmentation = walls::segmentation_of({front.wall, front.back, front.sides});
  for (const size_t s : {0u, 1u})
    segmentation.segments[s].area_m2 =
        kStep_m * kStep_m * static_cast<double>(s == 0 ? front.wall.size() : front.back.size());
  Task task;
  auto evidence = gather_evidence(segmentation, {}, task);
  const auto is_recess_with = [&](double framed, double bordered) {
    for (OpeningCandidate& opening : evidence[1].openings)
      opening.framed = framed, opening.bordered = bordered;
    tell_recesses(segmentation, evidence, task);
    return evidence[1].is_recess;
  };
  CHECK(is_recess_with(0.4, 1));
  CHECK_FALSE(is_recess_with(0.4, 0.8));
  CHECK(is_recess_with(0.6, 0.8));
}

TEST_CASE("tell_recesses__what_hangs_behind_panes_is_none") {
  CHECK_FALSE(Front{}.is_recess());
  Front front;
  front.add_sides(0.3);  // reveals as far as the pane
  CHECK_FALSE(front.is_recess());
}

TEST_CASE("tell_recesses__the_leaf_of_a_deep_portal_has_no_openings_and_is_none") {
  Front front;
  front.add_sides(kBack_m);
  for (const double left : {1.0, 7.0}) add_layer(front.back, left + 1, 3.6, 1, 1.4, kBack_m);
  CHECK_FALSE(front.is_recess());
}

TEST_CASE("tell_recesses__an_opening_ends_where_the_one_that_it_is_seen_through_ends") {
  // Two storeys of loggias; a parapet hides the upper back wall's foot, down to the head of the lower loggia.
  constexpr double kFeet_m[] = {1, 4}, kWide_m = 3, kHigh_m = 2.4, kParapet_m = 0.8;
  std::vector<Vec3> wall, back, sides, panes;
  add_layer(wall, 0, 0, 12, 7, 0);
  for (const double left : {1.0, 7.0})
    for (const double foot : kFeet_m) {
      cut(wall, left, foot, kWide_m, kHigh_m);
      const double low = foot + (foot > 1 ? kParapet_m : 0), high = foot + kHigh_m;
      add_layer(back, left, low, kWide_m, high - low, kBack_m);
      cut(back, left + 1, foot + 0.2, 1, 1.7);
      add_layer(panes, left + 1, low, 1, foot + 1.9 - low, kBack_m + 0.15);
      for (double y = kStep_m / 2; y < kBack_m; y += kStep_m)
        for (double z = low + kStep_m / 2; z < high; z += kStep_m) sides.push_back({left, y, z});
    }
  const auto evidence = evidence_of({wall, back, panes}, 1, sides);
  CHECK(evidence[1].is_recess);
  size_t upper = 0;
  for (const OpeningCandidate& opening : evidence[1].openings) {
    const PlaneFrame& frame = evidence[1].cells.frame;
    const double foot = frame.lift(opening.shape.box().low).z,
                 head = frame.lift(opening.shape.box().high).z;
    if (!opening.is_opening || head < kFeet_m[1] + kParapet_m) continue;
    ++upper;
    CHECK(foot > kFeet_m[1] - 0.15);
    CHECK(foot < kFeet_m[1] + kParapet_m);
  }
  CHECK(upper == 2);
}

namespace {

// A wall on arches of 3 x 3 m, and a plane behind it that faces away.
std::vector<size_t> turned_behind_arches(const std::vector<Vec3>& back,
                                         FrontSource source = FrontSource::kEvidence) {
  std::vector<Vec3> wall;
  add_layer(wall, 0, 0, 12, 7, 0);
  for (const double left : {1.0, 7.0}) cut(wall, left, 0, 3, 3);
  Segmentation segmentation = walls::segmentation_of({wall, back});
  for (Segment& segment : segmentation.segments) {
    segment.area_m2 = kStep_m * kStep_m * static_cast<double>(segment.point_count());
    segment.front_source = source;
  }
  turn_over(segmentation.segments[1].fit);
  Task task;
  return turned_away(segmentation, gather_evidence(segmentation, {}, task), task);
}

}  // namespace

TEST_CASE("turned_away__the_back_of_a_passage_that_piers_hide_was_seen_through_the_arches") {
  constexpr double kPassage_m = 2.8;
  std::vector<Vec3> back;
  for (const double left : {0.5, 6.5}) {
    add_layer(back, left, 0, 4, 3.2, kPassage_m);
    cut(back, left + 1, 0, 2, 2.4);  // shop fronts
  }
  CHECK(turned_behind_arches(back) == std::vector<size_t>{1});
  // Stations say better who saw it.
  CHECK(turned_behind_arches(back, FrontSource::kStation).empty());
  // Panes and leaves are no deeper than their wall.
  for (Vec3& p : back) p.y = 0.3;
  CHECK(turned_behind_arches(back).empty());
}

TEST_CASE("turned_away__the_rear_of_a_narrow_building_is_measured_behind_walls_as_behind_windows") {
  std::vector<Vec3> rear;
  add_layer(rear, 0.5, 0, 11, 6.5, 3.5);
  for (const double left : {2.0, 5.0, 8.0}) cut(rear, left, 1, 1.2, 1.6);
  CHECK(turned_behind_arches(rear).empty());
}
