// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "registration/network/network_adjustment.h"

namespace jalon {

/// Plan of a total-station network as SVG, north up, axes in metres: stations, fixed and weak points, the points that
/// were sighted, sights, those with an outlier red, and 95 % ellipses drawn larger than they are by a stated factor
/// with a bar of their own scale.
std::string network_plan_svg(const NetworkAdjustment& network, const std::string& title,
                             Task& task);

/// Of a two-dimensional normal distribution: the standard ellipse times this holds 95 %.
constexpr double kEllipse95 = 2.4477468306808166;

}  // namespace jalon
