// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/field.h"
#include "base/task.h"
#include "geometry/vec.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Neighbours of many queries, one query's behind the other's.
struct RadiusNeighbours {
  FieldTable ranges;      ///< "first": where each query's begin; a last row with the number of all
  FieldTable neighbours;  ///< "index" in the cloud, "distance" (m); by ascending index
};

/// Neighbours, 16 B each, that are kept until it is known where they go; others are counted and searched again, so that
/// a cancel has a gigabyte to give back, some 50 ms, and not the whole answer a second time.
constexpr size_t kMostKeptNeighbours = size_t{1} << 26;

/// The points within the closed ball of radius_m around each query. Parallel; the answer does not depend on most_kept.
RadiusNeighbours radius_neighbours(const Octree& tree, std::span<const Vec3> queries,
                                   double radius_m, Task& task,
                                   size_t most_kept = kMostKeptNeighbours);

}  // namespace jalon
