// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cloud/cloud.h"

namespace jalon {

/// "scan.stations.json" beside "scan.xyz": the stations of a file whose format has no place for them.
std::string station_file_of(const std::string& path);
/// Whether there is one.
bool has_station_file(const std::string& path);
/// Gives the cloud, read from this path, the stations of that file where there is one and it names no other cloud. A
/// file that is not as it should be is a warning: the points stand for themselves. So is one by ranges of points where
/// these are not all of the file's.
Cloud with_station_file(Cloud cloud, const std::string& path, bool is_whole, Task& task);
/// Writes that file of a cloud with stations; takes away the one that an earlier cloud of this name left, where this
/// one has none or is_kept: its own file holds them.
void write_station_file(const Cloud& cloud, const std::string& path, bool is_kept);

}  // namespace jalon
