// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "scan/flat_triangles.h"
#include "spatial/union_find.h"

namespace jalon {

/// Joins coplanar triangles that have an edge in common, by its coordinates: meshes need not share vertices. Gives a
/// mask a triangle: bit k is set where the edge from corner k to the next joins it to one on its other side.
std::vector<uint8_t> join_by_edges(const FlatTriangles& flats, UnionFind& groups, Task& task);

}  // namespace jalon
