// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Sides and volumes of meshes that were built closed, and then cut, turned and moved.
#include "compare/volumes/mesh_closure.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/rigid_motion.h"

using namespace jalon;

namespace {

struct ClosedMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;

  MeshClosure closure() const {
    Task task;
    return closure_of(vertices, triangles, task);
  }
  double volume() const {
    Task task;
    return enclosed_volume(vertices, triangles, task);
  }
  /// Each triangle with corners of its own.
  ClosedMesh loose() const {
    ClosedMesh out;
    for (const auto& t : triangles) {
      const auto n = static_cast<uint32_t>(out.vertices.size());
      for (const uint32_t v : t) out.vertices.push_back(vertices[v]);
      out.triangles.push_back({n, n + 1, n + 2});
    }
    return out;
  }
  ClosedMesh& operator+=(const ClosedMesh& b) {
    const auto n = static_cast<uint32_t>(vertices.size());
    vertices.insert(vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& t : b.triangles) triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    return *this;
  }
};

/// An octahedron, anticlockwise seen from outside: of volume 4 / 3 r^3.
ClosedMesh octahedron(double r, const Vec3& at = {}) {
  ClosedMesh out;
  for (const Vec3& p : {Vec3{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}})
    out.vertices.push_back(at + p);
  out.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                   {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return out;
}

}  // namespace

TEST_CASE("mesh_closure__joins_corners_by_their_coordinates") {
  ClosedMesh loose = octahedron(2).loose();
  CHECK(loose.closure().is_closed());
  for (size_t i = 0; i < loose.vertices.size(); i += 2)  // another zero is the same place
    if (loose.vertices[i].x == 0) loose.vertices[i].x = -0.0;
  CHECK(loose.closure().is_closed());
  loose.vertices[0].x =
      std::nextafter(loose.vertices[0].x, 3);  // 2 of its triangle's sides come off
  CHECK(loose.closure().border_sides == 4);
}

TEST_CASE("mesh_closure__counts_sides_at_borders_and_sides_run_the_same_way_twice") {
  ClosedMesh one = octahedron(1), two = one, turned = one;
  one.triangles.pop_back();
  CHECK(one.closure().border_sides == 3);
  CHECK(one.closure().inconsistent_sides == 0);
  two.triangles.resize(6);  // two that share a side
  CHECK(two.closure().border_sides == 4);
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  CHECK(turned.closure().border_sides == 0);
  CHECK(turned.closure().inconsistent_sides == 3);
  CHECK_FALSE(turned.closure().is_closed());
  // Triangles without area change nothing.
  ClosedMesh spiked = octahedron(1);
  spiked.triangles.push_back({0, 0, 4});
  spiked.triangles.push_back({1, 5, 1});
  CHECK(spiked.closure().is_closed());
  // Two bodies that touch in a corner or along a side are closed, one inside out in another as well.
  ClosedMesh touching = octahedron(1);
  touching += octahedron(1, {2, 0, 0});
  CHECK(touching.closure().is_closed());
  CHECK(ClosedMesh{}.closure().is_closed());
}

TEST_CASE("mesh_closure__volumes_are_exact_signed_and_free_of_place_and_turn") {
  const double truth = 4.0 / 3 * 8;
  CHECK(octahedron(2).volume() == doctest::Approx(truth).epsilon(1e-14));
  ClosedMesh inside_out = octahedron(2);
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  CHECK(inside_out.volume() == doctest::Approx(-truth).epsilon(1e-14));
  ClosedMesh far = octahedron(2).loose();
  const Transform place = motion_about({}, {1, -0.4, 2}, {652000, 6861000, 100});
  for (Vec3& p : far.vertices) p = place.point(p);
  // Coordinates of 7 digits leave 1e-9 m of a surface of 28 m2.
  CHECK(std::fabs(far.volume() - truth) < 28e-9);
  ClosedMesh hollow = octahedron(2);
  ClosedMesh hole = octahedron(1);
  for (auto& t : hole.triangles) std::swap(t[0], t[1]);
  hollow += hole;
  CHECK(hollow.closure().is_closed());
  CHECK(hollow.volume() == doctest::Approx(truth - 4.0 / 3).epsilon(1e-14));
  CHECK(ClosedMesh{}.volume() == 0);
}
