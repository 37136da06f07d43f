// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Rings turned, drawn with chords, boxed and judged.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modelling/plane/ring_tools.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

VectorRing round_headed() {
  VectorRing out = rectangle({0, 0}, {2, 3});
  out.edges[2].sagitta_m = 1;  // half a circle on top
  for (size_t e = 0; e < 4; ++e) out.edges[e].sigma_m = 0.001 * static_cast<double>(e + 1);
  return out;
}

}  // namespace

TEST_CASE("ring_tools__a_ring_reversed_has_the_negative_area_and_its_edges_in_their_places") {
  const VectorRing ring = round_headed(), back = reversed(ring), again = reversed(back);
  CHECK(signed_area(back) == doctest::Approx(-signed_area(ring)));
  CHECK(again.corners == ring.corners);
  for (size_t e = 0; e < 4; ++e) {
    CHECK(again.edges[e].sagitta_m == ring.edges[e].sagitta_m);
    const Vec2 from = back.corners[e], to = back.corners[(e + 1) % 4];
    for (size_t k = 0; k < 4; ++k)
      if (ring.corners[k] == to && ring.corners[(k + 1) % 4] == from)
        CHECK(back.edges[e].sigma_m == ring.edges[k].sigma_m);
  }
}

TEST_CASE("ring_tools__chords_are_the_same_points_whichever_way_and_stay_near_their_arc") {
  const VectorRing ring = round_headed(), chords = with_chords(ring, 0.01);
  CHECK(chords.corners.size() > 8);
  std::vector<Vec2> back = with_chords(reversed(ring), 0.01).corners;
  std::vector<Vec2> turned(back.rbegin(), back.rend());
  CHECK(turned == chords.corners);
  for (size_t i = 0; i < chords.corners.size(); ++i) {
    CHECK(chords.edges[i].sagitta_m == 0);
    const Vec2 a = chords.corners[i], b = chords.corners[(i + 1) % chords.corners.size()];
    if (std::min(a.v, b.v) < 3 || a.v == b.v) continue;
    CHECK(norm(a - Vec2{1, 3}) == doctest::Approx(1));
    CHECK(norm((a + b) * 0.5 - Vec2{1, 3}) >= 1 - 0.01);
    CHECK(chords.edges[i].sigma_m == 0.003);
  }
  const double lost_m2 = signed_area(ring) - signed_area(chords);
  CHECK(lost_m2 > 0);
  CHECK(lost_m2 < 0.01 * std::numbers::pi);
}

TEST_CASE("ring_tools__a_box_holds_the_arcs_and_one_as_made_nothing") {
  const RingBox box = ring_box(round_headed());
  CHECK(box.low == Vec2{0, 0});
  CHECK(box.high.u == doctest::Approx(2));
  CHECK(std::fabs(box.high.v - 4) < 1e-3);
  CHECK(box.grown(0.5).holds({-0.4, -0.4}));
  CHECK(!box.holds({-0.4, -0.4}));
  CHECK(!box.meets(RingBox{}));
  CHECK(!RingBox{}.holds({0, 0}));
  CHECK(box.meets(box.grown(-0.1)));
}

TEST_CASE("ring_tools__short_straight_edges_go_with_their_second_corner_wherever_they_are") {
  // A rectangle whose corners are cut by 1 mm, the ring begun at each of its corners: of each cut the second corner
  // goes, and the edge that is left keeps what was known of it.
  const std::vector<Vec2> cut{{0, 0}, {2, 0}, {2, 0.001}, {2, 3}, {1.999, 3}, {0, 3}, {0, 2.999}};
  const std::vector<Vec2> kept{{0, 0}, {2, 0}, {2, 3}, {0, 3}};
  for (size_t start = 0; start < cut.size(); ++start) {
    CAPTURE(start);
    VectorRing ring = ring_of(cut);
    for (size_t e = 0; e < cut.size(); ++e) ring.edges[e].sigma_m = static_cast<double>(e);
    std::rotate(ring.corners.begin(), ring.corners.begin() + static_cast<ptrdiff_t>(start),
                ring.corners.end());
    std::rotate(ring.edges.begin(), ring.edges.begin() + static_cast<ptrdiff_t>(start),
                ring.edges.end());
    const auto length = [](const VectorRing& r, size_t e) {
      return norm(r.corners[(e + 1) % r.corners.size()] - r.corners[e]);
    };
    drop_short_edges(ring, 0.01);
    REQUIRE(ring.corners.size() == 4);
    REQUIRE(ring.edges.size() == 4);
    for (size_t e = 0; e < 4; ++e) {
      CHECK(std::find(kept.begin(), kept.end(), ring.corners[e]) != kept.end());
      // The long edges were the even ones but the last, which the cut of the last corner split from it.
      const auto was = static_cast<size_t>(ring.edges[e].sigma_m);
      const Vec2 from = cut[was], to = cut[(was + 1) % cut.size()];
      CHECK(norm(from - to) > 1);
      CHECK(norm(ring.corners[e] - from) <= 0.0011);
      CHECK(norm(ring.corners[(e + 1) % 4] - to) <= 0.0011);
      CHECK(length(ring, e) >= 0.01);
    }
    CHECK(signed_area(ring) == doctest::Approx(6).epsilon(0.01));
  }
}

