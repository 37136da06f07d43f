// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What a plane is where several walls stand before it or beside it.
#include <doctest/doctest.h>

#include "modelling/evidence/evidence.h"
#include "modelling/evidence/plane_roles.h"
#include "unit/modelling/layers.h"

using namespace jalon;
using layers::add_layer;
using layers::cut;
using layers::evidence_of;

namespace {

// Houses side by side, 6 m wide and 6 m high, with two windows of 1.2 x 1.6 m, each so far behind the first.
std::vector<Vec3> house(double left, double behind_m) {
  std::vector<Vec3> out;
  add_layer(out, left, 0, 6, 6, behind_m);
  for (const double window : {1.0, 3.5}) cut(out, left + window, 1, 1.2, 1.6);
  return out;
}

size_t openings_of(const WallEvidence& wall) {
  size_t n = 0;
  for (const OpeningCandidate& c : wall.openings) n += c.is_opening;
  return n;
}

}  // namespace

TEST_CASE("tell_roles__a_room_behind_several_houses_is_a_room_although_it_is_larger_than_each") {
  std::vector<Vec3> room;
  add_layer(room, 0.5, 0.3, 17, 5, 4);
  const auto evidence = evidence_of({house(0, 0), house(6, 0.3), house(12, 0.6), room});
  for (size_t s = 0; s < 3; ++s) CHECK(evidence[s].role == PlaneRole::kWall);
  CHECK(evidence[3].role == PlaneRole::kInside);
}

TEST_CASE("tell_roles__a_room_seen_through_panes_is_one_although_bands_alone_part_its_windows") {
  std::vector<Vec3> front, panes, room;
  add_layer(front, 0, 0, 12, 9, 0);
  for (const double foot : {0.4, 3.4, 6.4}) {
    cut(front, 0.3, foot, 11.4, 2.4);
    add_layer(panes, 0.3, foot, 11.4, 2.4, 0.2);
    add_layer(room, 0.3, foot, 11.4, 2.4, 3);
  }
  std::vector<Vec3> few;  // one in four of the places
  for (size_t i = 0; i < panes.size(); i += 4) few.push_back(panes[i]);
  CHECK(evidence_of({front, few, room})[2].role == PlaneRole::kInside);
  // Behind nothing it is the back wall of loggias.
  CHECK(evidence_of({front, room})[1].role == PlaneRole::kWall);
}

TEST_CASE("tell_roles__a_wing_that_stands_back_beside_the_front_is_a_wall") {
  std::vector<Vec3> wing = house(6, 4);
  add_layer(wing, 12, 0, 6, 6, 4);
  const auto evidence = evidence_of({house(0, 0), wing});
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kWall);
}

TEST_CASE("tell_roles__surrounds_of_two_houses_do_not_make_panes_of_the_walls_behind_them") {
  // In one plane before two houses, and so with a border about all that lies between them.
  std::vector<Vec3> surrounds;
  for (const double left : {0.0, 6.0})
    for (const double window : {1.0, 3.5}) {
      add_layer(surrounds, left + window - 0.3, 0.7, 1.8, 2.2, -0.06);
      cut(surrounds, left + window, 1, 1.2, 1.6);
    }
  add_layer(surrounds, 0, 5.6, 12, 0.4, -0.06);
  add_layer(surrounds, 0, 0, 12, 0.4, -0.06);
  add_layer(surrounds, 11.6, 0, 0.4, 6, -0.06);
  const auto evidence = evidence_of({house(0, 0), house(6, 0.12), surrounds});
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kWall);
}

