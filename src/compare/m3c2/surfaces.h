// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace jalon {

/// A run of points of a cylinder, sorted along the normal, that lie on one surface.
struct CylinderSurface {
  size_t first = 0, count = 0;
};

/// Tells the surfaces in one cylinder apart.
class SurfaceFinder {
 public:
  /// gap_m: points farther apart belong to two surfaces; 0: they are all one. A surface has min_points at least.
  SurfaceFinder(double gap_m, uint32_t min_points) : gap_m_(gap_m), min_points_(min_points) {}

  /// The surfaces of these ascending places, from below; valid until the next call. Single points between surfaces
  /// (fewer than 1 in 50 of all and no second one within half a gap) are left out and join none.
  ///
  /// The gap grows to 5 sigma for surfaces rougher than it, so that the tails of a rough surface stay with it; sigma
  /// from the shortest half of the points (Rousseeuw & Leroy 1988) of the largest surface found with gap_m, of all
  /// points if it finds none.
  std::span<const CylinderSurface> operator()(std::span<const double> ascending);

 private:
  void split(std::span<const double> ascending, double gap);

  double gap_m_;
  size_t min_points_;
  std::vector<CylinderSurface> surfaces_;
};

/// Positions of the two surfaces to compare in the lists of both clouds.
struct SurfacePair {
  size_t reference = 0, compared = 0;
};

/// The surface nearest to the core point (at 0), whichever cloud has it, the reference on a tie, and the one of the
/// other cloud whose middle is nearest to its middle. Swapping the clouds swaps the answer unless there is a tie.
/// Both lists hold one surface at least.
SurfacePair nearest_surfaces(std::span<const double> reference,
                             std::span<const CylinderSurface> reference_surfaces,
                             std::span<const double> compared,
                             std::span<const CylinderSurface> compared_surfaces);

}  // namespace jalon
