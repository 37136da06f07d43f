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

/// Of the points of a closed chain: where they lie further apart than two spacings, they stray in proportion.
std::vector<double> weights_by_steps(std::span<const Vec2> chain, double spacing_m);

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
  struct ArcFit {
    Circle circle;
    double squares =
        INFINITY;  ///< weighted sum of squared distances, to first order; infinite without a circle
  };

  /// The points of one stretch.
  class Stretch {
   public:
    LineFit line() const;
    /// Its squares alone, without any angle.
    double squares() const;
    Vec2 mean() const;
    /// Weighted sum of squared distances to a given line.
    double squares_about(const EdgeLine& line) const;
    /// Linear fit (Boulaassal 2010, E.1.2).
    ArcFit arc() const;

   private:
    friend class ChainMoments;
    Vec2 reference_;
    /// Means, products about them; of u, v, uu, uv, vv, uz, vz, zz with z = uu + vv.
    std::array<double, 8> central_;
    double weight_ = 0;
  };
  /// Points first ... last of the chain walked round up to twice; first < last.
  Stretch stretch(size_t first, size_t last) const;

 private:
  static constexpr size_t kSums = 9;  ///< those of a stretch and the weights
  using Sums = std::array<double, kSums>;

  Vec2 reference_;
  size_t count_ = 0;
  std::vector<Sums> running_;
};

}  // namespace jalon
