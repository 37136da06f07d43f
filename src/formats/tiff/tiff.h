// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/settings.h"

namespace jalon {

/// The depth image of a cloud as GeoTIFF: float32 metres toward the viewer, no-data where there is no point. From
/// above these are heights in the cloud's own system, named by its EPSG code where it has one in metres. Else x and y
/// are along the image's axes. Depths beyond 10 km, whose millimetres float32 loses, count from a whole metre that the
/// file names.
void write_depth_tiff(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                      Task& task);

}  // namespace jalon
