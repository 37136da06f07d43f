// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spatial/octree/impl.h"

namespace jalon {

/// Most neighbours that the vector lanes are asked for.
constexpr uint32_t kMostByGrid = 256;

/// Sorted positions of the k <= kMostByGrid points nearest to a place of the grid, by single precision on the grid in
/// the vector lanes; false when that cannot order them as the caller's doubles do. is_exact: the place and all points
/// lie on steps of the grid; else each coordinate may be a step too low.
bool nearest_by_grid(const Octree::Impl& tree, const int32_t (&query)[3], bool is_exact, uint32_t k,
                     uint32_t* to);

}  // namespace jalon
