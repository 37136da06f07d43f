// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/options.h"

namespace jalon::cli {

/// A polygon in plan or in a plane of its own, as jalon_cloud_crop_polygon takes it.
struct CutPolygon {
  std::vector<double> uv;         ///< two numbers a corner
  jalon_transform T_prism_world;  ///< w: z in plan, else the height before the plane
};

/// "0,0; 20,0; 20,8": two numbers a corner are x and y in plan, three lie in the plane that fits them. Corners end at
/// semicolons. What is wrong is told.
CutPolygon parse_cut_polygon(const std::string& text);
/// The same from a file, a corner a line.
CutPolygon read_cut_polygon(const std::string& path);

}  // namespace jalon::cli