TEST_CASE("ring_tools__short_arcs_and_the_last_three_corners_stay") {
  VectorRing arched = ring_of({{0, 0}, {1, 0}, {1, 0.001}, {0, 1}});
  arched.edges[1].sagitta_m = 0.2;  // its corners are near, the arc between them is not short
  drop_short_edges(arched, 0.01);
  CHECK(arched.corners.size() == 4);
  VectorRing small = ring_of({{0, 0}, {0.001, 0}, {0.001, 0.001}, {0, 0.001}});
  drop_short_edges(small, 0.01);
  CHECK(small.corners.size() == 3);
  CHECK(small.edges.size() == 3);
}

TEST_CASE("ring_tools__overlap_is_the_shared_area_of_what_both_boxes_cover") {
  const RingBox box{{0, 0}, {2, 3}}, beside{{1, 0}, {3, 3}}, within{{0.5, 0.5}, {1.5, 1.5}};
  CHECK(overlap(box, box) == doctest::Approx(1));
  CHECK(overlap(box, beside) == doctest::Approx(3.0 / 9));
  CHECK(overlap(beside, box) == overlap(box, beside));
  CHECK(overlap(box, within) == doctest::Approx(1.0 / 6));
  CHECK(overlap(box, {{2, 0}, {4, 3}}) == 0);  // they touch
  CHECK(overlap(box, {{0, 5}, {2, 6}}) == 0);
  CHECK(overlap(box, RingBox{}) == 0);
}

TEST_CASE("ring_tools__a_ring_is_simple_until_an_edge_or_an_arc_meets_another") {
  CHECK(is_simple(round_headed(), 0.01));
  CHECK(!is_simple(ring_of({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), 0.01));  // a bow tie
  CHECK(!is_simple(ring_of({{0, 0}, {1, 0}}), 0.01));
  CHECK(!is_simple(ring_of({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), 0.01));  // runs back along itself
  VectorRing dented = rectangle({0, 0}, {2, 0.5});
  CHECK(is_simple(dented, 0.01));
  dented.edges[2].sagitta_m = -0.8;  // the arc of the upper edge reaches below the lower one
  CHECK(!is_simple(dented, 0.01));
}

TEST_CASE("ring_tools__a_face_is_sound_with_its_openings_inside_and_apart") {
  VectorFace face{rectangle({0, 0}, {10, 5}), {hole({1, 1}, {2, 2}), hole({3, 1}, {4, 2})}};
  CHECK(is_sound(face, 0.01));
  const auto with = [&](VectorRing ring) {
    VectorFace out = face;
    out.openings.push_back(std::move(ring));
    return is_sound(out, 0.01);
  };
  CHECK(with(hole({5, 1}, {6, 2})));
  CHECK(!with(hole({9, 1}, {11, 2})));         // over the border
  CHECK(!with(hole({20, 1}, {21, 2})));        // outside
  CHECK(!with(hole({3.5, 1.5}, {4.5, 2.5})));  // over another one
  CHECK(!with(hole({1.2, 1.2}, {1.8, 1.8})));  // within another one
  CHECK(!with(hole({0.5, 0.5}, {2.5, 2.5})));  // around another one
}
