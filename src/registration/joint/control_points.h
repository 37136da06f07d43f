// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "registration/solvers/joint_problem.h"

namespace jalon {

/// Control points from the parameter "control_points", six numbers each: time, x and y as the cloud has them, x and y
/// as they are, standard deviation. Error(kInvalidArgument) naming the point that is not whole, not within the control
/// times, or whose standard deviation is not positive.
std::vector<ControlCondition> control_points(std::span<const double> numbers,
                                             std::span<const double> control_times_s);

}  // namespace jalon
