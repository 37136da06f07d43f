// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/curved.h"

namespace jalon {

bool adjust_curved(std::span<const Vec3> points, const Curved& start,
                   const PrimitiveSetting& setting, Task& task, Segment& out) {
  out.type = start.type;
  return start.is_sphere() ? adjust_sphere(points, start.sphere(), setting, task, out.sphere)
                           : adjust_cylinder(points, start.cylinder(), setting, task, out.cylinder);
}

Curved curved_of(const Segment& segment) {
  return segment.type == PrimitiveType::kSphere ? Curved(segment.sphere.sphere)
                                                : Curved(segment.cylinder.cylinder);
}

}  // namespace jalon
