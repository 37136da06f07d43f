// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/network/network_settings.h"
#include "registration/network/survey.h"

namespace jalon {

/// Places every point that has no coordinates: by polar sights of an oriented setup, by a setup that sees two placed
/// points or more (free station), and by directions of two setups (intersection), each as soon as it can. A chain of
/// setups between points that do not see each other is placed in axes of its own and laid onto them. Where no point has
/// coordinates the first setup stands at the origin and its circle points north.
/// Error(kInsufficientData) names a point that nothing places.
void place_points(Survey& survey, const NetworkSettings& settings);

}  // namespace jalon
