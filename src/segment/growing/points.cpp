// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/growing/points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/parallel.h"
#include "cloud/neighbour_planes.h"
#include "segment/growing/thinning.h"

namespace jalon {

namespace {

// The centroid of a half disc of neighbours, at a straight edge, lies 0.42 radii from its centre, that of a quarter at
// a corner 0.6; an outlier lies almost a whole radius from all of its neighbours.
constexpr double kIsolated = 0.75;
constexpr double kReachInSpacings =
    2;  // of gap_m = 0: neighbouring leaves touch but for the widest chance gaps
// 16 points of one octree cell on a surface span 4 to 5 spacings. A leaf that is wider holds an outlier or bits of two
// surfaces with a gap between: nothing may grow through it.
constexpr double kLooseInSpacings = 7;
constexpr size_t kPointsLeavesPerChunk = 1024;
constexpr size_t kPointsPerChunk = 1 << 15;

// A strip of neighbours as narrow as the noise has no normal: points of one line of a scan, of which the next lies
// farther off than k points of this one, as on ground far from the tripod.
constexpr double kLeastWidthInTolerances = 0.5;  // 1.5 sigma, as in extraction.cpp

// Rms extent across the longest one of the neighbours' plane, grid steps.
double width_of(const NeighbourPlane& plane) {
  const Symmetric3& m = *plane.scatter;
  const double trace = m[0] + m[3] + m[5], smallest = plane.variation * trace;
  const double minors =
      (m[0] * m[3] - m[1] * m[1]) + (m[0] * m[5] - m[2] * m[2]) + (m[3] * m[5] - m[4] * m[4]);
  const double sum = trace - smallest,
               product = minors - smallest * sum;  // of the other two eigenvalues
  const double middle = sum / 2 - std::sqrt(std::max(0.0, sum * sum / 4 - product));
  return std::sqrt(std::max(0.0, middle) / static_cast<double>(plane.count));
}

// Normals of the planes through the k nearest points (Hoppe et al. 1992), spacing as that of k points evenly spread
// over the disc that holds them, and which points are isolated.
void look_around(SegmentScene& scene, GrowingPoints& points, const GrowingSettings& settings,
                 Task& task) {
  const Octree& tree = *points.tree;
  const size_t k = std::min<size_t>(settings.k, tree.size());
  const double step = tree.grid_step();
  const double least_width = kLeastWidthInTolerances * scene.settings.distance_tolerance_m;
  points.isolated = Buffer<uint8_t>(tree.size());
  tree.for_each_knn(static_cast<uint32_t>(k), task, [&](const Octree::Batch& b) {
    NeighbourPlanes planes(tree, [&](const NeighbourPlane& plane) {
      const double squared_radius = b.squared[(plane.position - b.first) * k + k - 1];
      const size_t position = points.position(plane.position);
      scene.spacing[position] =
          static_cast<float>(std::sqrt(std::numbers::pi * squared_radius / static_cast<double>(k)));
      points.isolated[plane.position] =
          plane.squared_offset * step * step > kIsolated * kIsolated * squared_radius ? 1 : 0;
      if (settings.field_normals()) return;
      const bool known = plane.normal != nullptr && width_of(plane) * step >= least_width;
      for (size_t c = 0; c < 3; ++c)
        scene.normals[3 * position + c] = known ? static_cast<float>(plane.normal[c]) : kFloatNaN;
    });
    for (size_t i = 0; i < b.count; ++i) planes.add(b.first + i, b.neighbours + i * k, k);
    planes.flush();
  });
}

// The other free points of a cell get what its representative has.
void spread_to_cells(SegmentScene& scene, const Representatives& cells, bool normals, Task& task) {
  parallel_for(task, cells.points.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const size_t from = cells.first[i], own = cells.points[i];
      const size_t to = i + 1 == cells.first.size() ? scene.size() : cells.first[i + 1];
      for (size_t p = from; p < to; ++p) {
        if (scene.owner[p] != 0) continue;
        scene.spacing[p] = scene.spacing[own];
        for (size_t c = 0; normals && c < 3; ++c)
          scene.normals[3 * p + c] = scene.normals[3 * own + c];
      }
    }
  });
}

// Largest extent of the points of a leaf on an axis.
double extent_of(const Octree& tree, size_t first, size_t last) {
  Box3 box;
  for (size_t i = first; i < last; ++i) box.add(tree.local(i));
  const Vec3 sides = box.max - box.min;
  return std::max({sides.x, sides.y, sides.z});
}

// Median spacing of the points that are not isolated; -1 when there are none, or when the leaf is too wide for it.
float spacing_of_leaf(const SegmentScene& scene, const GrowingPoints& points, size_t first,
                      size_t last) {
  std::array<float, kMostLeafPoints> spacings;
  size_t count = 0;
  for (size_t i = first; i < last; ++i)
    if (points.isolated[i] == 0) spacings[count++] = scene.spacing[points.position(i)];
  if (count == 0) return -1;
  std::nth_element(spacings.begin(), spacings.begin() + count / 2, spacings.begin() + count);
  const float middle = spacings[count / 2];
  return extent_of(*points.tree, first, last) > kLooseInSpacings * middle ? -1 : middle;
}

void connect_leaves(const SegmentScene& scene, GrowingPoints& points,
                    const GrowingSettings& settings, Task& task) {
  const auto first = points.leaf_first();
  points.leaf_spacing = Buffer<float>(points.leaves());
  std::vector<float> reach(points.leaves());
  parallel_for(task, points.leaves(), kPointsLeavesPerChunk, [&](size_t begin, size_t end) {
    for (size_t leaf = begin; leaf < end; ++leaf) {
      const float spacing = spacing_of_leaf(scene, points, first[leaf], first[leaf + 1]);
      points.leaf_spacing[leaf] = spacing;
      reach[leaf] = spacing < 0          ? -1
                    : settings.gap_m > 0 ? static_cast<float>(settings.gap_m)
                                         : static_cast<float>(kReachInSpacings) * spacing;
    }
  });
  points.graph = leaf_graph(*points.tree, reach, task);
}

}  // namespace

GrowingPoints points_to_grow(SegmentScene& scene, const GrowingSettings& settings, Task& task) {
  const Representatives cells = one_per_cell(scene, task);
  const bool thin = pays(cells);
  GrowingPoints points = thinned_points(scene, cells, task);
  look_around(scene, points, settings, task);
  if (thin) spread_to_cells(scene, cells, !settings.field_normals(), task);
  connect_leaves(scene, points, settings, task);
  return points;
}

}  // namespace jalon
