// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/plane/plane_joints.h"

namespace jalon {

/// The line in which two planes intersect: p + t d.
struct PlaneLine {
  Vec3 p, d;
  double at(const Vec3& q) const { return dot(q - p, d); }
};

/// Edge of a face's outline that is to run along a line.
struct EdgeJoint {
  size_t plane = 0, face = 0, edge = 0;
  size_t other_plane = 0, other_face = 0;
  PlaneLine line;         ///< the same for both planes
  double distance_m = 0;  ///< mean distance of the edge's ends from it
  double reach_m = 0;     ///< ends may move so far
};

/// Of each straight edge of the outlines the nearest joint, if any. After: ascending by plane,
/// face, edge, at most one each; both planes of a joint have points where the edge runs. O(faces^2)
/// box tests.
std::vector<EdgeJoint> find_joints(const std::vector<VectorPlane>& planes,
                                   const JointSetting& setting, Task& task);

}  // namespace jalon
