// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "geometry/vec.h"
#include "spatial/octree/octree.h"

namespace jalon {

// Legend of coarse registration, for all files of this folder.
//
// Forms of a cloud:  raw: the caller's (Cloud);  surface: CoarseSurface, a point a cell; its points
//                    have an index, here called cell as well.
// Frames:            reference, moving: those of the surfaces, from whole metres near each cloud;
//                    world: the caller's coordinates. T_a_b takes places of frame b to frame a: the
//                    pose sought is T_reference_moving, in this folder between the surfaces'
//                    frames.
// Pairs:             `from` is of the moving surface, `to` of the reference.
// Lengths:           reaches and tolerances are in cells of cell_m, the same for both surfaces.
// Normals:           of either sign; a plane and its back are one.

/// Fast point feature histogram (Rusu, Blodow & Beetz 2009): 3 angles of 11 bins each, of sum 100 an angle. All zero:
/// none.
constexpr size_t kFeatureSize = 33;
using Feature = std::array<float, kFeatureSize>;

/// A cloud thinned to one point a cell of a regular grid, with local planes: all that coarse registration looks at.
struct CoarseSurface {
  Vec3 origin;  ///< of the points' frame, whole metres
  double cell_m = 1;
  std::vector<Vec3> points;   ///< centroids of the cells, from the origin
  std::vector<Vec3> normals;  ///< unit, of either sign; zero where the neighbours span no plane
  std::vector<double>
      variation;  ///< lambda_0 / (lambda_0 + lambda_1 + lambda_2): 0 on a plane; 1 without a normal
  std::vector<double> scatter_m2;  ///< lambda_0: of the neighbours about their plane
  std::vector<double> weights;     ///< what the point counts for: see balance_weights
  Vec3 centroid;
  double extent_m = 0;  ///< radius of gyration
  std::shared_ptr<const Octree> tree;
  Buffer<double> xyz;  ///< the points again, for the tree
  // From describe_features() on:
  std::vector<Feature> features;
  std::vector<uint32_t>
      distinct;  ///< points whose features are farthest from the mean one, ascending
  std::vector<uint32_t> salient;  ///< the farthest of them, ascending
  Feature mean_feature{};

  size_t size() const { return points.size(); }
};

/// The cell (m) that leaves about `target` occupied cells of the larger cloud, from an even sample
/// of both; never so small that the cells hold less than a few points. 0 where a cloud lies at one
/// place.
double coarse_cell(const Cloud& reference, const Cloud& moving, size_t target, Task& task);

/// Thins a cloud to its cells' centroids, with planes, extent and balanced weights. Cells with far
/// fewer points than most are left out: they hold outliers.
///
/// Before: cell_m above 0, the cloud not empty. After: all members but the features are set, as
/// long as points; in the order of the voxel grid. O(n log n).
CoarseSurface coarse_surface(const Cloud& cloud, double cell_m, Task& task);

/// Weights by which each direction that surfaces face counts alike (Rusinkiewicz & Levoy 2001:
/// normal-space sampling), and curved or broken places as much as all planes: what lies anywhere on
/// a floor says little about a pose. Before: normals and variation are set. After: weights, at
/// most 5.
void balance_weights(CoarseSurface& surface);

}  // namespace jalon
