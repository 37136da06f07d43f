// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "geometry/polygon2.h"
#include "modelling/plane/plane_joints.h"

using namespace jalon;

namespace {

struct Planes {
  std::vector<VectorPlane> planes;
  std::vector<Segment> segments;

  /// A rectangle on a plane through a point, from low to high in the plane's own coordinates relative to that point.
  void add(const Vec3& normal, const Vec3& through, const Vec2& low, const Vec2& high) {
    Segment segment;
    segment.label = static_cast<uint32_t>(segments.size() + 1);
    segment.fit.plane = {normalized(normal), dot(normalized(normal), through)};
    segments.push_back(segment);
    VectorPlane plane;
    plane.label = segment.label;
    plane.frame = plane_frame(segment.fit.plane, {}, {1, 0, 0});
    plane.spacing_m = 0.02;
    const Vec2 o = plane.frame.project(through);
    VectorRing ring;
    ring.corners = {o + low, o + Vec2{high.u, low.v}, o + high, o + Vec2{low.u, high.v}};
    ring.edges.resize(4);
    plane.faces.push_back({ring, {}});
    planes.push_back(plane);
  }
  std::vector<SharedCorner> join(double gap_m = 0) {
    Task task;
    return join_planes(planes, segments, {true, gap_m}, task);
  }
  std::vector<Vec3> corners(size_t plane) const {
    std::vector<Vec3> out;
    for (const Vec2& p : planes[plane].faces[0].outline.corners)
      out.push_back(planes[plane].frame.lift(p));
    return out;
  }
};

double nearest(const std::vector<Vec3>& corners, const Vec3& p) {
  double least = INFINITY;
  for (const Vec3& c : corners) least = std::min(least, norm(c - p));
  return least;
}

// A ring of straight edges, its corners told from its first.
void lay_out(VectorRing& ring, std::vector<Vec2> corners) {
  for (Vec2& c : corners) c = ring.corners[0] + c;
  ring.corners = std::move(corners);
  ring.edges.resize(ring.corners.size());
}

}  // namespace

TEST_CASE("joints: two walls meet in one edge where their planes do") {
  Planes p;
  p.add({0, -1, 0}, {0, 0, 0}, {0, 0}, {4.97, 3});  // along x, ends 3 cm before the corner at x = 5
  p.add({1, 0, 0}, {5, 0, 0}, {0.025, 0.01}, {6, 3.01});  // along y from there, 1 cm higher
  const auto shared = p.join();
  REQUIRE(shared.size() == 2);
  for (const SharedCorner& corner : shared) {
    CHECK(corner.uses.size() == 2);
    CHECK(std::hypot(corner.position.x - 5, corner.position.y) < 1e-12);
    for (const auto& use : corner.uses)
      CHECK(norm(p.planes[use.plane].frame.lift(use.place) - corner.position) < 1e-12);
  }
  CHECK(nearest(p.corners(0), {5, 0, 0.005}) < 1e-12);
  CHECK(nearest(p.corners(1), {5, 0, 3.005}) < 1e-12);
  CHECK(p.planes[0].faces[0].outline.edges[1].source == EdgeSource::kPlanes);
}

TEST_CASE("joints: three planes have their common point, and leaning ones too") {
  Planes p;
  p.add({0.001, -1, 0.002}, {0, 0, 0}, {0.02, 0.02}, {5, 3});
  p.add({-1, 0.002, 0.001}, {0, 0, 0}, {-5, 0.02}, {-0.02, 3.2});
  p.add({0.001, 0.002, 1}, {0, 0, 0}, {0.03, -4}, {4, -0.03});
  const auto shared = p.join();
  size_t triple = 0;
  for (const SharedCorner& corner : shared)
    if (norm(corner.position) < 1e-9) triple = std::max(triple, corner.uses.size());
  CHECK(triple == 3);
  for (size_t k = 0; k < 3; ++k) {
    CHECK(nearest(p.corners(k), {0, 0, 0}) < 1e-9);
    for (const Vec3& corner : p.corners(k))
      CHECK(std::fabs(p.segments[k].fit.plane.distance(corner)) < 1e-12);
  }
}

