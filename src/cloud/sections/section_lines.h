// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "cloud/sections/section_settings.h"
#include "geometry/vec.h"

namespace jalon {

/// One line of a section, in its plane.
struct SectionLine {
  std::vector<Vec2> vertices;
  bool is_closed = false;  ///< the last vertex is joined to the first, which stands once
  uint64_t points = 0;     ///< that it was made of
  double length_m = 0;
  double rms_m = 0, max_m = 0;  ///< of their distances from it
};

/// The lines that points in a plane show: 1. thinned by square cells with some points each; 2. cells chained to the
/// nearest up to gap_m; 3. chains simplified (Douglas & Peucker 1973); 4. each straight piece fitted by least squares
/// to its points, corners where neighbours meet. The same bits for any order of the points. cell_m: of the cells taken.
std::vector<SectionLine> section_lines(std::span<const Vec2> points,
                                       const SectionSettings& settings, double& cell_m, Task& task);

}  // namespace jalon
