// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "compare/visibility/depth_map.h"

namespace jalon {

/// A depth map as a PNG file: the highest row on top, one pixel a cell. Grey 255 for the nearest range, 30 for the
/// farthest, even in the logarithm; dark blue where empty. Throws kInsufficientData for a map without a point.
std::string depth_png(const DepthMap& map, Task& task);
/// The same as a TIFF of the ranges in metres, placed in degrees: clockwise from +Y and up from the horizon. Where a
/// turn passes 360 degrees it goes on.
std::string depth_tiff(const DepthMap& map, Task& task);

}  // namespace jalon
