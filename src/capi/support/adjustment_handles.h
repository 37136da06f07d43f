// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "capi/support/handles.h"
#include "model/model.h"
#include "model/trajectory/trajectory.h"
#include "registration/joint/joint_adjustment.h"

struct jalon_adjustment : jalon::capi::Counted {
  jalon::JointAdjustmentPtr adjustment;
  jalon::JointSettings settings;
  jalon::TrajectoryPtr trajectory;  ///< as given
  jalon::ModelPtr model;            ///< as given
};
