// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "geometry/vec.h"

namespace jalon {

/// Barycentric weights of a point of a triangle.
using Weights = std::array<double, 3>;

/// A plane that touches the graph of a convex function from below: value + gradient . (x - point).
struct Cut {
  double value = 0;
  Vec3 point, gradient;
  std::array<double, 3> corners{};  ///< its heights at the corners of the triangle

  double at(const Vec3& x) const { return value + dot(gradient, x - point); }
  double at(const Weights& w) const {
    return corners[0] * w[0] + corners[1] * w[1] + corners[2] * w[2];
  }
};

/// The maximum of a few cuts over a triangle: a linear program with three weights, small enough to look at all of its
/// vertices.
class CutEnvelope {
 public:
  /// A cut more; where there is no room, the lowest at the given point goes.
  void add(const Cut& cut, const Weights& at);
  /// The least point of the maximum: a corner, where two cuts cross over an edge, or where three cross.
  double minimise(Weights& where) const;
  /// The mixture of cuts whose least height over the triangle is greatest (the dual program: the same height). It is a
  /// plane below the function too, and proves the least value by itself; returned with its height at a point.
  double best_mixture(const Vec3& point, double& height, Vec3& slope) const;

 private:
  static constexpr size_t kMost = 8;
  std::array<Cut, kMost> cuts_;
  size_t count_ = 0;
};

}  // namespace jalon
