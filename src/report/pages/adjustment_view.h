// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/pages/adjustment_report.h"
#include "report/viewer/scene.h"

namespace jalon {

/// The points that were adjusted, moved as their times say, in the colours of their distances from their strips, and,
/// hidden at first, as they were given; the strips where they stand now; the drive as given (red) and adjusted (green).
ViewScene adjustment_scene(const JointAdjustment& adjustment, const AdjustedInputs& inputs);

}  // namespace jalon
