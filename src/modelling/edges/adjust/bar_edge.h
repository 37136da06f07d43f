// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "geometry/vec.h"

namespace jalon {

/// A level edge of a bar: where it lies and its standard deviation.
struct BarEdge {
  double at_m = 0, sigma_m = 0;
};

/// Upper edge of a level bar a few rows of points high (a sill's front), in the plane's coordinates (v up). A scanner's
/// rows are no level lines: each column of points ends somewhere between the edge and a row's distance below it, and
/// the edge lies above the highest and within that distance of all others. Where rows run along the edge half a row
/// stays unknown; where they cross it, little more than the noise. sigma_m: of a point, along the wall. Nothing when
/// there are too few columns. O(n log n).
std::optional<BarEdge> upper_edge(std::span<const Vec2> points, double spacing_m, double sigma_m);

}  // namespace jalon
