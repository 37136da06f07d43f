// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/walls/survey.h"
#include "segment/segmentation.h"

namespace jalon {

/// What one segment puts into a hole.
struct HoleFiller {
  uint32_t label = 0;  ///< 0: the points of no segment
  uint32_t cells = 0;  ///< cells of the wall's map with such points
  size_t points = 0;
  double depth_m = 0;            ///< median, behind the wall
  std::vector<uint32_t> blocks;  ///< blocks of 4 x 4 cells with such points, ascending
};

/// Fillers parallel to the wall, upright to it (reveals, sills, soffits), and the rest; by falling cells.
struct HoleContent {
  std::vector<HoleFiller> parallel, upright, other;
};

/// Before: hole and map are of one survey; normal is the wall's. After: each label of the hole's
/// points but own_label is one filler; ties in cells by label.
HoleContent content_of(const HoleSurvey& hole, const WallMap& map, const Segmentation& segmentation,
                       const Vec3& normal, uint32_t own_label, Task& task);

}  // namespace jalon
