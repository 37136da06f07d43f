// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/task.h"
#include "modelling/walls/facade_parts.h"
#include "modelling/walls/holes.h"
#include "segment/segmentation.h"

namespace jalon {

struct SurveySetting {
  double min_depth_m = 0.03;  ///< nearer to the wall's plane than this counts as on it
  double max_depth_m = 1.0;   ///< joinery lies at most this far behind the wall
  double front_m = 0.30;      ///< and what is fixed before an opening at most this far in front
};

/// A point in a hole or just beside it, in the wall's coordinates; w = in front of the wall.
struct HolePoint {
  uint32_t hole = 0, label = 0;
  float u = 0, v = 0, w = 0;
};

/// What was seen in one hole; cells of the wall's map.
struct HoleSurvey {
  uint32_t cells = 0;    ///< that the hole covers
  uint32_t through = 0;  ///< with rays that passed the wall's plane, or points behind it
  uint32_t hidden = 0;   ///< with things in front only
  /// Within [-max_depth_m, front_m] of the wall, the wall's own beside the hole included.
  std::vector<HolePoint> points;
};

struct WallSurvey {
  WallMap map;
  std::vector<HoleSurvey> holes;  ///< one a hole given
  double tolerance_m = 0;         ///< nearer to the wall's plane than this counts as on it
};

/// A wall to look at.
struct SurveyedWall {
  const VectorPlane* plane = nullptr;
  std::span<const WallHole> holes;
  double sigma_m = 0;  ///< of its points
};

/// Looks at all walls in one pass over the cloud (Boulaassal 2010, 5.6.3.2). Where the station of a
/// point is known, the ray from it decides: through the plane of the wall and on = seen through
/// there; ended before it = hidden there. Without stations the points themselves, projected onto
/// the wall.
///
/// After: one survey a wall, in it one a hole, in the order given; points in the order of the
/// cloud. The same bits for any number of threads. Cost: points x walls, a few operations each.
std::vector<WallSurvey> survey_walls(const Segmentation& segmentation,
                                     std::span<const SurveyedWall> walls,
                                     const SurveySetting& setting, Task& task);

}  // namespace jalon
