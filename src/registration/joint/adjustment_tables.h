// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/field.h"
#include "registration/joint/joint_adjustment.h"

namespace jalon {

// The tables of jalon/adjustment.h.
FieldTable summary_table(const JointAdjustment& adjustment);
FieldTable pass_table(const JointAdjustment& adjustment);
FieldTable control_table(const JointAdjustment& adjustment);
FieldTable block_table(const JointAdjustment& adjustment);
FieldTable facade_table(const JointAdjustment& adjustment);
FieldTable strip_table(const JointAdjustment& adjustment);
FieldTable match_table(const JointAdjustment& adjustment);
/// Error(kInvalidArgument) where the covariance was not asked for, kLimit where its rows are too wide for a table.
FieldTable covariance_table(const JointAdjustment& adjustment);

}  // namespace jalon
