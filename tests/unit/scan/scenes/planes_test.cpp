// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// The small scenes of planes: how far their pieces are apart, and what rays meet where pieces meet.

namespace {

/// Distance of two pieces that are parallel to the axes, as boxes.
double piece_distance(const Model& model, const Face& a, const Face& b) {
  const auto bounds_of = [&](const Face& face) {
    Box3 box;
    const Ring& ring = model.rings[face.first_ring];
    for (uint64_t k = ring.first; k < ring.first + ring.count; ++k)
      box.add(model.vertices[model.corners[k]]);
    return box;
  };
  const Box3 p = bounds_of(a), q = bounds_of(b);
  Vec3 gap;
  for (int i = 0; i < 3; ++i) gap[i] = std::max({0.0, p.min[i] - q.max[i], q.min[i] - p.max[i]});
  return norm(gap);
}

}  // namespace

TEST_CASE("scene_std__has_ten_planes_of_mixed_sizes_a_metre_or_more_apart") {
  const Model model = built(build_std);
  REQUIRE(model.faces.size() == 10);
  int forward = 0, sideways = 0, up = 0;
  for (size_t i = 0; i < 10; ++i) {
    const Face& face = model.faces[i];
    forward += face.plane.normal == Vec3{0, -1, 0};
    sideways += std::abs(face.plane.normal.x) == 1;
    up += face.plane.normal == Vec3{0, 0, 1};
    CHECK(face.area_m2 >= 1);
    CHECK(face.area_m2 <= 24);
    for (size_t j = 0; j < i; ++j) {
      CAPTURE(i);
      CAPTURE(j);
      CHECK(piece_distance(model, face, model.faces[j]) >= 1);
    }
  }
  CHECK(forward == 6);
  CHECK(sideways == 2);
  CHECK(up == 2);
}

TEST_CASE("scene_normal_and_patches__are_one_plane_in_one_piece_and_in_two") {
  const Model plane = built(build_normal);
  REQUIRE(plane.faces.size() == 1);
  CHECK(plane.faces[0].area_m2 == 100);
  for (const double x : {0.01, 9.99}) CHECK(front_y(plane, x, 9.99) == 0);
  CHECK(std::isinf(front_y(plane, 10.01, 5)));

  const Model patches = built(build_patches);
  REQUIRE(patches.faces.size() == 2);
  CHECK(patches.faces[0].plane.normal == patches.faces[1].plane.normal);
  CHECK(patches.faces[0].plane.offset == patches.faces[1].plane.offset);
  CHECK(patches.faces[0].id != patches.faces[1].id);
  CHECK(piece_distance(patches, patches.faces[0], patches.faces[1]) == 1);
}

TEST_CASE("scene_sills__are_4_m_apart_and_the_gap_before_the_wall") {
  for (const double gap : {0.0, 0.1, 1.0}) {
    CAPTURE(gap);
    const Model model = built(build_sills, {.gap_m = gap});
    REQUIRE(model.faces.size() == 3);
    for (size_t i = 1; i < 3; ++i) {
      CHECK(model.parts[model.faces[i].part].parent == model.faces[0].part);
      CHECK(piece_distance(model, model.faces[0], model.faces[i]) == doctest::Approx(gap));
      CHECK(model.faces[i].area_m2 == doctest::Approx(0.3));  // whatever the gap
    }
    CHECK(piece_distance(model, model.faces[1], model.faces[2]) == doctest::Approx(4));
    // Seen from above: sill, gap, nothing beside.
    CHECK(top_z(model, 2.5, -gap - 0.15) == doctest::Approx(1));
    CHECK(std::isinf(top_z(model, 2.5, -gap + 0.001)));
    CHECK(std::isinf(top_z(model, 3.1, -gap - 0.15)));
  }
}

TEST_CASE("scene_robbery__has_a_shelf_on_the_wall_or_through_it") {
  for (const bool crossing : {false, true}) {
    CAPTURE(crossing);
    const Model model = built(build_robbery, {.depth_m = 0.4, .crossing = crossing});
    REQUIRE(model.faces.size() == 2);
    CHECK(piece_distance(model, model.faces[0], model.faces[1]) == 0);
    CHECK(model.faces[1].area_m2 == doctest::Approx(0.4 * 10));
    const double shelf = top_z(model, 5, -0.001);
    CHECK(shelf == doctest::Approx(3));
    CHECK(std::isfinite(top_z(model, 5, -0.19)));
    CHECK(std::isfinite(top_z(model, 5, -0.39)) == !crossing);
    CHECK(std::isfinite(top_z(model, 5, 0.19)) == crossing);
    CHECK(std::isinf(top_z(model, 5, crossing ? 0.21 : 0.01)));
    for (const double z : {1.0, 5.0}) CHECK(front_y(model, 5, z) == 0);  // the wall goes on above
  }
}
