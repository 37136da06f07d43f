// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Boxes and polygons of rings against the rectangles and circles that they were made from, anywhere and at any turn.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "report/elevation/face_rings.h"
#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

// A face in the upright plane through `at` along (cos, sin), its rings given as (along, height) from there.
Model upright_face(const Vec3& at, double azimuth, const std::vector<std::vector<Vec2>>& rings,
                   const std::vector<double>& sagittas = {}) {
  const Vec3 along{std::cos(azimuth), std::sin(azimuth), 0}, normal{along.y, -along.x, 0};
  std::vector<std::vector<Vec3>> lifted;
  for (const auto& ring : rings) {
    lifted.emplace_back();
    for (const Vec2& p : ring) lifted.back().push_back(at + along * p.u + Vec3{0, 0, p.v});
  }
  Model out;
  named_facade::add(out, 0, {normal, dot(normal, at)}, lifted, sagittas, 1, 1);
  return out;
}

std::vector<Vec2> rectangle_at(double u, double v, double width, double height) {
  return {{u, v}, {u + width, v}, {u + width, v + height}, {u, v + height}};
}

}  // namespace

TEST_CASE("face_rings__boxes_have_the_size_of_their_openings_at_every_azimuth") {
  RandomStream random(1, 0);
  for (int trial = 0; trial < 100; ++trial) {
    CAPTURE(trial);
    const double azimuth = 2 * std::numbers::pi * random.uniform(), width = 5 * random.uniform(),
                 height = 5 * random.uniform();
    const Model m = upright_face({652000.3, 6861000.7, 137.1}, azimuth,
                                 {rectangle_at(0, 0, 20, 10), rectangle_at(3, 2, width, height)});
    const FaceBox box = ring_box(m, {0, 1});
    // Coordinates of the grid are rounded to 2^-30 m.
    CHECK(std::fabs(box.width() - width) < 4 * 0x1p-30);
    CHECK(std::fabs(box.height() - height) < 4 * 0x1p-30);
    // To the right for an eye in front: the opening lies 3 m right of the outline's left side, 2 m above its foot.
    const FaceBox outline = ring_box(m, {0, 0});
    CHECK(std::fabs(box.left - outline.left - 3) < 4 * 0x1p-30);
    CHECK(std::fabs(box.low - outline.low - 2) < 4 * 0x1p-30);
    FaceBox both = box;
    both += outline;
    CHECK(both.width() == outline.width());
  }
}

TEST_CASE("face_rings__a_circle_of_arcs_is_round_to_a_millimetre") {
  const double r = 1.7;
  const Model m =
      upright_face({3, 4, 5}, 0.7, {{{-r, 0}, {r, 0}}, rectangle_at(0, 0, 1, 1)}, {r, r});
  CHECK(has_arc(m, m.rings[0]));
  CHECK(!has_arc(m, m.rings[1]));
  const auto polygon = ring_polygon(m, m.rings[0], frame_of(m, m.faces[0]));
  // Anticlockwise; chords at most e inside the circle lose less than 2 pi r e of its area.
  const double area = std::numbers::pi * r * r, lost = area - signed_area(polygon);
  CHECK(lost > 0);
  CHECK(lost < 2 * std::numbers::pi * r * kChordError_m);
  const FaceBox box = ring_box(m, {0, 0});
  for (const double size : {box.width(), box.height()}) {
    CHECK(size <= 2 * r + 1e-12);
    CHECK(size > 2 * r - 2 * kChordError_m);
  }
}

TEST_CASE("face_rings__a_shift_by_whole_metres_changes_no_bit") {
  const std::vector<std::vector<Vec2>> rings{rectangle_at(0.125, 0.25, 4, 3)};
  const Model near = upright_face({1, 2.5, 3}, 0, rings),
              far = upright_face({652001, 6861002.5, 1003}, 0, rings);
  const PlaneFrame a = frame_of(near, near.faces[0]), b = frame_of(far, far.faces[0]);
  CHECK(a.origin == Vec3{1, 2, 3});
  CHECK(b.origin == Vec3{652001, 6861002, 1003});
  CHECK(ring_polygon(near, near.rings[0], a) == ring_polygon(far, far.rings[0], b));
  CHECK(cross(a.axis_u, a.axis_v) == near.faces[0].plane.normal);
  // A face without rings has its frame at the origin.
  Face bare;
  bare.plane = {{0, 0, 1}, 4};
  CHECK(frame_of(near, bare).origin == Vec3{});
  CHECK(frame_of(near, bare).lift({0, 0}).z == 4);
}