TEST_CASE(
    "tell_roles__surrounds_of_a_house_are_none_of_what_fills_the_frame_of_cornices_about_it") {
  // Cornice, base course and gutters, in one plane, border the house like an opening as large as it.
  std::vector<Vec3> frame, surrounds;
  add_layer(frame, 6, 6, 6, 0.9, -0.04);
  for (const double gutter : {5.9, 12.0}) add_layer(frame, gutter, -0.05, 0.1, 2, -0.04);
  add_layer(frame, 6, -0.05, 6, 0.05, -0.04);
  for (const double window : {1.0, 3.5}) {
    add_layer(surrounds, 6 + window - 0.2, 0.8, 1.6, 2, 0.08);
    cut(surrounds, 6 + window, 1, 1.2, 1.6);
  }
  const auto evidence = evidence_of({house(6, 0.12), frame, surrounds});
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(openings_of(evidence[0]) == 2);
  CHECK(evidence[2].role == PlaneRole::kRelief);
}

TEST_CASE("tell_roles__panes_of_one_depth_in_several_houses_fill_their_windows") {
  std::vector<Vec3> panes;
  for (const double left : {0.0, 6.0})
    for (const double window : {1.0, 3.5}) add_layer(panes, left + window, 1, 1.2, 1.6, 0.3);
  const auto evidence = evidence_of({house(0, 0), house(6, 0.1), panes});
  CHECK(evidence[2].role == PlaneRole::kFilling);
}

TEST_CASE("tell_roles__where_a_house_stands_back_the_wall_beside_it_ends") {
  // A strip of the first house's plane goes on along the far end of the second.
  std::vector<Vec3> first = house(0, 0);
  add_layer(first, 12, 0, 0.1, 6, 0);
  const auto evidence = evidence_of({first, house(6, 0.1)});
  CHECK(evidence[1].role == PlaneRole::kWall);
  CHECK(openings_of(evidence[0]) == 2);
  CHECK(openings_of(evidence[1]) == 2);
}

TEST_CASE("tell_roles__plinth_and_cornice_about_a_house_do_not_make_it_fill_the_wall_next_door") {
  // A finger's breadth behind two houses that explain more, with a strip of their plane along its far end.
  std::vector<Vec3> first = house(-6, 0), relief;
  for (const Vec3& p : house(0, 0)) first.push_back(p);
  add_layer(first, 12, 0, 0.1, 6, 0);
  add_layer(relief, 6, -0.3, 6, 0.3, -0.05);
  add_layer(relief, 6, 6, 6, 0.3, -0.05);
  const auto evidence = evidence_of({first, house(6, 0.03), relief});
  CHECK(evidence[1].role == PlaneRole::kWall);
  CHECK(openings_of(evidence[0]) == 4);
  CHECK(openings_of(evidence[1]) == 2);
}

TEST_CASE("tell_roles__a_wall_ends_where_a_larger_one_goes_on_behind_it_whatever_frames_it") {
  // Cornice, base course and quoins of the second house in the first one's plane; windows fill a third of it.
  std::vector<Vec3> first = house(0, 0), second;
  add_layer(first, 6, 5.6, 6.4, 0.4, 0);
  add_layer(first, 7.5, 0, 4.9, 0.5, 0);
  add_layer(first, 12, 0, 0.4, 6, 0);
  add_layer(second, 6, 0, 14, 6, 0.34);
  for (const double foot : {0.9, 3.3})
    for (const double left : {6.5, 8.7, 10.3, 13.0, 15.0, 17.0}) cut(second, left, foot, 1.2, 1.8);
  const auto evidence = evidence_of({first, second});
  CHECK(evidence[1].role == PlaneRole::kWall);
  CHECK(openings_of(evidence[0]) == 2);
  CHECK(openings_of(evidence[1]) == 12);
}

TEST_CASE(
    "tell_roles__doors_are_no_place_of_the_next_house_whose_wall_lies_in_the_plane_of_leaves") {
  std::vector<Vec3> first, second;
  add_layer(first, 0, 0, 6, 6, 0);
  add_layer(second, 6, 0, 14, 6, 0.3);
  for (const double left : {7.0, 9.5, 12.0, 14.5, 17.0}) cut(second, left, 1, 1.2, 1.8);
  for (const double left : {1.0, 3.5}) {
    cut(first, left, 0, 1.2, 2.2);
    add_layer(second, left, 0, 1.2, 2.2, 0.3);
  }
  const auto evidence = evidence_of({first, second});
  CHECK(openings_of(evidence[0]) == 2);
  CHECK(openings_of(evidence[1]) == 5);
}

