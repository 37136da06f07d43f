// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vec.h"
#include "jalon/clearance.h"
#include "solid/convex_piece.h"

namespace jalon::capi {

/// The caller's pieces, checked. Throws for none.
std::vector<ConvexPiece> gauge_of(const jalon_gauge_piece* pieces, uint64_t count,
                                  const double* points, uint64_t point_count);
/// Of each piece, checked, points in the gauge's frame whose convex hull it is, round ones nearly so: for drawings.
std::vector<std::vector<Vec3>> gauge_outlines(const jalon_gauge_piece* pieces, uint64_t count,
                                              const double* points, uint64_t point_count);
/// The caller's poses; at least one.
std::vector<Transform> pose_list(const jalon_transform* poses, uint64_t count);

}  // namespace jalon::capi
