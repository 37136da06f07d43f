// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What lies in a plane and bounds nothing: a stray, and the row of points that another plane leaves where it crosses.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "modelling/contour/contour.h"
#include "modelling/plane/crossing_points.h"
#include "unit/modelling/walls.h"

using namespace walls;

namespace {

constexpr double kSpacing = 0.08;

double highest(const Contour& contour) {
  double v = -INFINITY;
  for (const ContourPiece& piece : contour.pieces)
    for (const Vec2& p : piece.outline) v = std::max(v, p.v);
  return v;
}

std::vector<Box3> boxes_of(const Segmentation& segmentation) {
  std::vector<Box3> boxes(segmentation.segments.size());
  const auto labels = segmentation.labels->values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] > 0) boxes[labels[i] - 1].add(segmentation.cloud->point(i));
  return boxes;
}

/// A wall 4 m wide and 2 m high with a post 0.4 m wide on it up to v = 2.5, where a soffit runs from before to behind;
/// the points of the soffit that lie in the wall's plane are the wall's.
struct PostUnderSoffit {
  std::vector<Vec3> wall, soffit;
  size_t rows = 0;  ///< the first of those points in wall

  explicit PostUnderSoffit(double farthest_y) {
    for (double x = 0; x < 4; x += kSpacing)
      for (double z = 0; z < 2.5; z += kSpacing)
        if (z < 2 || (x > 1.8 && x < 2.2))
          wall.push_back({x, 0.002 * std::sin(40 * x + 70 * z), z});
    rows = wall.size();
    for (double x = 0; x < 4; x += kSpacing)
      for (double y = -1; y < farthest_y; y += kSpacing)
        (std::fabs(y) < 1e-9 ? wall : soffit)
            .push_back({x, y, 2.5 + 0.002 * std::sin(50 * x + 60 * y)});
  }
};

}  // namespace

TEST_CASE("contour__a_point_far_from_all_others_bounds_nothing") {
  // Far: farther than two cells of the raster, of two spacings (0.89 steps of a grid) each, wherever they fall.
  for (const double height : {1.0, 1.1, 1.2, 1.3, 1.5, 1.6, 1.8, 2.0}) {
    CAPTURE(height);
    std::vector<Vec2> points;
    for (double u = 0; u < 4; u += kSpacing)
      for (double v = 0; v < height; v += kSpacing) points.push_back({u, v});
    Task task;
    const double top = highest(extract_contour(points, {}, task));
    points.push_back({1.3, top + 4 * kSpacing});
    points.push_back({2.9, top + 4.5 * kSpacing});
    CHECK(highest(extract_contour(points, {}, task)) == top);
  }
}

TEST_CASE("crossing_points__of_a_soffit_over_a_post_bound_nothing") {
  const PostUnderSoffit scene(1);
  const Segmentation segmentation = segmentation_of({scene.wall, scene.soffit});
  Task task;
  const auto tree = segmentation.cloud->octree(task);
  const std::vector<Box3> boxes = boxes_of(segmentation);
  const CrossingPoints crossing(segmentation, *tree, 0, boxes);
  for (uint32_t i = 0; i < scene.wall.size(); ++i) {
    CAPTURE(scene.wall[i].x);
    CAPTURE(scene.wall[i].z);
    const bool is_row = i >= scene.rows && scene.wall[i].x > 0.1 && scene.wall[i].x < 3.9;
    if (is_row || scene.wall[i].z < 2.4) CHECK(crossing.holds(i, 3 * kSpacing) == is_row);
  }
}

TEST_CASE("crossing_points__a_plane_that_ends_at_the_other_crosses_nothing") {
  const PostUnderSoffit scene(0.001);  // the soffit ends at the wall
  const Segmentation segmentation = segmentation_of({scene.wall, scene.soffit});
  Task task;
  const auto tree = segmentation.cloud->octree(task);
  const std::vector<Box3> boxes = boxes_of(segmentation);
  const CrossingPoints crossing(segmentation, *tree, 0, boxes);
  for (uint32_t i = 0; i < scene.wall.size(); ++i) CHECK(!crossing.holds(i, 3 * kSpacing));
}

TEST_CASE("crossing_points__a_plane_that_goes_on_beyond_the_other_is_whole") {
  const PostUnderSoffit scene(1);
  std::vector<Vec3> wall = scene.wall;
  for (double x = 0; x < 4; x += kSpacing)
    for (double z = 2.6; z < 3.5; z += kSpacing) wall.push_back({x, 0, z});
  for (double x = 0; x < 4; x += kSpacing)
    for (double z = 2.05; z < 2.5; z += kSpacing) wall.push_back({x, 0, z});
  const Segmentation segmentation = segmentation_of({wall, scene.soffit});
  Task task;
  const auto tree = segmentation.cloud->octree(task);
  const std::vector<Box3> boxes = boxes_of(segmentation);
  const CrossingPoints crossing(segmentation, *tree, 0, boxes);
  for (uint32_t i = 0; i < wall.size(); ++i) CHECK(!crossing.holds(i, 3 * kSpacing));
}