TEST_CASE("tell_roles__pilasters_before_all_piers_of_a_wall_are_its_relief") {
  constexpr double kProud_m = 0.14, kPier_m = 0.8;
  std::vector<Vec3> wall, pilasters;
  add_layer(wall, 0, 0, 12, 8, 0);
  for (const double left : {2.0, 4.0, 6.0, 8.0}) {
    for (const double foot : {1.0, 4.5}) cut(wall, left, foot, 2 - kPier_m, 1.8);
    cut(wall, left - kPier_m, 0.5, kPier_m, 7);
    add_layer(pilasters, left - kPier_m, 0.5, kPier_m, 7, -kProud_m);
  }
  const auto evidence = evidence_of({wall, pilasters});
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kRelief);
  CHECK(openings_of(evidence[0]) == 8);
}

TEST_CASE("tell_roles__a_wall_ends_behind_a_bay_window_although_something_is_glimpsed_there") {
  // Before a hole of the wall stands a bay with two windows; past its side the room's far end was seen.
  std::vector<Vec3> wall = house(0, 0), bay, glimpsed;
  add_layer(wall, 6, 0, 6, 6, 0);
  cut(wall, 7, 0.8, 3.4, 3.6);
  add_layer(bay, 7, 0.8, 3.4, 3.6, -0.9);
  for (const double window : {7.4, 8.9}) cut(bay, window, 1.6, 1.1, 2);
  add_layer(glimpsed, 7, 0.8, 1.6, 3.6, 6);
  const auto evidence = evidence_of({wall, bay, glimpsed});
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kWall);
  CHECK(openings_of(evidence[0]) == 2);
  CHECK(openings_of(evidence[1]) == 2);
  // Without the bay it is an opening.
  CHECK(openings_of(evidence_of({wall, glimpsed})[0]) == 3);
}

TEST_CASE("tell_roles__what_is_seen_through_a_front_before_the_wall_is_no_opening_of_the_wall") {
  // The wall goes on beside the front; the room was seen through the front's windows, next to where the wall ends.
  std::vector<Vec3> wall = house(0, 1.5), right = house(12, 1.5), room;
  wall.insert(wall.end(), right.begin(), right.end());
  for (const double lintel : {6.0, 11.0}) add_layer(wall, lintel, 2.6, 1, 0.2, 1.5);
  add_layer(room, 6, 1, 1, 1.6, 2.2);
  add_layer(room, 11, 1, 1, 1.6, 2.2);
  const auto evidence = evidence_of({wall, house(6, 0), room});
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kWall);
  CHECK(openings_of(evidence[0]) == 4);
  CHECK(openings_of(evidence[1]) == 2);
  // Without the front they are openings.
  CHECK(openings_of(evidence_of({wall, room})[0]) == 6);
}

