// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/handles.h"

namespace jalon::cli {

/// A gauge as a file tells it: convex pieces and the points of their hulls.
struct Gauge {
  std::vector<jalon_gauge_piece> pieces;
  std::vector<double> hull_points;  ///< three numbers a point
};

/// A JSON file {"pieces": [{"type": "box", "size": [x, y, z], "at": [x, y, z]}, ...]}.
Gauge read_gauge(const std::string& path);

/// Poses, a line each: x y z (the gauge's x looks along the path, its z up), x y z qx qy qz qw, the same after a time,
/// or the 12 numbers of the rows [R | t]. Blanks, commas or semicolons between; a heading and lines from # on are left
/// out.
std::vector<jalon_transform> read_trajectory(const std::string& path);

}  // namespace jalon::cli
