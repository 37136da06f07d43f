// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/ransac_settings.h"
#include "segment/surface/scene.h"

namespace jalon {

/// A scene that surfaces are drawn from.
struct RansacScene : SegmentScene {
  DrawSettings draw;
  OrientationOrder order;  ///< what draw.orientation_order says
};

}  // namespace jalon
