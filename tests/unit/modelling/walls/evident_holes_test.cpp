// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The holes of a wall that was drawn by its openings.
#include <doctest/doctest.h>

#include "modelling/plane/ring_tools.h"
#include "modelling/walls/evident_holes.h"
#include "unit/modelling/plane_rings.h"

using namespace jalon;

namespace {

OpeningCandidate candidate_at(const Vec2& low, const Vec2& high, bool is_opening = true) {
  OpeningCandidate out;
  out.shape.sizes = {low.u, high.u, low.v, high.v, 0, 0};
  out.is_opening = is_opening;
  return out;
}

constexpr double kDrawnSpacing_m = 0.02;

// 10 x 5 m with a hole at (1, 1), and a door's notch of 1 x 2 m at (6, 0).
VectorPlane drawn_wall() {
  VectorFace face;
  face.outline = rings::ring_of({{0, 0}, {6, 0}, {6, 2}, {7, 2}, {7, 0}, {10, 0}, {10, 5}, {0, 5}});
  face.openings.push_back(rings::hole({1, 1}, {2, 2.5}));
  return rings::wall_of({face}, kDrawnSpacing_m);
}

}  // namespace

TEST_CASE("candidate_of__is_the_opening_that_has_most_in_common_with_the_hole") {
  WallHole hole;
  hole.outline = rings::rectangle({1, 1}, {2, 2.5});
  const std::vector<OpeningCandidate> candidates{
      candidate_at({1, 1}, {2, 2.5}, false), candidate_at({1.1, 1}, {2.2, 2.5}),
      candidate_at({1.02, 1.02}, {1.98, 2.48}), candidate_at({5, 1}, {6, 2.5})};
  CHECK(candidate_of(hole, candidates) == 2);
  CHECK(candidate_of(hole, std::span(candidates).first(1)) == -1);  // no opening
  const std::vector<OpeningCandidate> larger{candidate_at({1, 1}, {4, 2.5})};
  CHECK(candidate_of(hole, larger) == -1);  // a third in common
  CHECK(candidate_of(hole, {}) == -1);
}

TEST_CASE("evident_holes__keep_holes_and_the_notches_that_openings_cut") {
  const std::vector<OpeningCandidate> both{candidate_at({1.02, 1.02}, {1.98, 2.48}),
                                           candidate_at({6.02, 0}, {6.98, 1.98})};
  const auto holes = evident_holes(drawn_wall(), both);
  REQUIRE(holes.size() == 2);
  CHECK_FALSE(holes[0].is_notch);
  CHECK(holes[1].is_notch);
  CHECK_FALSE(holes[1].is_bay);
  // Without the door the notch is the wall's own outline; a hole stays, what it is is told later.
  const auto none = evident_holes(drawn_wall(), {});
  REQUIRE(none.size() == 1);
  CHECK_FALSE(none[0].is_notch);
}

TEST_CASE("evident_holes__an_outline_that_goes_down_in_steps_has_one_notch_for_an_opening") {
  // A shop front at (2, 1); beside its foot the wall was not seen, and the outline comes down in two steps.
  VectorFace face;
  face.outline = rings::ring_of({{0, 0},
                                 {1.8, 0},
                                 {1.8, 0.5},
                                 {2, 0.5},
                                 {2, 3},
                                 {6, 3},
                                 {6, 0.5},
                                 {6.2, 0.5},
                                 {6.2, 0},
                                 {10, 0},
                                 {10, 5},
                                 {0, 5}});
  const auto with_foot = [&](double foot) {
    VectorPlane wall = rings::wall_of({face}, kDrawnSpacing_m);
    wall.faces[0].outline.corners[2].v = wall.faces[0].outline.corners[3].v = foot;
    wall.faces[0].outline.corners[6].v = wall.faces[0].outline.corners[7].v = foot;
    const std::vector<OpeningCandidate> one{candidate_at({2.02, 1}, {5.98, 2.98})};
    return evident_holes(wall, one);
  };
  for (const double foot : {0.3, 0.5, 0.9}) {
    const auto holes = with_foot(foot);
    REQUIRE(holes.size() == 1);
    CHECK(ring_box(holes[0].outline).low.v == doctest::Approx(foot));
  }
}

TEST_CASE(
    "evident_holes__a_notch_that_goes_on_above_its_opening_where_wall_is_hidden_is_no_more_of_it") {
  VectorFace face;
  face.outline =
      rings::ring_of({{0, 0}, {6, 0}, {6, 2.9}, {7, 2.9}, {7, 0}, {10, 0}, {10, 5}, {0, 5}});
  const VectorPlane wall = rings::wall_of({face}, kDrawnSpacing_m);
  const std::vector<OpeningCandidate> door{candidate_at({6.02, 0}, {6.98, 1.98})};
  const auto holes = evident_holes(wall, door);
  REQUIRE(holes.size() == 1);
  CHECK(holes[0].is_bay);
  CHECK(ring_box(holes[0].outline).high.v == doctest::Approx(2));
  // As high as the notch it has its form.
  const std::vector<OpeningCandidate> gate{candidate_at({6.02, 0}, {6.98, 2.88})};
  const auto whole = evident_holes(wall, gate);
  REQUIRE(whole.size() == 1);
  CHECK_FALSE(whole[0].is_bay);
}

