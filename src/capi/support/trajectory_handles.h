// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "capi/support/handles.h"
#include "model/trajectory/trajectory.h"

struct jalon_trajectory : jalon::capi::Counted {
  jalon::TrajectoryPtr trajectory;
};

namespace jalon::capi {

jalon_trajectory* new_trajectory(Trajectory trajectory);

}  // namespace jalon::capi
