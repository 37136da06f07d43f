// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The frame that a segment is drawn in.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "modelling/plane/segment_frame.h"
#include "unit/modelling/walls.h"

using namespace jalon;

namespace {

struct FramedWall {
  Segmentation segmentation;
  std::vector<uint32_t> indices;
  PlaneFrame frame;

  explicit FramedWall(const Vec3& shift) {
    walls::WallScan scan;
    scan.width = 3, scan.height = 2, scan.spacing = 0.1, scan.shift = shift;
    segmentation = walls::segmentation_of({scan.points()});
    // The plane of the wall itself, so that only the frame is looked at.
    const Vec3 normal{std::sin(scan.azimuth), -std::cos(scan.azimuth), 0};
    segmentation.segments[0].fit.plane = {normal, dot(normal, shift)};
    indices.resize(segmentation.cloud->size());
    std::iota(indices.begin(), indices.end(), 0u);
    frame = segment_frame(segmentation, segmentation.segments[0], indices);
  }
};

}  // namespace

TEST_CASE("segment_frame__is_of_the_plane_and_begins_at_whole_metres_below_all_its_points") {
  const FramedWall wall({12, -7, 3});
  CHECK(wall.frame.normal == wall.segmentation.segments[0].fit.plane.normal);
  CHECK(wall.frame.axis_v.z > 0.999);
  for (int k = 0; k < 3; ++k) CHECK(wall.frame.origin[k] == std::floor(wall.frame.origin[k]));
  for (const uint32_t i : wall.indices) {
    const Vec3 p = wall.segmentation.cloud->point(i);
    for (int k = 0; k < 3; ++k) CHECK(p[k] >= wall.frame.origin[k]);
  }
  CHECK(wall.frame.origin.z == 3);
}

TEST_CASE("segment_frame__moves_with_the_cloud_by_whole_metres_without_a_changed_bit") {
  const FramedWall here({}), there({651000, 6861000, 52});
  for (const uint32_t i : here.indices)
    CHECK(here.frame.project(here.segmentation.cloud->point(i)) ==
          there.frame.project(there.segmentation.cloud->point(i)));
}

TEST_CASE("segment_frame__of_a_part_of_the_points_begins_at_that_part") {
  const FramedWall wall({});
  std::vector<uint32_t> upper;
  for (const uint32_t i : wall.indices)
    if (wall.segmentation.cloud->point(i).z > 1.2) upper.push_back(i);
  const PlaneFrame frame = segment_frame(wall.segmentation, wall.segmentation.segments[0], upper);
  CHECK(frame.origin.z == 1);
  CHECK(frame.height == doctest::Approx(-dot(frame.origin, frame.normal)));
}
