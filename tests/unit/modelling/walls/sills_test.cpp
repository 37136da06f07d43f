// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Openings above sills that stand out.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/plane/ring_tools.h"
#include "modelling/walls/sills.h"
#include "unit/modelling/upright_planes.h"

using namespace jalon;
using namespace upright_planes;

namespace {

void check_box(const WallHole& hole, double u0, double u1, double v0, double v1) {
  const RingBox box = ring_box(hole.outline);
  CHECK(std::fabs(box.low.u - u0) < 0.02);
  CHECK(std::fabs(box.high.u - u1) < 0.02);
  CHECK(std::fabs(box.low.v - v0) <= 2 * kSpacing_m);
  CHECK(std::fabs(box.high.v - v1) <= 2 * kSpacing_m);
}

HolePoint point(double u, double v, double w) {
  return {0, 0, static_cast<float>(u), static_cast<float>(v), static_cast<float>(w)};
}

/// An opening from 1.0 to 2.2 m and 1 to 3 m whose hole goes on below, as wide as a sill of 1.4 m.
VectorRing hole_over_sill() {
  return ring_of(
      {{0.9, 0.9}, {2.3, 0.9}, {2.3, 1.0}, {2.2, 1.05}, {2.2, 3}, {1, 3}, {1, 1.05}, {0.9, 1.0}});
}
std::vector<VectorPlane> wall_with_hole() {
  std::vector<VectorPlane> planes{plane_of({rectangle(0, 4, 0, 5)})};
  planes[0].faces[0].openings.push_back(reversed(hole_over_sill()));
  return planes;
}
WallSurvey survey_of(std::vector<HolePoint> points) {
  WallSurvey survey;
  survey.tolerance_m = 0.03;
  survey.holes.push_back({});
  survey.holes[0].points = std::move(points);
  return survey;
}
std::vector<HolePoint> bar_of_points() {
  std::vector<HolePoint> points;
  for (double u = 0.9; u <= 2.3; u += kSpacing_m)
    for (double v = 0.91; v < 1; v += 0.03) points.push_back(point(u, v, 0.12));
  for (double v = 1.2; v < 3; v += 0.1) points.push_back(point(1.6, v, -0.2));
  return points;
}

}  // namespace

TEST_CASE("sills__an_opening_ends_at_the_upper_edge_of_a_sill_that_is_a_plane") {
  auto planes = wall_with_hole();
  planes.push_back(plane_of({rectangle(0.9, 2.3, 0.9, 1.0)}, 0.12));
  std::vector<WallHole> holes(1);
  holes[0].outline = hole_over_sill();
  end_at_sills(planes, 0, survey_of({}), 0.3, holes);
  CHECK(holes[0].ends_at_sill);
  check_box(holes[0], 1, 2.2, 1, 3);
  CHECK(ring_box(holes[0].outline).low.v == doctest::Approx(1.0));
  // The wall's face has the same hole.
  CHECK(reversed(planes[0].faces[0].openings[0]).corners == holes[0].outline.corners);
}

TEST_CASE("sills__are_found_from_the_points_before_the_foot_of_the_opening") {
  auto planes = wall_with_hole();
  std::vector<WallHole> holes(1);
  holes[0].outline = hole_over_sill();
  end_at_sills(planes, 0, survey_of(bar_of_points()), 0.3, holes);
  CHECK(holes[0].ends_at_sill);
  CHECK(std::fabs(ring_box(holes[0].outline).low.v - 1.0) < 0.02);
}

TEST_CASE("sills__a_rail_with_the_opening_going_on_below_is_none") {
  auto planes = wall_with_hole();
  std::vector<WallHole> holes(1);
  holes[0].outline = hole_over_sill();
  auto points = bar_of_points();
  for (HolePoint& p : points)
    if (p.w > 0) p.v += 0.4F;
  for (double u = 1.1; u < 2.1; u += 0.1) points.push_back(point(u, 1.0, -0.2));
  end_at_sills(planes, 0, survey_of(points), 0.3, holes);
  CHECK_FALSE(holes[0].ends_at_sill);
  CHECK(holes[0].outline.corners == hole_over_sill().corners);
}
