// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/change_features.h"

namespace jalon {

/// Sets what speaks for and against a rigid motion, by its evidence; the change's own features are set.
void set_motion_features(const ObjectMotionJob& job, const Change& change, ChangeFeatures& f);

}  // namespace jalon
