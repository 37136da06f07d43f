// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/circle.h"
#include "geometry/vec.h"
#include "modelling/edges/find/edge_line.h"

namespace jalon {

/// Weighted least-squares lines and circles through any stretch of a closed chain in constant time, from running sums
/// of the powers of its coordinates about their mean.
class ChainMoments {
 public:
  /// Before: a weight a point, above 0. O(n).
  ChainMoments(std::span<const Vec2> chain, std::span<const double> weights);
  size_t size() const { return count_; }

  struct LineFit {
    EdgeLine line;       ///< without sense: along either way
    double squares = 0;  ///< weighted sum of squared distances
  };
  /// Points first ... last of the chain walked round up to twice; first < last.
  LineFit line(size_t first, size_t last) const;
  /// Its squares alone, without any angle.
  double squares(size_t first, size_t last) const;
  Vec2 mean(size_t first, size_t last) const;
  /// Weighted sum of squared distances to a given line.
  double squares_about(const EdgeLine& line, size_t first, size_t last) const;

  struct ArcFit {
    Circle circle;
    double squares =
        INFINITY;  ///< weighted sum of squared distances, to first order; infinite without a circle
  };
  /// Linear fit (Boulaassal 2010, E.1.2).
  ArcFit arc(size_t first, size_t last) const;

 private:
  static constexpr size_t kSums =
      9;  ///< of u, v, uu, uv, vv, uz, vz, zz with z = uu + vv; and of the weights
  using Sums = std::array<double, kSums>;
  /// Means over the stretch, products about their means; last the sum of weights.
  Sums central(size_t first, size_t last) const;
  /// About the line that fits best.
  static double squares_of(const Sums& central);

  Vec2 reference_;
  size_t count_ = 0;
  std::vector<Sums> running_;
};

}  // namespace jalon