TEST_CASE("tell_roles__timbers_that_frame_panels_are_relief_of_the_wall_with_the_windows") {
  // Posts and rails 4 cm proud, one panel about each window and two blank ones.
  constexpr double kProud_m = 0.04, kBeam_m = 0.2;
  std::vector<Vec3> wall = house(0, 0), timbers;
  add_layer(timbers, 0, 0, 6, 6, -kProud_m);
  for (const double left : {0.0, 3.0})
    for (const double foot : {0.0, 3.0}) {
      cut(timbers, left + kBeam_m, foot + kBeam_m, 3 - 2 * kBeam_m, 3 - 2 * kBeam_m);
      cut(wall, left, foot, kBeam_m, 3);
      cut(wall, left + 3 - kBeam_m, foot, kBeam_m, 3);
      cut(wall, left, foot, 3, kBeam_m);
      cut(wall, left, foot + 3 - kBeam_m, 3, kBeam_m);
    }
  const auto evidence = evidence_of({wall, timbers});
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kRelief);
  // Panels without windows fill the openings of a lattice.
  std::vector<Vec3> panels;
  for (const double left : {0.0, 3.0})
    for (const double foot : {0.0, 3.0})
      add_layer(panels, left + kBeam_m, foot + kBeam_m, 3 - 2 * kBeam_m, 3 - 2 * kBeam_m, 0);
  const auto lattice = evidence_of({panels, timbers});
  CHECK(lattice[0].role == PlaneRole::kFilling);
  CHECK(lattice[1].role == PlaneRole::kWall);
}

TEST_CASE(
    "tell_roles__panels_between_the_windows_of_a_wall_are_its_relief_however_large_they_are") {
  // Six axes and four storeys of windows over a ground floor; panels over and under them cover most of the wall.
  constexpr double kBay_m = 2, kPier_m = 0.3, kStorey_m = 2.9, kWindow_m = 1.1, kGround_m = 3;
  constexpr int kAxes = 6, kStoreys = 4;
  constexpr double kPanel_m = kStorey_m - kWindow_m;
  for (const double proud_m : {0.03, 0.05, 0.08}) {
    CAPTURE(proud_m);
    std::vector<Vec3> wall, panels;
    add_layer(wall, 0, 0, kAxes * kBay_m + kPier_m, kGround_m + kStoreys * kStorey_m + 1, 0);
    for (int axis = 0; axis < kAxes; ++axis) {
      const double left = kPier_m + axis * kBay_m, width = kBay_m - kPier_m;
      cut(wall, left, 0, width, 2.4);
      for (int storey = 0; storey < kStoreys; ++storey) {
        const double foot = kGround_m + storey * kStorey_m;
        cut(wall, left, foot, width, kStorey_m);
        add_layer(panels, left, foot, width, kPanel_m, -proud_m);
      }
    }
    const auto evidence = evidence_of({wall, panels});
    CHECK(explained_m2(evidence[1]) > explained_m2(evidence[0]));
    CHECK(evidence[0].role == PlaneRole::kWall);
    CHECK(evidence[1].role == PlaneRole::kRelief);
    CHECK(openings_of(evidence[0]) == kAxes * kStoreys);
  }
}

TEST_CASE("tell_roles__a_house_before_the_wall_that_goes_on_on_both_sides_is_a_wall") {
  std::vector<Vec3> row = house(0, 0.08), right = house(15, 0.08), house_between;
  row.insert(row.end(), right.begin(), right.end());
  add_layer(house_between, 6, 0, 9, 9, 0);
  for (const double foot : {1.0, 4.0, 6.6})
    for (const double left : {6.8, 9.2, 11.6}) cut(house_between, left, foot, 1.2, 1.6);
  const auto evidence = evidence_of({row, house_between});
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kWall);
  CHECK(openings_of(evidence[0]) == 4);
  CHECK(openings_of(evidence[1]) == 9);
}

TEST_CASE("tell_roles__a_house_little_before_its_neighbours_on_both_sides_is_no_relief_of_them") {
  for (const double forward_m : {0.05, 0.08}) {
    CAPTURE(forward_m);
    std::vector<Vec3> row = house(0, forward_m), right = house(12, forward_m);
    row.insert(row.end(), right.begin(), right.end());
    const auto evidence = evidence_of({row, house(6, 0)});
    CHECK(evidence[0].role == PlaneRole::kWall);
    CHECK(evidence[1].role == PlaneRole::kWall);
    CHECK(openings_of(evidence[0]) == 4);
    CHECK(openings_of(evidence[1]) == 2);
  }
}

