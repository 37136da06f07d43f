// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Curved parts of contours, and edges at reveals.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "model/topology.h"
#include "unit/modelling/sampled_wall.h"

using namespace walls;

namespace {

size_t trials() {
  if (std::getenv("JALON_FULL") != nullptr) return 200;
  return std::getenv("JALON_SANITIZED") != nullptr ? 2 : 20;
}

/// A window with a round head: half circle or segment of a circle over an upright rectangle.
struct Arched {
  double left, right, sill, spring, rise;
  double half() const { return (right - left) / 2; }
  Vec2 centre() const { return {(left + right) / 2, spring + rise - radius()}; }
  double radius() const { return (half() * half() + rise * rise) / (2 * rise); }
  bool contains(double u, double v) const {
    if (u <= left || u >= right || v <= sill) return false;
    return v <= spring || norm(Vec2{u, v} - centre()) < radius();
  }
};

SampledWall wall_with(const Arched& window, Sampling sampling, uint64_t seed) {
  SampledWall wall;
  wall.seed = seed;
  wall.sampling = sampling;
  wall.solid = [window](double u, double v) {
    return u > 0 && v > 0 && u < 3 && v < 2.5 && !window.contains(u, v);
  };
  return wall;
}

Arched window_of(RandomStream& random, double rise) {
  Arched out{0.7 + 0.2 * random.uniform(), 0, 0.3 + 0.1 * random.uniform(),
             1.5 + 0.1 * random.uniform(), rise};
  out.right = out.left + 1.2;
  return out;
}

}  // namespace

TEST_CASE("vectorise__round_and_segmental_heads_come_out_as_one_arc") {
  for (const double rise : {0.6, 0.2})
    for (const Sampling sampling : kSamplings) {
      Errors centre, radius, spring;
      for (size_t k = 0; k < trials(); ++k) {
        RandomStream random(k, 5);
        const Arched window = window_of(random, rise);
        const SampledWall wall = wall_with(window, sampling, k + 1);
        const VectorPlane plane = vectorised(segmentation_of({wall.points()}));
        REQUIRE(plane.faces.size() == 1);
        REQUIRE(plane.faces[0].openings.size() == 1);
        const VectorRing& ring = plane.faces[0].openings[0];
        REQUIRE(ring.corners.size() == 4);
        size_t arcs = 0;
        for (size_t i = 0; i < 4; ++i) {
          const VectorEdge& edge = ring.edges[i];
          CHECK((edge.direction == EdgeDirection::kArc) == (edge.sagitta_m != 0));
          if (edge.sagitta_m == 0) continue;
          ++arcs;
          CHECK(edge.sagitta_m < 0);  // openings run clockwise
          const Vec2 a = on_wall(plane, ring.corners[i]),
                     b = on_wall(plane, ring.corners[(i + 1) % 4]);
          const Arc2 arc = arc_of(a, b, edge.sagitta_m);
          const Vec2 off = arc.centre - window.centre();
          centre.add(off.u / wall.spacing);
          centre.add(off.v / wall.spacing);
          radius.add((arc.radius - window.radius()) / wall.spacing);
          spring.add((a.v - window.spring) / wall.spacing);
          spring.add((b.v - window.spring) / wall.spacing);
        }
        CHECK(arcs == 1);
      }
      MESSAGE("FIGURE arcs of rise " << rise << " m, " << std::string(name_of(sampling))
                                     << ": centre RMS " << centre.rms() << " worst " << centre.worst
                                     << " spacings, radius bias " << radius.mean() << " RMS "
                                     << radius.rms() << ", springings RMS " << spring.rms());
      if (rise < 0.5)
        continue;  // of a flat arc centre and radius are known far less than its points
      CHECK(centre.worst <= 0.5);
      CHECK(radius.worst <= 0.5);
      CHECK(spring.rms() <= 0.3);
    }
}

TEST_CASE("vectorise__a_round_opening_and_a_straight_edge_are_told_apart") {
  SampledWall wall;
  wall.sampling = Sampling::kTurnedGrid;
  wall.solid = [](double u, double v) {
    return u > 0 && v > 0 && u < 3 && v < 2.5 && std::hypot(u - 1.5, v - 1.2) > 0.4;
  };
  const VectorPlane plane = vectorised(segmentation_of({wall.points()}));
  REQUIRE(plane.faces.size() == 1);
  REQUIRE(plane.faces[0].openings.size() == 1);
  const VectorRing& circle = plane.faces[0].openings[0];
  REQUIRE(circle.corners.size() == 4);
  for (const VectorEdge& edge : circle.edges) CHECK(edge.sagitta_m < 0);
  CHECK(std::fabs(signed_area(circle) / (-3.14159265358979 * 0.16) - 1) < 0.01);
  for (const VectorEdge& edge : plane.faces[0].outline.edges) CHECK(edge.sagitta_m == 0);
  const VectorPlane lines = vectorised(segmentation_of({wall.points()}), R"({"arcs": false})");
  for (const VectorEdge& edge : lines.faces[0].openings[0].edges) CHECK(edge.sagitta_m == 0);
}

