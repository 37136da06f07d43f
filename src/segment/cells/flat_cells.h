// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/plane.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Some of a tree's points, by ascending sorted position.
struct CellPoints {
  const Octree& tree;
  std::span<const uint32_t> positions;
  size_t size() const { return positions.size(); }
  Vec3 local(size_t i) const { return tree.local(positions[i]); }
  uint64_t code(size_t i) const { return tree.code(positions[i]); }
};

/// A cell of the octree whose points lie in one plane.
struct FlatCell {
  size_t first = 0, last = 0;  ///< of the points that are split
  int level = 0;
  Moments moments;  ///< about the middle of the cube
  PlaneFit fit;
};

/// When cells are split.
struct SplitRule {
  double tolerance_m = 0;  ///< half-thickness of a plane
  double least_cell_m = 0;
  size_t least_points = 6;  ///< of a cell that may be flat, and of one that is split
};

/// The octree split from the cube of all points until cells are flat, small or nearly empty (Wang & Tseng 2004); the
/// flat ones, in the order of the curve. O(n) a level.
std::vector<FlatCell> split_cells(const CellPoints& points, const SplitRule& rule, Task& task);

/// For each cell the others that touch it by a side, an edge or a corner, whatever their sizes; ascending.
std::vector<std::vector<uint32_t>> touching_cells(const CellPoints& points,
                                                  const std::vector<FlatCell>& cells, Task& task);

/// When cells are one plane.
struct MergeRule {
  double tolerance_m = 0;
  double angle_rad = 0;
};

/// Regions of touching cells that one plane fits, grown from the cell of most points: label of each cell, from 1.
/// Returns how many.
uint32_t merge_cells(const std::vector<FlatCell>& cells,
                     const std::vector<std::vector<uint32_t>>& touching, const MergeRule& rule,
                     std::vector<uint32_t>& labels, std::vector<Plane>& planes, Task& task);

}  // namespace jalon