TEST_CASE("joints: edges too far from a plane, or beside what is there of it, stay") {
  Planes p;
  p.add({0, -1, 0}, {0, 0, 0}, {0, 0},
        {4.9, 3});  // ends 10 cm before the other plane: five spacings
  p.add({1, 0, 0}, {5, 0, 0}, {0, 0}, {6, 3});
  p.add({1, 0, 0}, {0, 20, 0}, {0, 0},
        {6, 3});  // its plane passes the first wall's end, its face does not
  CHECK(p.join().empty());
  CHECK(nearest(p.corners(0), {4.9, 0, 0}) < 1e-12);
  CHECK(p.join(0.2).size() == 2);
  CHECK(nearest(p.corners(0), {5, 0, 0}) < 1e-12);
}

TEST_CASE("joints: a face that would meet its opening keeps its edges") {
  Planes p;
  p.add({0, -1, 0}, {0, 0, 0}, {0, 0}, {5.03, 3});
  p.add({1, 0, 0}, {5, 0, 0}, {0, 0}, {6, 3});
  const Vec2 o = p.planes[0].faces[0].outline.corners[0];
  VectorRing hole;
  hole.corners = {o + Vec2{4, 1}, o + Vec2{4, 2}, o + Vec2{5.02, 2}, o + Vec2{5.02, 1}};
  hole.edges.resize(4);
  p.planes[0].faces[0].openings.push_back(hole);
  p.join();
  CHECK(nearest(p.corners(0), {5.03, 0, 0}) < 1e-12);
}

TEST_CASE("joints: two corners of one outline never become one vertex") {
  // A flat roof with a slit that reaches its eaves, where a wall ends: both banks of the slit are near the wall's end.
  for (const double lean : {0.0, 0.0017, -0.0023, 0.0101}) {
    CAPTURE(lean);
    Planes p;
    p.add({lean, 0.001, 1}, {0, 0, 3}, {0, 0.01}, {4, 2});
    p.add({0.002, -1, lean}, {0, 0, 0}, {0, 0}, {2.012, 2.99});
    lay_out(p.planes[0].faces[0].outline,
            {{0, 0}, {2.0, 0}, {2.0, 1}, {2.025, 1}, {2.025, 0}, {4, 0}, {4, 2}, {0, 2}});
    const auto shared = p.join();
    const std::vector<Vec3> corners = p.corners(0);
    for (size_t i = 0; i < corners.size(); ++i)
      for (size_t j = 0; j < i; ++j) CHECK(norm(corners[i] - corners[j]) > 1e-6);
  }
}

TEST_CASE("joints: a bar narrower than the gap is not folded onto one line") {
  // Two posts under a bar of 2 cm; a lintel at its top, within the gap of both edges of the bar. Turned, so that
  // rounding lays the edges on either side of their line.
  for (int turn = 0; turn < 40; ++turn) {
    const double lean = 0.0013 * turn;
    Planes p;
    p.add({lean, -1, 0.1 * lean}, {0.3, 0.1 * turn, 0}, {0, 0}, {1.4, 2});
    VectorRing& frame = p.planes[0].faces[0].outline;
    lay_out(frame,
            {{0, 0}, {0.15, 0}, {0.15, 1.98}, {1.25, 1.98}, {1.25, 0}, {1.4, 0}, {1.4, 2}, {0, 2}});
    p.add({0.3 * lean, 0.0007, -1}, {0.3, 0.1 * turn, 1.99}, {-1, -1}, {3, 1});
    p.join();
    const std::vector<Vec2>& corners = frame.corners;
    for (size_t i : {2, 3}) CHECK(segment_distance(corners[i], corners[6], corners[7]) > 0.005);
  }
}
