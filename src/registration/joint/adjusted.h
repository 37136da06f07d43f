// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "registration/joint/joint_adjustment.h"

namespace jalon {

/// The trajectory that was adjusted, corrected and turned, with the standard deviations that it has now,
/// linear between the control times.
Trajectory adjusted_trajectory(const JointAdjustment& adjustment, const Trajectory& given);

/// The points of the adjustment where they are now.
std::vector<Vec3> adjusted_points(const JointAdjustment& adjustment);

/// A cloud of that drive with its points, and "beam_origin" and "beam_direction", where the adjusted trajectory puts
/// them; beyond the trajectory's ends they move as the ends do. In "covariance" and "point_sigma" the part of the
/// trajectory's position is what it is now. Needs "time". O(n), parallel.
Cloud adjusted_cloud(const JointAdjustment& adjustment, const Trajectory& given, const Cloud& cloud,
                     Task& task);

}  // namespace jalon
