// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numbers>
#include <vector>

#include "geometry/polygon2.h"
#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// Arches against the circle through their three points, faces against the even-odd rule, recesses against the volume
// of the pocket that they are.

namespace {

constexpr double kChordError_m = 1e-4;  // of the header
const Frame kPocketFront{{}, {1, 0, 0}, {0, 0, 1}};
const Rect kPocket{1, 2.2, 0.5, 2.5};

/// Rectangle and circular segment.
double arched_area_m2(const Rect& rect, double rise_m) {
  const double chord = rect.width(), radius = chord * chord / (8 * rise_m) + rise_m / 2;
  const double angle = 2 * std::acos((radius - rise_m) / radius);
  return chord * (rect.height() - rise_m) + radius * radius * (angle - std::sin(angle)) / 2;
}

/// Nothing leaves the pocket: rays from its opening end on the front of a surface at this depth at most.
void check_holds_all_rays(const Model& pocket, const Outline& outline, double depth_m) {
  RandomStream random(5, 0);
  for (int k = 0; k < 500; ++k) {
    const Vec3 eye{1 + 1.2 * random.uniform(), 0, 0.5 + 2 * random.uniform()};
    const Vec3 direction{2 * random.uniform() - 1, 0.01 + random.uniform(),
                         2 * random.uniform() - 1};
    const Vec2 at{eye.x, eye.z};
    if (!contains(outline, at) || border_distance(outline, at) < 1e-3) continue;
    const Hit hit = first_hit(pocket, eye, direction);
    REQUIRE(std::isfinite(hit.distance));
    REQUIRE(hit.is_front);
    REQUIRE(hit.distance * direction.y < depth_m + kRounding_m);
  }
}

}  // namespace

TEST_CASE("arched_outline__keeps_its_chords_within_a_tenth_of_a_millimetre_of_the_arc") {
  for (const double rise : {0.05, 0.2, 0.45, 0.6}) {  // the last one is a semicircle
    CAPTURE(rise);
    const Outline ring = arched_outline(kPocket, rise);
    // The circle through the springing points and the crown.
    const double radius = 0.6 * 0.6 / (2 * rise) + rise / 2;
    const Vec2 centre{1.6, 2.5 - radius};
    REQUIRE(ring.size() > 8);
    CHECK(ring[0] == Vec2{1, 0.5});
    CHECK(ring[1] == Vec2{2.2, 0.5});
    CHECK(norm(ring[2] - Vec2{2.2, 2.5 - rise}) < 1e-12);
    CHECK(norm(ring.back() - Vec2{1, 2.5 - rise}) < 1e-12);
    for (size_t i = 2; i < ring.size(); ++i) {
      CHECK(std::abs(norm(ring[i] - centre) - radius) < 1e-12);
      if (i + 1 == ring.size()) break;
      const Vec2 middle = (ring[i] + ring[i + 1]) * 0.5;
      CHECK(radius - norm(middle - centre) < kChordError_m);
    }
    const double missing = arched_area_m2(kPocket, rise) - signed_area(ring);
    CHECK(missing > 0);
    CHECK(missing < kChordError_m * 1.2 * std::numbers::pi / 2);  // along the longest of these arcs
  }
}

TEST_CASE("polygon_face__triangles_cover_an_outline_that_is_not_convex_but_for_its_openings") {
  const Outline outline{{0, 0}, {8, 1}, {10, 0}, {9, 6}, {6, 3}, {3, 7}, {1, 4}};
  const std::vector<Outline> openings{outline_of({2, 3, 2, 3}), outline_of({7, 8, 2, 3}),
                                      arched_outline({4, 5, 1, 3}, 0.3)};
  SceneBuilder out{Transform{}};
  const uint32_t id = out.polygon_face(out.part("wall", "wall"), kPocketFront, outline, openings);
  const Model model = out.take();
  CHECK(id == 1);
  double area = jalon::signed_area(outline);
  for (const Outline& o : openings) area -= jalon::signed_area(o);
  CHECK(std::abs(model.faces.front().area_m2 - area) < kRounding_m);
  CHECK(std::abs(shell_of(model, {}).area_m2 - area) < kRounding_m);  // none lies on another
  RandomStream random(6, 0);
  for (int k = 0; k < 2000; ++k) {
    const Vec2 p{11 * random.uniform() - 0.5, 8 * random.uniform() - 0.5};
    bool inside = contains(outline, p);
    for (const Outline& o : openings) inside = inside && !contains(o, p);
    REQUIRE(std::isfinite(front_y(model, p.u, p.v)) == inside);
    REQUIRE(is_inside(model, model.faces.front(), {p.u, 0, p.v}, 0) == inside);
  }
}

