// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/numbers.h"
#include "geometry/polygon_sets.h"

namespace jalon {

/// Distances from one border to the other (Boulaassal 2010, 5.6.2): exact ones, from places every step along it.
struct BorderSpread {
  double mean_m = kNaN;  ///< over its length
  double rms_m = kNaN;
  double q95_m = kNaN;   ///< 95 % of its length is nearer
  double max_m = kNaN;   ///< corners included: one side of the Hausdorff distance
  double within = kNaN;  ///< share of its length within the tolerance
};

/// Two contours against each other, all rings of each taken together.
struct BorderComparison {
  BorderSpread automatic;  ///< of the automatic border from the reference; within = precision
  BorderSpread reference;  ///< of the reference border from the automatic one; within = recall
  double f1 = kNaN;
  double hausdorff_m = kNaN;    ///< the larger maximum
  double hausdorff95_m = kNaN;  ///< the larger 95 % distance
};

/// NaN where a side has no border. O(samples x edges / 16 + ...): edges go by blocks with boxes.
BorderComparison compare_borders(std::span<const PolygonWithHoles> automatic,
                                 std::span<const PolygonWithHoles> reference, double tolerance_m,
                                 double step_m);

}  // namespace jalon