TEST_CASE("vectorise__reveals_fix_the_edges_that_end_at_them") {
  Errors seen, unseen, scaled;
  for (size_t k = 0; k < trials(); ++k) {
    RandomStream random(k, 7);
    const Rectangle hole{0.8 + 0.1 * random.uniform(), 0.6 + 0.1 * random.uniform(),
                         2.0 + 0.1 * random.uniform(), 1.8 + 0.1 * random.uniform()};
    SampledWall wall;
    wall.seed = k + 1;
    wall.solid = [&](double u, double v) {
      return u > 0 && v > 0 && u < 3 && v < 2.5 && !hole.contains(u, v);
    };
    auto points = wall.points();
    // The left reveal, 0.2 m deep behind the wall, square but for half a degree; the pane behind.
    std::vector<Vec3> reveal, pane;
    const double lean = 0.008 * random.normal();
    for (double depth = 0; depth < 0.2; depth += 0.02)
      for (double v = hole.bottom + 0.01 * random.uniform(); v < hole.top; v += 0.015) {
        const Vec3 p{hole.left + lean * depth + 0.002 * random.normal(),
                     depth + 0.003 * random.normal(), v};
        (p.y < 0.02 ? points : reveal).push_back(p);  // the wall takes what lies in its plane
      }
    for (double u = hole.left + 0.2 * lean + 0.0075; u < hole.right; u += 0.015)
      for (double v = hole.bottom; v < hole.top; v += 0.015)
        pane.push_back({u, 0.2 + 0.003 * random.normal(), v});
    const VectorPlane plane = vectorised(segmentation_of({points, reveal, pane}));
    REQUIRE(plane.faces.size() == 1);
    REQUIRE(plane.faces[0].openings.size() == 1);
    const VectorRing& ring = plane.faces[0].openings[0];
    REQUIRE(ring.corners.size() == 4);
    for (size_t i = 0; i < 4; ++i) {
      const Vec2 a = on_wall(plane, ring.corners[i]), b = on_wall(plane, ring.corners[(i + 1) % 4]);
      if (std::fabs(a.u - b.u) > 0.1) continue;
      const bool is_left = std::fabs(a.u - hole.left) < 0.1;
      CHECK((ring.edges[i].source == EdgeSource::kReveal) == is_left);
      const double error = is_left ? a.u - hole.left : a.u - hole.right;
      (is_left ? seen : unseen).add(error);
      if (is_left) scaled.add(error / ring.edges[i].sigma_m);
    }
  }
  MESSAGE("FIGURE edges at reveals: RMS " << 1000 * seen.rms() << " mm, bias " << 1000 * seen.mean()
                                          << " mm, error / sigma RMS " << scaled.rms()
                                          << "; others RMS " << 1000 * unseen.rms() << " mm");
  CHECK(seen.rms() < 0.001);
  CHECK(std::fabs(seen.mean()) < 0.0005);
  if (trials() < 20) return;  // too few to say how far errors scatter
  CHECK(scaled.rms() > 0.5);
  CHECK(scaled.rms() < 1.5);
}

TEST_CASE("vectorise__the_soffit_of_a_segmental_arch_fixes_its_radius") {
  Errors radius, centre;
  for (size_t k = 0; k < trials(); ++k) {
    RandomStream random(k, 9);
    const Arched window = window_of(random, 0.2);
    SampledWall wall = wall_with(window, Sampling::kTurnedGrid, k + 1);
    wall.spacing = 0.026;
    auto points = wall.points();
    // The soffit, 0.2 m deep behind the wall, as rows of a scan from below.
    std::vector<Vec3> soffit;
    for (double depth = 0.05 * random.uniform(); depth < 0.2; depth += 0.05)
      for (double u = window.left + 0.015 * random.uniform(); u < window.right; u += 0.026) {
        const Vec2 c = window.centre();
        const double r = window.radius() + 0.002 * random.normal();
        const Vec3 p{u, depth + 0.003 * random.normal(),
                     c.v + std::sqrt(r * r - (u - c.u) * (u - c.u))};
        (p.y < 0.01 ? points : soffit).push_back(p);
      }
    const VectorPlane plane = vectorised(segmentation_of({points, soffit}));
    REQUIRE(plane.faces.size() == 1);
    REQUIRE(plane.faces[0].openings.size() == 1);
    const VectorRing& ring = plane.faces[0].openings[0];
    const size_t n = ring.corners.size();
    for (size_t i = 0; i < n; ++i) {
      if (ring.edges[i].sagitta_m == 0) continue;
      CHECK(ring.edges[i].source == EdgeSource::kReveal);
      const Vec2 a = on_wall(plane, ring.corners[i]), b = on_wall(plane, ring.corners[(i + 1) % n]);
      const Arc2 arc = arc_of(a, b, ring.edges[i].sagitta_m);
      radius.add((arc.radius - window.radius()) / wall.spacing);
      centre.add(norm(arc.centre - window.centre()) / wall.spacing);
    }
  }
  MESSAGE("FIGURE segmental arches with a soffit: radius RMS "
          << radius.rms() << " worst " << radius.worst << " spacings, centre worst "
          << centre.worst);
  CHECK(radius.n == static_cast<double>(trials()));
  CHECK(radius.worst <= 0.5);
  CHECK(centre.worst <= 0.5);
}
