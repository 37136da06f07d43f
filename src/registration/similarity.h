// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "geometry/vec.h"

namespace jalon {

/// The same place in the reference's frame and in the moving one's.
struct PointPair {
  Vec3 reference, moving;
};

/// reference = scale R moving + t.
struct SimilarityFit {
  Transform T_reference_moving;  ///< with the scale in its matrix
  double scale = 1;
  double squares_m2 = 0;  ///< sum of the squared distances left
  double mirrored_squares_m2 =
      0;  ///< the same if a reflection were allowed, as low as squares_m2 or lower
  std::array<double, 3> spread_m{};  ///< root mean square extents of the moving points, descending
};

/// Least squares in closed form by the singular values of the cross-covariance, always a proper
/// rotation (Arun, Huang & Blostein 1987; Umeyama 1991, eq. 38-43). Nothing when there are fewer
/// than 3 pairs, either side is on one line, or, with a scale, nothing but a reflection fits.
std::optional<SimilarityFit> fit_similarity(std::span<const PointPair> pairs, bool with_scale);

}  // namespace jalon
