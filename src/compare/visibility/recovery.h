// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "compare/comparison.h"
#include "compare/visibility/settings.h"
#include "compare/visibility/visibility.h"

// What can still be said of points that the reference's scanners did not see (Girardeau-Montaut 2006, 2.4.4 and annex
// E, 4.1.2). Out of range and out of the field, nothing can.

namespace jalon {

/// Column "recovered": how a hidden point came to its value.
enum class Recovered : uint8_t {
  kNot = 0,
  kAlongDirection = 1,     ///< 2.5D: the reference's surface above or below it
  kOccluder = 2,           ///< from the points that hide it, which have the same shape
  kProbablyUnchanged = 3,  ///< unchanged between the epochs before and after
  kChangedMeanwhile = 4,   ///< changed between them: when is open
};

/// Heights of the points above the surface of the reference along a unit direction, NaN where there is none: the
/// Delaunay triangles of the reference's points in the plane across it, without those that have an edge longer than
/// radius_m there. O(m log m) for the m reference points near the given ones.
std::vector<double> heights_along(const Cloud& reference, const Cloud& compared,
                                  std::span<const uint64_t> points, const Vec3& direction,
                                  double radius_m, Task& task);

/// What the points of hidden zones have to do with those that hide them.
struct OccluderMatch {
  std::vector<double>
      distances;  ///< of each point from the nearest of its zone's occluders; NaN without any
  std::vector<double>
      residuals;  ///< of its zone: what is left after a rigid fit to the occluders, root mean square
  std::vector<double> ratios;  ///< that over the occluders' spacing; about 1 and less for one shape
};
/// Zones are connected hidden points on a grid of zone_m. O(n log n).
OccluderMatch match_occluders(const Cloud& reference, const Cloud& compared,
                              const VisibilityTest& test, std::span<const uint64_t> points,
                              double zone_m, Task& task);

/// Gives the hidden points their values in the table: "distance" and status compared where recovered, and columns
/// "recovered", with kVertical "height" (signed), with kOccluders "shape_residual".
void recover_hidden(const Cloud& reference, const Cloud& compared, const VisibilityTest& test,
                    std::span<const uint64_t> hidden, const HiddenSettings& settings,
                    FieldTable& points, Task& task);

/// Third epoch: of two comparisons of the same points, with the epoch t and with the one beyond it, what is hidden at t
/// but known across: kProbablyUnchanged within the tolerance, else kChangedMeanwhile; values and status stay. Errors:
/// kInvalidArgument when the points differ.
Comparison with_third_epoch(const Comparison& hidden, const Comparison& across, double tolerance_m,
                            Task& task);

}  // namespace jalon
