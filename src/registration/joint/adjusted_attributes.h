// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/model.h"
#include "model/part_attributes.h"
#include "registration/joint/joint_adjustment.h"

namespace jalon {

/// What an adjustment says of the parts of its model of strips, as jalon_adjustment_model lists it. Buildings have what
/// their block has, strips their facade's as well: a reader that knows walls alone has all that moved them.
PartAttributes adjusted_attributes(const JointAdjustment& adjustment, const JointSettings& settings,
                                   const Model& strips);

}  // namespace jalon
