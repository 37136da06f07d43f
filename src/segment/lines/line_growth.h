// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segment/lines/straight_pieces.h"

namespace jalon {

/// For each line those of the next row and of the row before that lie beside it along the row; ascending. Rows next to
/// each other differ by one, or by two where one holds no line.
std::vector<std::vector<uint32_t>> lines_beside(std::span<const ScanLine> lines, Task& task);

/// Regions of lines in one plane, numbered from 1: label of each line.
struct LineRegions {
  std::vector<uint32_t> labels;
  std::vector<Plane> planes;
};

/// Grown across rows from the line of most points and the one beside it that fits it best; a line joins when its points
/// lie in the region's plane, which is refitted from running moments (Jiang & Bunke 1994). Regions of three lines and
/// more, since any two are nearly in a plane.
LineRegions grow_lines(std::span<const ScanLine> lines,
                       const std::vector<std::vector<uint32_t>>& beside, double tolerance_m,
                       Task& task);

}  // namespace jalon
