// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "scan/flat_triangles.h"
#include "spatial/union_find.h"

namespace jalon {

/// Joins coplanar groups of triangles that come within 0.1 mm of each other. Groups must be connected and coplanar;
/// inner_edges as join_by_edges gives them: only borders are compared.
void join_touching(const FlatTriangles& flats, std::span<const uint8_t> inner_edges,
                   UnionFind& groups, Task& task);

}  // namespace jalon
