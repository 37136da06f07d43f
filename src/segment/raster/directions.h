// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/surface/scene.h"

namespace jalon {

/// Directions that the surfaces of the cloud look in, most points first: peaks of the normals of its free points, each
/// with what turns from it by less than 30 degrees, until few normals are left. Normals have no sign, nor have they:
/// the largest component is positive. Where no normal is known, that of the plane through all points.
std::vector<Vec3> dominant_directions(const SegmentScene& scene, size_t most, Task& task);

/// Toward the stations that saw the cloud, where they are known; as it is otherwise.
Vec3 toward_viewers(const Cloud& cloud, const Vec3& origin, const Vec3& direction,
                    const Vec3& middle);

}  // namespace jalon