TEST_CASE("evident_holes__a_strip_above_a_broad_opening_is_no_more_of_it") {
  VectorFace face;
  face.outline =
      rings::ring_of({{0, 0}, {3, 0}, {3, 3.1}, {6.2, 3.1}, {6.2, 0}, {10, 0}, {10, 5}, {0, 5}});
  const VectorPlane wall = rings::wall_of({face}, kDrawnSpacing_m);
  const std::vector<OpeningCandidate> front{candidate_at({3.02, 0}, {6.18, 2.94})};
  const auto holes = evident_holes(wall, front);
  REQUIRE(holes.size() == 1);
  CHECK(holes[0].is_bay);
  CHECK(ring_box(holes[0].outline).high.v == doctest::Approx(2.96));
  // Two spacings are what an outline is measured to.
  const std::vector<OpeningCandidate> whole{candidate_at({3.02, 0}, {6.18, 3.05})};
  const auto notch = evident_holes(wall, whole);
  REQUIRE(notch.size() == 1);
  CHECK_FALSE(notch[0].is_bay);
}

TEST_CASE("evident_holes__an_opening_whose_form_shows_in_no_face_is_a_bay_beside_the_nearest") {
  VectorPlane wall = rings::wall_of(
      {{rings::rectangle({0, 0}, {4, 3}), {}}, {rings::rectangle({6.5, 0}, {9, 3}), {}}},
      kDrawnSpacing_m);
  const std::vector<OpeningCandidate> candidates{candidate_at({4.5, 0}, {6.4, 2.5}),
                                                 candidate_at({1, 1}, {2, 2}),
                                                 candidate_at({4.2, 2.6}, {4.4, 2.9}, false)};
  const auto holes = evident_holes(wall, candidates);
  REQUIRE(holes.size() == 1);  // neither what is in a face uncut nor what is no opening
  CHECK(holes[0].is_bay);
  CHECK(holes[0].is_notch);
  CHECK(holes[0].piece == 1);
  const RingBox box = ring_box(holes[0].outline);
  CHECK(box.low.u == doctest::Approx(4.5 - kDrawnSpacing_m));
  CHECK(box.high.v == doctest::Approx(2.5 + kDrawnSpacing_m));
  CHECK(signed_area(holes[0].outline) > 0);
  wall.faces.clear();
  CHECK(evident_holes(wall, candidates).empty());
}

TEST_CASE("add_bays__what_stray_points_enclose_far_from_the_wall_is_no_opening_of_it") {
  // Along the eaves of the house next door lies a strip in the wall's plane.
  const VectorPlane wall = rings::wall_of(
      {{rings::rectangle({0, 0}, {10, 8}), {}}, {rings::rectangle({11, 8}, {14, 8.1}), {}}},
      kDrawnSpacing_m);
  std::vector<OpeningCandidate> candidates{candidate_at({12, 0}, {12.5, 7.9})};
  std::vector<WallHole> holes;
  add_bays(wall, candidates, holes);
  CHECK(holes.empty());
  // A broad wall over it is its lintel.
  candidates[0].framed = 0.5;
  add_bays(wall, candidates, holes);
  CHECK(holes.size() == 1);
}

TEST_CASE("add_bays__openings_without_a_hole_become_bays_unless_a_hole_lies_over_them") {
  // A dormer whose foot nobody saw: its window is a gap between two piers.
  VectorFace face;
  face.outline =
      rings::ring_of({{0, 0}, {1, 0}, {1, 1.2}, {2, 1.2}, {2, 0}, {3, 0}, {3, 2}, {0, 2}});
  const VectorPlane wall = rings::wall_of({face}, kDrawnSpacing_m);
  std::vector<WallHole> holes;
  add_bays(wall, std::vector<OpeningCandidate>{candidate_at({1.02, 0}, {1.98, 1.18})}, holes);
  REQUIRE(holes.size() == 1);
  CHECK(holes[0].is_bay);
  // Two bays are there already: what spans both is none.
  add_bays(wall, std::vector<OpeningCandidate>{candidate_at({1.02, -2}, {1.98, 1.18})}, holes);
  CHECK(holes.size() == 1);
}

TEST_CASE("evident_holes__one_notch_over_two_openings_becomes_a_bay_for_each") {
  // A car hid the foot of the pier between two shop fronts.
  VectorFace face;
  face.outline = rings::ring_of({{0, 0},
                                 {1, 0},
                                 {1, 2.5},
                                 {3, 2.5},
                                 {3, 1.2},
                                 {3.6, 1.2},
                                 {3.6, 2.5},
                                 {5, 2.5},
                                 {5, 0},
                                 {8, 0},
                                 {8, 4},
                                 {0, 4}});
  const VectorPlane wall = rings::wall_of({face}, kDrawnSpacing_m);
  std::vector<OpeningCandidate> fronts{candidate_at({1.02, 0}, {2.98, 2.48}),
                                       candidate_at({3.62, 0}, {4.98, 2.48})};
  for (OpeningCandidate& front : fronts) front.jambs = 1;
  const auto holes = evident_holes(wall, fronts);
  REQUIRE(holes.size() == 2);
  for (size_t k = 0; k < 2; ++k) {
    CHECK(holes[k].is_evident);
    CHECK(overlap(ring_box(holes[k].outline), fronts[k].shape.box()) > 0.9);
  }
  WallHole both;
  both.outline = rings::rectangle({1, 0}, {5, 2.5});
  CHECK_FALSE(
      holds_several(both, fronts));  // two leaves of one door: nothing of the wall parts them
}
