// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"
#include "formats/settings.h"

namespace jalon {

bool is_pcd(const ByteSource& source);
/// ASCII, binary and binary_compressed. A viewpoint other than the origin becomes the one station;
/// of an organised cloud (HEIGHT above 1) points that are not finite are no returns: the others
/// have fields row and column.
Cloud read_pcd(const ByteSource& source, const ReadSettings& settings, Task& task);
/// Binary, coordinates as doubles; red, green, blue of uint8 packed as "rgb", normals as normal_x
/// normal_y normal_z, the pose of a single station as viewpoint.
void write_pcd(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task);

}  // namespace jalon
