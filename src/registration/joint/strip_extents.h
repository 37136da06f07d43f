// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "registration/joint/strip_scene.h"

namespace jalon {

/// A strip's rectangle: along its wall and up. Empty for a strip without faces.
struct StripExtent {
  double from = std::numeric_limits<double>::infinity(), to = -from, bottom = from, top = -from;

  bool is_empty() const { return !(from < to); }
  bool contains(double place, double height) const {
    return place >= from && place <= to && height >= bottom && height <= top;
  }
};
std::vector<StripExtent> strip_extents(const StripScene& scene);
/// The middle of each strip in the plan, where it is given.
std::vector<Vec3> strip_middles(const StripScene& scene, const std::vector<StripExtent>& extents);

/// Strips that look the same way: turned from each other by 20 degrees at most.
constexpr double kParallel = 0.94;
/// Beams that go through a strip and end so much farther behind it than its points may still tell that they do.
constexpr double kBehind_m = 20;

/// Standard deviations, of a facade or a strip: with one that would be farther off nothing is explained. Of a city's
/// strips three in a thousand are off by more than three; one that is not looked for leaves its wall to another.
constexpr double kMostDeviations = 5;

/// The direction that places along a strip count in.
inline Vec2 along(const GivenStrip& strip) { return {-strip.normal.v, strip.normal.u}; }

}  // namespace jalon
