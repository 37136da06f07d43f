// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Points of a slice that share a square cell, as one.
struct ProfileNode {
  Vec2 middle;
  uint32_t first = 0, count = 0;  ///< its points in the list that thin_points() reorders
};

/// One node a cell of edge cell_m, in the order of their cells. order: indices of the points, reordered node by node.
std::vector<ProfileNode> thin_points(std::span<const Vec2> points, double cell_m,
                                     std::vector<uint32_t>& order, Task& task);

/// For each node that of most points among those in the eight cells about it; itself where there is none. Ties to the
/// first.
std::vector<uint32_t> fullest_neighbours(std::span<const ProfileNode> nodes, double cell_m,
                                         Task& task);

/// Chains of nodes, each the nearest one not yet in a chain, no farther than gap_m: from any node to both sides until
/// there is none. Nodes within filled areas, where a surface lies in the slice, are left out. Indices of the nodes.
/// cell_m: that of thin_points().
std::vector<std::vector<uint32_t>> chain_nodes(std::span<const ProfileNode> nodes, double cell_m,
                                               double gap_m, Task& task);

/// The points that stay, first and last included (Douglas & Peucker 1973). A chain whose ends meet is split at the
/// point farthest from its first. Places in the chain, ascending.
std::vector<uint32_t> simplify(std::span<const Vec2> chain, double tolerance_m);

}  // namespace jalon
