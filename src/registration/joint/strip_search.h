// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/joint/joint_points.h"
#include "registration/joint/strip_scene.h"

namespace jalon {

/// What is found of the strips before anything is adjusted.
struct FoundStrips {
  std::vector<double>
      offsets_m;  ///< how far each stands off along its normal; 0 where no wall is found
  /// Another strip may be that wall as well, and nothing tells which of them is hidden, or the wall is farther off than
  /// the sigmas allow: no evidence.
  std::vector<bool> is_doubtful;
  bool is_searched = false;  ///< is_strip_search_wanted

  /// A strip that its own beams have come to put so far off is on a surface other than the one that all beams about it
  /// show, or on one where these show none: what is left of its wall's is hidden or turned away.
  bool is_elsewhere(uint32_t strip, double offset_m) const;
};

/// Each strip's offset: to the wall (strip_surfaces.h) among the points before and behind it, as far off as five of its
/// sigmas. A strip that stands metres before its wall meets the beams of its neighbours' instead, and its own pass
/// beside it. A wall that a parallel strip may be, by its own sigma not a thousand times less likely, is given to
/// neither, and one that is farther off than points are accepted to none: they stay where they are given and are
/// doubtful. All else is taken as it is given, so that it must be surer than the strips: else, and where no wall is
/// seen, a strip stays where it is given. O(points + strips (points and strips about them)).
FoundStrips find_strips(const JointPoints& points, const StripScene& scene,
                        const JointSettings& settings, Task& task);

/// By the sigmas: strips may be off by more than the loop bridges, and by more than everything else together.
bool is_strip_search_wanted(const JointPoints& points, const JointSettings& settings);

}  // namespace jalon
