// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/visibility/depth_map.h"

namespace jalon {

/// Map of station i of the cloud. Errors: kInvalidArgument when there is no such station, or it has no pose.
DepthMap station_depth_map(const Cloud& cloud, uint64_t station, const DepthSettings& settings,
                           Task& task);

/// One row a cell: "range", "fill", "points", "nearest", "horizontal", "vertical"; see jalon_cloud_depth_map.
FieldTable depth_table(const DepthMap& map, Task& task);

}  // namespace jalon
