// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The lines in which other planes cross a wall.
#include <doctest/doctest.h>

#include <cmath>

#include "base/task.h"
#include "modelling/edges/find/crossing_lines.h"
#include "unit/modelling/walls.h"

using namespace walls;

namespace {

std::vector<Vec3> patch(const Vec3& corner, const Vec3& u, const Vec3& v) {
  std::vector<Vec3> out;
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j) out.push_back(corner + u * (0.1 * i) + v * (0.1 * j));
  return out;
}

std::vector<EdgeLine> lines_on_first(const Segmentation& segmentation, double reach_m) {
  Task task;
  const LabelGroups groups(segmentation.labels->values<uint32_t>(), segmentation.segments.size(),
                           task);
  const PlaneFrame frame = plane_frame(segmentation.segments[0].fit.plane, {0, 0, 0}, {1, 0, 0});
  return crossing_lines(segmentation, groups, 0, frame, reach_m);
}

}  // namespace

TEST_CASE("crossing_lines__are_those_of_planes_that_cross_or_come_near_in_their_order") {
  const auto wall = patch({0, 0, 0}, {4, 0, 0}, {0, 0, 3});
  const Segmentation segmentation =
      segmentation_of({wall, patch({1, -1, 0}, {0, 2, 0}, {0, 0, 3}),  // across it at x = 1
                       patch({0, 1, 0}, {4, 0, 0}, {0, 0, 3}),         // parallel
                       patch({0, 0.05, 2}, {4, 0, 0}, {0, 2, 0.5}),  // ends 5 cm behind it, sloping
                       patch({3, 0.5, 0}, {0, 2, 0}, {0, 0, 3})});   // far behind it
  const auto lines = lines_on_first(segmentation, 0.1);
  REQUIRE(lines.size() == 2);
  CHECK(std::fabs(lines[0].direction.v) == doctest::Approx(1));
  CHECK(lines[0].point.u == doctest::Approx(1));
  const PlaneFrame frame = plane_frame(segmentation.segments[0].fit.plane, {0, 0, 0}, {1, 0, 0});
  for (const double t : {-3.0, 0.0, 2.0}) {
    const Vec3 p = frame.lift(lines[1].point + lines[1].direction * t);
    CHECK(std::fabs(segmentation.segments[3].fit.plane.distance(p)) < 1e-5);
  }
  CHECK(norm(lines[1].direction) == doctest::Approx(1));
  CHECK(lines_on_first(segmentation, 0.01).size() == 1);
  CHECK(lines_on_first(segmentation, 0.6).size() == 3);
}

TEST_CASE("crossing_lines__planes_too_flat_to_the_wall_and_surfaces_without_a_plane_have_none") {
  const auto wall = patch({0, 0, 0}, {4, 0, 0}, {0, 0, 3});
  const double c = std::cos(0.3), s = std::sin(0.3);  // 17 degrees
  const std::vector<Vec3> two{{1, -1, 0}, {1, 1, 0}};
  Segmentation segmentation =
      segmentation_of({wall, patch({0, -s, 0}, {4 * c, 4 * s, 0}, {0, 0, 3}), two});
  segmentation.segments[2].fit.plane = {{1, 0, 0}, kNaN};
  CHECK(lines_on_first(segmentation, 1).empty());
}
