// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/polygon_triangles.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "geometry/polygon2.h"

using namespace jalon;

namespace {

using Rings = std::vector<std::vector<Vec2>>;
using Triangles = std::vector<std::array<uint32_t, 3>>;

std::vector<Vec2> box(double u0, double v0, double u1, double v1) {
  return {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
}

// A star about the origin: many reflex corners.
std::vector<Vec2> star(size_t n, uint64_t seed) {
  RandomStream random(seed, 6);
  std::vector<Vec2> out;
  for (size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double r = 1 + 3 * random.uniform();
    out.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return out;
}

std::vector<Vec2> corners_of(const Rings& rings) {
  std::vector<Vec2> out;
  for (const auto& ring : rings) out.insert(out.end(), ring.begin(), ring.end());
  return out;
}

// Anticlockwise all of them, covering the area, each point of the region in one of them and none outside it.
void check_covers(const Rings& rings, double area) {
  const Triangles triangles = triangulate(rings);
  const auto corners = corners_of(rings);
  double sum = 0;
  for (const auto& t : triangles) {
    const double twice = cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]);
    CHECK(twice > -1e-12);
    sum += twice / 2;
  }
  CHECK(sum == doctest::Approx(area).epsilon(1e-9));
  RandomStream random(3, 7);
  for (int i = 0; i < 300; ++i) {
    const Vec2 p{10 * random.uniform() - 5, 10 * random.uniform() - 5};
    bool inside = contains(rings[0], p);
    for (size_t r = 1; r < rings.size(); ++r) inside = inside && !contains(rings[r], p);
    int holders = 0;
    for (const auto& t : triangles)
      holders += contains(std::vector<Vec2>{corners[t[0]], corners[t[1]], corners[t[2]]}, p);
    CHECK(holders == (inside ? 1 : 0));
  }
}

}  // namespace

TEST_CASE("triangulate__stars__n_minus_2_triangles_that_cover_them_in_either_sense") {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    Rings rings{star(40, seed)};
    CHECK(triangulate(rings).size() == 38);
    const double area = std::fabs(signed_area(rings[0]));
    check_covers(rings, area);
    std::reverse(rings[0].begin(), rings[0].end());
    check_covers(rings, area);
  }
}

TEST_CASE("triangulate__openings_stay_open_whatever_their_sense") {
  Rings rings{box(-4, -4, 4, 4), box(-3, -3, -1, 2), box(0, -2, 3, 0), box(1, 1, 2, 3)};
  std::reverse(rings[2].begin(), rings[2].end());
  CHECK(triangulate(rings).size() == 16 + 2 * 3 - 2);  // corners + 2 per opening - 2
  check_covers(rings, 64 - 10 - 6 - 2);
  // An opening that touches the outline, and two that touch each other, in a corner.
  check_covers({box(-4, -4, 4, 4), {{-4, 0}, {-2, -1}, {-2, 1}}, box(0, 0, 1, 1), box(1, 1, 2, 2)},
               64 - 2 - 1 - 1);
}

TEST_CASE("triangulate__too_few_corners__nothing") {
  CHECK(triangulate({}).empty());
  CHECK(triangulate({{}}).empty());
  CHECK(triangulate({{{0, 0}, {1, 0}}}).empty());
  CHECK(triangulate({{{0, 0}, {1, 0}, {0, 1}}}).size() == 1);
  check_covers({{{0, 0}, {0, 3}, {4, 0}}}, 6);
}

TEST_CASE("triangles_of_face__run_anticlockwise_seen_against_the_normal") {
  RandomStream random(5, 5);
  for (int i = 0; i < 20; ++i) {
    const Vec3 normal = normalized(Vec3{random.normal(), random.normal(), random.normal()});
    const PlaneAxes axes = axes_of(normal);
    CHECK(norm(cross(axes.u, axes.v) - normal) < 1e-12);
    std::vector<std::vector<Vec3>> rings;
    for (const auto& ring : Rings{box(0, 0, 4, 3), box(1, 1, 2, 2)}) {
      rings.emplace_back();
      for (const Vec2& p : ring) rings.back().push_back(p.u * axes.u + p.v * axes.v);
    }
    CHECK(norm(newell_normal(rings[0]) - 24 * normal) < 1e-12);
    Model model;
    Face face;
    if (i % 2 == 0) face.plane.normal = normal;
    else face.plane.normal = {0, 0, 0};  // not told: that of the outline
    model.add_face(face, rings);
    Vec3 sum;
    for (const auto& t : triangles_of_face(model, model.faces[0])) {
      const Vec3 &a = model.vertices[t[0]], &b = model.vertices[t[1]], &c = model.vertices[t[2]];
      sum += 0.5 * cross(b - a, c - a);
    }
    CHECK(norm(sum - 11 * normal) < 1e-12);
  }
}

TEST_CASE("append_polygon__triangles_of_its_id_and_which_of_them_are_loose") {
  Model model;
  model.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, 1, 0}, {0, 3, 0}};  // a reflex corner
  append_polygon(model, std::vector<uint32_t>{0, 1, 2, 3, 4}, 7);
  append_polygon(model, std::vector<uint32_t>{0, 1, 3}, 2);
  append_polygon(model, std::vector<uint32_t>{0, 1}, 9);
  REQUIRE(model.triangle_faces == std::vector<uint32_t>{7, 7, 7, 2});
  double area = 0;
  for (size_t t = 0; t < 3; ++t) {
    const auto& v = model.triangles[t];
    area += cross(model.vertices[v[1]] - model.vertices[v[0]],
                  model.vertices[v[2]] - model.vertices[v[0]])
                .z /
            2;
  }
  CHECK(area == doctest::Approx(8));
  CHECK(loose_triangles(model) == std::vector<uint32_t>{0, 1, 2, 3});
  CHECK_FALSE(is_mesh_by_part(model));
  model.parts.resize(8);
  CHECK(is_mesh_by_part(model));
  model.triangle_faces[3] = 8;  // no such part
  CHECK_FALSE(is_mesh_by_part(model));
  Face face;
  face.id = 7;
  model.faces.push_back(face);
  CHECK(loose_triangles(model) == std::vector<uint32_t>{3});
}
