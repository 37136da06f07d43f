// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "solid/surface.h"

namespace jalon {

struct Depth {
  double depth_m = 0;  ///< 0: no point of the surface lies inside
  Vec3 point, foot;    ///< the deepest point, and the nearest of the other surface
};

/// How deep the deepest point of a surface lies in a closed one: exact to 1e-9 m in a convex one, at most tolerance_m
/// too small in another. There triangles are cut in four until none can hold a deeper point: depth changes by at most 1
/// m a metre, which bounds it over a triangle by its middle and radius.
Depth depth_in(const PartSurface& surface, const PartSurface& closed, double tolerance_m,
               Task& task);

}  // namespace jalon
