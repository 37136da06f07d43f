// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/coded_walls.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/modelling/model_checks.h"

using namespace jalon;

namespace {

/// Looks along -Y, from x = 0 to 10, 3 m high.
const CodedWall kFront{{0, 0}, {10, 0}, 0, 3};

CodedOpening opening(double x0, double x1, double z0, double z1, double y0, double y1) {
  return {"window 1 (360)", "window", 7, {{x1, y1, z0}, {x0, y0, z0}, {x0, y0, z1}, {x1, y1, z1}}};
}

bool is_placed(double x0, double x1, double z0, double z1, double y0, double y1) {
  return opening_in(kFront, opening(x0, x1, z0, z1, y0, y1)).has_value();
}

}  // namespace

TEST_CASE("coded_walls__an_opening_stands_in_the_wall_behind_which_its_frame_lies") {
  CHECK(is_placed(2, 4, 1, 2, 0.2, 0.2));
  CHECK(is_placed(2, 4, 1, 2, 0.1, 0.26));    // corners measured 16 cm apart in depth
  CHECK(is_placed(2, 4, 1, 2, 0, 0));         // flush
  CHECK(!is_placed(2, 4, 1, 2, -0.2, -0.2));  // before the wall
  CHECK(!is_placed(2, 4, 1, 2, 1.2, 1.2));    // another wall's
  CHECK(!is_placed(2, 3, 1, 2, 0.1, 0.5));    // turned by 22 degrees
  CHECK(!is_placed(-1, 1, 1, 2, 0.2, 0.2));   // reaches beyond the end
  CHECK(!is_placed(2, 4, 1, 3.2, 0.2, 0.2));  // and beyond the top
  CHECK(!is_placed(4, 4, 1, 2, 0.1, 0.9));    // across the wall
  CHECK(is_placed(2, 4, -0.1, 2, 0.2, 0.2));  // down to the foot: a notch
}

TEST_CASE("coded_walls__a_hole_lies_straight_before_its_frame") {
  const auto found = opening_in(kFront, opening(2, 4, 1, 2, 0.15, 0.25));
  REQUIRE(found.has_value());
  CHECK(found->depth_m == doctest::Approx(0.2));
  CHECK(!found->has_notch);
  for (size_t i = 0; i < 4; ++i) {
    CHECK(found->hole[i].y == doctest::Approx(0));
    CHECK(found->hole[i].x == doctest::Approx(found->frame[i].x));
    CHECK(found->hole[i].z == found->frame[i].z);
  }
  CHECK(found->frame[0] == Vec3{2, 0.15, 1});
  CHECK(found->frame[1] == Vec3{4, 0.25, 1});
}

TEST_CASE("coded_walls__openings_that_share_a_place_are_told") {
  const auto a = opening_in(kFront, opening(2, 4, 1, 2, 0.2, 0.2)),
             b = opening_in(kFront, opening(3.9, 5, 1.5, 2.5, 0.2, 0.2)),
             c = opening_in(kFront, opening(4.1, 5, 1.5, 2.5, 0.2, 0.2));
  CHECK(overlap(*a, *b));
  CHECK(!overlap(*a, *c));
}

TEST_CASE("coded_walls__a_wall_has_holes_notches_frames_and_reveals") {
  SharedFaces faces({});
  const uint32_t part = faces.part("wall", "wall", kNoParent);
  const CodedOpening window = opening(2, 4, 1, 2, 0.2, 0.2), flush = opening(5, 6, 1, 2, 0, 0);
  CodedOpening door = opening(7, 8, -0.1, 2, 0.1, 0.1);
  door.part_class = "door";
  const Corners foot = add_coded_wall(
      faces, kFront, part, 3,
      {*opening_in(kFront, door), *opening_in(kFront, window), *opening_in(kFront, flush)});
  // From a to b, round the floor of the door.
  const Corners expected{{0, 0, 0}, {7, 0, 0}, {7, 0.1, 0}, {8, 0.1, 0}, {8, 0, 0}, {10, 0, 0}};
  REQUIRE(foot.size() == expected.size());
  for (size_t i = 0; i < foot.size(); ++i) CHECK(norm(foot[i] - expected[i]) < 1e-12);
  const Model model = faces.take({});
  validate(model);
  for (const Face& face : model.faces) {
    CHECK(checks::ring_fault(model, face) == "");
    CHECK(checks::flatness(model, face) < 1e-9);
  }
  CHECK(model.faces[0].area_m2 == doctest::Approx(30 - 2 - 1 - 2));
  CHECK(model.faces[0].plane.normal.y == doctest::Approx(-1));
  CHECK(model.faces[0].ring_count == 3);
  // Three frames, four reveals of the window, three of the door, none where the frame is flush.
  CHECK(model.faces.size() == 1 + 3 + 4 + 3);
  CHECK(model.parts[1].depth_m == doctest::Approx(0.2));
  CHECK(model.parts[1].width_m == doctest::Approx(2));
}