TEST_CASE("tell_roles__lesenes_are_relief_as_far_before_the_wall_as_things_are_fixed_to_it") {
  // Three lesenes, a plinth and a cornice about two bays with a window each.
  constexpr double kLesene_m = 0.2, kBay_m = 2.7, kTall_m = 6;
  for (const double proud_m : {0.09, 0.11, 0.16, 0.22}) {
    CAPTURE(proud_m);
    std::vector<Vec3> wall = house(0, 0), lesenes;
    add_layer(lesenes, 0, 0, 6, kTall_m, -proud_m);
    for (const double left : {0.0, kLesene_m + kBay_m}) {
      cut(lesenes, left + kLesene_m, kLesene_m, kBay_m, kTall_m - 2 * kLesene_m);
      cut(wall, left, 0, kLesene_m, kTall_m);
    }
    cut(wall, 6 - kLesene_m, 0, kLesene_m, kTall_m);
    for (const double foot : {0.0, kTall_m - kLesene_m}) cut(wall, 0, foot, 6, kLesene_m);
    const auto evidence = evidence_of({wall, lesenes});
    CHECK(evidence[0].role == PlaneRole::kWall);
    CHECK(evidence[1].role == PlaneRole::kRelief);
  }
}

TEST_CASE("tell_roles__frames_in_the_rims_of_windows_fill_them") {
  // 10 cm wide, 12 cm behind the wall, about lights of glass that returned nothing.
  constexpr double kBar_m = 0.1, kLight_m = 0.45, kLightHeight_m = 0.65;
  std::vector<Vec3> frames;
  for (const double window : {1.0, 3.5}) {
    add_layer(frames, window, 1, 1.2, 1.6, 0.12);
    for (const double left : {kBar_m, 2 * kBar_m + kLight_m})
      for (const double foot : {kBar_m, 2 * kBar_m + kLightHeight_m})
        cut(frames, window + left, 1 + foot, kLight_m, kLightHeight_m);
  }
  const auto evidence = evidence_of({house(0, 0), frames});
  CHECK(evidence[0].role == PlaneRole::kWall);
  CHECK(evidence[1].role == PlaneRole::kFilling);
}

TEST_CASE("tell_roles__panes_in_the_side_of_an_oriel_do_not_make_a_room_of_the_front_beside_it") {
  // Side and panes upright to the front, crossing its plane.
  const auto add_side = [](std::vector<Vec3>& out, double at, double near, double far, double foot,
                           double top) {
    for (double y = near + layers::kStep_m / 2; y < far; y += layers::kStep_m)
      for (double z = foot + layers::kStep_m / 2; z < top; z += layers::kStep_m)
        out.push_back({at, y, z});
  };
  std::vector<std::vector<Vec3>> parts(3);
  auto &front = parts[0], &side = parts[1], &panes = parts[2];
  add_layer(front, 0, 0, 12, 4, 0);
  for (const double left : {1.0, 3.5, 8.0}) cut(front, left, 1, 1.2, 1.6);
  add_side(side, 6, -1.5, 3, 0, 4);
  std::erase_if(side,
                [](const Vec3& p) { return p.y > -0.5 && p.y < 2 && p.z > 0.6 && p.z < 3.4; });
  add_side(panes, 5.8, -0.5, 2, 0.6, 3.4);
  Segmentation segmentation = walls::segmentation_of(parts);
  for (size_t s = 0; s < parts.size(); ++s) {
    Segment& segment = segmentation.segments[s];
    segment.area_m2 = layers::kStep_m * layers::kStep_m * static_cast<double>(parts[s].size());
    if (s > 0 && segment.fit.plane.normal.x < 0) turn_over(segment.fit);
  }
  Task task;
  const auto evidence = gather_evidence(segmentation, {}, task);
  CHECK(evidence[2].role == PlaneRole::kFilling);
  CHECK(evidence[0].role == PlaneRole::kWall);
}
