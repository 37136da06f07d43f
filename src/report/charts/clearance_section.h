// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cloud/cloud.h"
#include "compare/clearance/part_triangles.h"
#include "report/charts/clearance_places.h"

namespace jalon {

constexpr double kSectionHalf_m = 0.1;  ///< points this far before and behind a section are in it

/// The section through a tight place across the travel, seen along it, to a usual scale with axes in metres from the
/// gauge's origin: the outline of each piece of the gauge, the points of the cloud, the cut of the surface, the place
/// and what is free there. gauge: of each piece points whose convex hull it is, in the gauge's frame; may be empty.
/// cloud, surface: or nullptr. O(points + triangles).
std::string clearance_section(const TightPlace& place, size_t number, const GaugePath& path,
                              std::span<const std::vector<Vec3>> gauge, const Cloud* cloud,
                              const PartTriangles* surface);

}  // namespace jalon
