// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/front/wall_sheet.h"

namespace jalon {

/// A wall and places spread over what was measured of it, in the segments' frame.
struct ProbedWall {
  const WallSheet& sheet;
  std::span<const Vec3> probes;
};

/// Whether two walls are storeys of one front: parallel, one over the other, and too near to each other's plane for a
/// viewer between them. Half-timbered storeys stand out over the one below, attics stand back. O(probes).
bool are_storeys(const ProbedWall& a, const ProbedWall& b);

}  // namespace jalon
