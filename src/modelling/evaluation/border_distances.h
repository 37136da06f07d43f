// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "geometry/polygon_sets.h"

namespace jalon {

/// Distances from one border to the other (Boulaassal 2010, 5.6.2): exact ones, from places every step along it.
struct BorderSpread {
  double mean_m = std::numeric_limits<double>::quiet_NaN();  ///< over its length
  double rms_m = std::numeric_limits<double>::quiet_NaN();
  double q95_m = std::numeric_limits<double>::quiet_NaN();   ///< 95 % of its length is nearer
  double max_m = std::numeric_limits<double>::quiet_NaN();   ///< corners included: one side of the Hausdorff distance
  double within = std::numeric_limits<double>::quiet_NaN();  ///< share of its length within the tolerance
};

/// Two contours against each other, all rings of each taken together.
struct BorderComparison {
  BorderSpread automatic;  ///< of the automatic border from the reference; within = precision
  BorderSpread reference;  ///< of the reference border from the automatic one; within = recall
  double f1 = std::numeric_limits<double>::quiet_NaN();
  double hausdorff_m = std::numeric_limits<double>::quiet_NaN();    ///< the larger maximum
  double hausdorff95_m = std::numeric_limits<double>::quiet_NaN();  ///< the larger 95 % distance
};

/// NaN where a side has no border. O(samples x edges / 16 + ...): edges go by blocks with boxes.
BorderComparison compare_borders(std::span<const PolygonWithHoles> automatic,
                                 std::span<const PolygonWithHoles> reference, double tolerance_m, double step_m);

}  // namespace jalon
