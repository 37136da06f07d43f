// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Planes and areas of bare rings against regular polygons in planes that were chosen, on map coordinates.
#include "formats/face_geometry.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "model/polygon_triangles.h"

using namespace jalon;

namespace {

const Vec3 kPlace{652000, 6861000, 140};
constexpr double kRounding_m = 1e-9;  // of coordinates below 2^23

struct BareFace {
  Model model;
  Face face;
  std::span<const uint32_t> ring(size_t r) const {
    return std::span(model.corners).subspan(model.rings[r].first, model.rings[r].count);
  }
  void add_ring(const std::vector<Vec3>& corners) {
    model.rings.push_back({model.corners.size(), corners.size()});
    ++face.ring_count;
    for (const Vec3& p : corners) {
      model.corners.push_back(static_cast<uint32_t>(model.vertices.size()));
      model.vertices.push_back(p);
    }
  }
};

Vec3 random_direction(RandomStream& random) {
  return normalized({random.normal(), random.normal(), random.normal()});
}

/// Anticlockwise about the normal.
std::vector<Vec3> polygon(int n, double radius_m, const Vec3& centre, const Vec3& normal) {
  const PlaneAxes axes = axes_of(normal);
  std::vector<Vec3> out;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    out.push_back(centre + radius_m * (std::cos(angle) * axes.u + std::sin(angle) * axes.v));
  }
  return out;
}
double polygon_area(int n, double radius_m) {
  return n * radius_m * radius_m * std::sin(2 * std::numbers::pi / n) / 2;
}

}  // namespace

TEST_CASE("face_geometry__a_face_has_the_plane_and_area_it_was_made_with_holes_taken_off") {
  RandomStream random(1, 1);
  for (int round = 0; round < 100; ++round) {
    const int n = 3 + static_cast<int>(random.below(20));
    const Vec3 normal = random_direction(random), beside = axes_of(normal).u;
    BareFace given;
    given.add_ring(polygon(n, 10, kPlace, normal));
    given.add_ring(polygon(6, 1, kPlace + 1.5 * beside, normal));   // runs as the outline does
    given.add_ring(polygon(5, 1, kPlace - 1.5 * beside, -normal));  // runs clockwise already
    REQUIRE(measure_face(given.model, given.face));
    const double perimeter_m = 2 * std::numbers::pi * 12;
    const double area_m2 = polygon_area(n, 10) - polygon_area(6, 1) - polygon_area(5, 1);
    CHECK(std::fabs(given.face.area_m2 - area_m2) <= perimeter_m * kRounding_m);
    // A corner that is rounded turns the plane of a triangle by less than its error over 5 m.
    CHECK(norm(given.face.plane.normal - normal) <= kRounding_m);
    CHECK(std::fabs(given.face.plane.distance(kPlace)) <= 10 * kRounding_m);
    for (const size_t hole : {1, 2})
      CHECK(dot(twice_area(given.model, given.ring(hole), kPlace), normal) < 0);
    CHECK(given.ring(0)[0] == 0);
    CHECK(given.ring(1)[0] == static_cast<uint32_t>(n) + 5);  // turned
    CHECK(given.ring(2)[0] == static_cast<uint32_t>(n) + 6);  // not turned
  }
}

TEST_CASE("face_geometry__vector_areas_of_a_closed_body_cancel_about_any_origin") {
  RandomStream random(2, 1);
  Model model;
  for (int i = 0; i < 4; ++i) model.vertices.push_back(kPlace + 5.0 * random_direction(random));
  const uint32_t kSides[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const Vec3& origin : {kPlace, kPlace + Vec3{20, -30, 10}}) {
    Vec3 sum;
    for (const auto& side : kSides) {
      const Vec3 twice = twice_area(model, side, origin);
      const Vec3 &a = model.vertices[side[0]], &b = model.vertices[side[1]],
                 &c = model.vertices[side[2]];
      CHECK(norm(twice - cross(b - a, c - a)) <=
            1e-11);  // products below 2000 m2, twelve roundings
      sum += twice;
      const std::vector<uint32_t> turned{side[2], side[1], side[0]};
      CHECK(norm(twice + twice_area(model, turned, origin)) <= 1e-11);
    }
    CHECK(norm(sum) <= 4e-11);
  }
}

TEST_CASE("face_geometry__an_outline_without_area_sets_nothing") {
  const Vec3 a = kPlace, b = kPlace + Vec3{8, 0, 0}, c = kPlace + Vec3{2, 0, 0};
  const std::vector<std::vector<Vec3>> kFlat = {{},        {a},       {a, b},
                                                {a, c, b}, {a, a, a}, {a, b, c, b}};
  for (const std::vector<Vec3>& outline : kFlat) {
    BareFace given;
    given.add_ring(outline);
    given.face.area_m2 = 17;
    given.face.plane = {{1, 0, 0}, 42};
    CHECK_FALSE(measure_face(given.model, given.face));
    CHECK(given.face.area_m2 == 17);
    CHECK(given.face.plane.normal == Vec3{1, 0, 0});
    CHECK(given.face.plane.offset == 42);
  }
  BareFace thin;  // a millionth as wide as long is a face all the same
  thin.add_ring({{0, 0, 0}, {8, 0, 0}, {8, 8e-6, 0}, {0, 8e-6, 0}});
  REQUIRE(measure_face(thin.model, thin.face));
  CHECK(thin.face.plane.normal == Vec3{0, 0, 1});
  CHECK(thin.face.area_m2 == doctest::Approx(64e-6).epsilon(1e-12).scale(0));
}

TEST_CASE("face_geometry__the_plane_of_a_bent_outline_halves_its_corners") {
  BareFace given;
  given.add_ring({kPlace + Vec3{0, 0, 0.25}, kPlace + Vec3{2, 0, -0.25}, kPlace + Vec3{2, 2, 0.25},
                  kPlace + Vec3{0, 2, -0.25}});
  REQUIRE(measure_face(given.model, given.face));
  CHECK(norm(given.face.plane.normal - Vec3{0, 0, 1}) <= 1e-12);  // the diagonals are level
  for (int i = 0; i < 4; ++i)
    CHECK(std::fabs(given.face.plane.distance(given.model.vertices[static_cast<size_t>(i)])) ==
          doctest::Approx(0.25).epsilon(1e-6).scale(0));
}
