// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "model/trajectory/trajectory.h"

namespace jalon {

/// The settings of operation "trajectory".
struct TrajectorySettings {
  AxesConvention axes = AxesConvention::kEnu;
};
std::span<const ParamRow> trajectory_rows();

}  // namespace jalon
