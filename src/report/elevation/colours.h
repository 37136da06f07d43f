// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "report/elevation/faces.h"
#include "report/settings.h"

namespace jalon {

constexpr const char* kEdgeOn = "#8c4fa8";       ///< line of a plane seen edge-on
constexpr const char* kSlantedFill = "#e8e8e8";  ///< of a plane seen at an angle

/// Fill of group i.
std::string group_colour(const ElevationFaces& faces, size_t i, ElevationColours colours);
/// Does text on this colour (#rrggbb) have to be white?
bool is_dark(std::string_view colour);
/// Line of an opening's contour: windows, doors and others differ.
const char* opening_colour(std::string_view part_class);

}  // namespace jalon
