// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/settings.h"

// What the options of reading leave of a cloud, whatever its format.
namespace jalon {

/// Greatest value of the option "max_points": products of two such numbers fit 64 bits.
inline constexpr int64_t kMostKeptPoints = 4000000000;

/// Whether the option "fields" keeps a field of this name.
bool wants_field(const ReadSettings& settings, std::string_view name);
/// Whether the option names none but these, or names that may be missing.
bool wants_only(const ReadSettings& settings, const std::vector<std::string>& names);

/// Of what was read from the path: the points of the box, of those the ones of the station, of these at most so many;
/// with the fields wanted. Error(kNotFound) where there is no such station or field.
Cloud wanted_points(Cloud cloud, const std::string& path, const ReadSettings& settings, Task& task);

/// The same of points [first, first + cloud.size()) of `all` that come one piece after another, each with all fields.
/// Not for a station, nor for a box together with "max_points": how many it leaves is known at the end.
Cloud wanted_points(Cloud piece, uint64_t first, uint64_t all, const std::string& path,
                    const ReadSettings& settings, Task& task);

}  // namespace jalon
