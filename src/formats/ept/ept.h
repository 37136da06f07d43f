// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"
#include "formats/settings.h"

namespace jalon {

/// Entwine Point Tile 1.0 in its binary form: a folder with ept.json, which the path names, the points of each node of
/// an octree as ept-data/D-X-Y-Z.bin and their numbers in ept-hierarchy. The folder is made where there is none. A data
/// set that was there before is replaced as a whole, or stays.
void write_ept(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task);
/// The same form, of any maker; of what the options "box" and "spacing_m" ask for, whole nodes.
Cloud read_ept(const ByteSource& source, const ReadSettings& settings, Task& task);

}  // namespace jalon
