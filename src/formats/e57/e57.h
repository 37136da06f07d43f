// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/files/byte_source.h"
#include "formats/settings.h"

namespace jalon {

bool is_e57(const ByteSource& source);
/// A station for each scan; points are moved by its pose. Fields row, column, intensity, red, green,
/// blue, return_number, number_of_returns, time and those of extensions, as far as a scan has them.
/// Points that the file marks as invalid are left out.
Cloud read_e57(const ByteSource& source, const ReadSettings& settings, Task& task);
/// A scan for each station, its points in the scanner's frame, and one for points of none; doubles,
/// or steps of the option "scale". Where read_e57() finds the fields above it finds these again;
/// other fields stand in an extension of our own, in their types.
void write_e57(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task);

}  // namespace jalon
