// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/ransac/extraction.h"

namespace jalon {

/// False when the surface turns by less than twice the normal tolerance over its points (then each of them agrees with
/// the plane in its middle) or when a plane fits them nearly as well.
bool bends(const SurfaceSettings& settings, const Surface& surface, std::span<const Vec3> points,
           Task& task);

/// True when a few planes along a cylinder's axis fit its points as well: the corner of a wall, a square post.
bool is_faceted(const Surface& surface, std::span<const Vec3> points, Task& task);

/// False when the free points beside the surface, one to two tolerances off it, are as many as clutter has: it cuts
/// through a crown or a crowd rather than being anything.
bool stands_out(const SegmentScene& scene, const PointPool& pool, const Surface& surface,
                std::span<const Vec3> points, Task& task);

/// A band of a cylinder, such as the soffit of an arch, is nearly one of a sphere too. True when a cylinder fits the
/// points of a sphere better; it is then given.
bool better_as_cylinder(const Surface& sphere, std::span<const Vec3> points,
                        const PrimitiveSetting& setting, Task& task, Curved& out);

}  // namespace jalon