TEST_CASE("recess__is_a_closed_pocket_with_a_sill_and_open_below_without") {
  constexpr double kDepth_m = 0.3, kArea_m2 = 1.2 * 2;
  for (const bool has_sill : {true, false}) {
    SceneBuilder out{Transform{}};
    out.recess(out.part("window", "window"), kPocketFront, kPocket, kDepth_m, has_sill, 0, 77);
    const Model pocket = out.take();
    CHECK(ids_of(pocket, "pane") == std::set<uint32_t>{77});
    // All surfaces look into the pocket; what closes it, the opening and a missing sill, makes up the vector area.
    const Shell shell = shell_of(pocket, {}, {0, 0, kPocket.v0});
    CHECK(std::abs(shell.volume_m3 + kArea_m2 * kDepth_m) < kRounding_m);
    CHECK(norm(shell.vector_area - Vec3{0, -kArea_m2, has_sill ? 0 : -1.2 * kDepth_m}) <
          kRounding_m);
    if (has_sill) check_holds_all_rays(pocket, outline_of(kPocket), kDepth_m);
    CHECK(std::isfinite(first_hit(pocket, {1.6, 0.1, 1}, {0, 0, -1}).distance) == has_sill);
  }
  SceneBuilder flat{Transform{}};
  flat.recess(flat.part("window", "window"), kPocketFront, kPocket, 0, true, 0);
  CHECK(flat.take().faces.size() == 1);  // the pane alone
}

TEST_CASE("recess__has_a_window_frame_of_8_cm_where_there_is_room_for_one") {
  const auto window = [](const Rect& opening) {
    SceneBuilder out{Transform{}};
    out.recess(out.part("window", "window"), kPocketFront, opening, 0.3, true, 0.05);
    return out.take();
  };
  const Model model = window(kPocket);
  for (const double inward : {0.01, 0.079, 0.081, 0.3}) {
    const double depth = inward < 0.08 ? 0.3 : 0.35;
    CHECK(front_y(model, 1 + inward, 1.5) == doctest::Approx(depth));
    CHECK(front_y(model, 2.2 - inward, 1.5) == doctest::Approx(depth));
    CHECK(front_y(model, 1.6, 0.5 + inward) == doctest::Approx(depth));
    CHECK(front_y(model, 1.6, 2.5 - inward) == doctest::Approx(depth));
  }
  const Model slit = window({1, 1.2, 0.5, 2.5});  // 20 cm: two frames would leave 4 cm of glass
  CHECK(ids_of(slit, "joinery").empty());
  CHECK(front_y(slit, 1.1, 1.5) == doctest::Approx(0.3));
}

TEST_CASE("arched_recess__is_a_closed_pocket_under_a_round_head") {
  constexpr double kDepth_m = 0.25;
  for (const double rise : {0.2, 0.6}) {
    CAPTURE(rise);
    SceneBuilder out{Transform{}};
    out.arched_recess(out.part("window", "window"), kPocketFront, kPocket, rise, kDepth_m, false);
    const Model pocket = out.take();
    const Outline outline = arched_outline(kPocket, rise);
    const double area = jalon::signed_area(outline);
    const Shell shell = shell_of(pocket, {});
    CHECK(norm(shell.vector_area - Vec3{0, -area, 0}) < kRounding_m);
    CHECK(std::abs(shell.volume_m3 + area * kDepth_m) < kRounding_m);
    check_holds_all_rays(pocket, outline, kDepth_m);
    // The head is curved: what a ray upward meets has no face.
    const Hit head = first_hit(pocket, {1.6, 0.1, 1}, {0, 0, 1});
    CHECK(std::abs(1 + head.distance - 2.5) < kChordError_m);
    CHECK(class_of(pocket, head.triangle).empty());
  }
}

TEST_CASE("arched_recess__joinery_is_8_cm_wide_all_round_before_glass_2_cm_behind") {
  for (const double rise : {0.2, 0.6}) {
    CAPTURE(rise);
    SceneBuilder out{Transform{}};
    out.arched_recess(out.part("window", "window"), kPocketFront, kPocket, rise, 0.25, true);
    const Model model = out.take();
    const Outline outline = arched_outline(kPocket, rise);
    RandomStream random(7, 0);
    for (int k = 0; k < 1000; ++k) {
      const Vec2 p{1 + 1.2 * random.uniform(), 0.5 + 2 * random.uniform()};
      const double inward = border_distance(outline, p);
      // Chords of both arcs leave the circle by a tenth of a millimetre each.
      if (!contains(outline, p) || std::abs(inward - 0.08) < 2 * kChordError_m) continue;
      REQUIRE(front_y(model, p.u, p.v) == doctest::Approx(inward < 0.08 ? 0.25 : 0.27));
    }
  }
}
