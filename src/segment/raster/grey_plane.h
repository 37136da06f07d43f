// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/plane.h"
#include "geometry/vec.h"

namespace jalon {

/// g = a u + b v + c.
struct GreyPlane {
  double a = 0, b = 0, c = 0;
  double rms = 0;  ///< of the grey values about it
  double at(double u, double v) const { return a * u + b * v + c; }
  /// Cosine of its angle with the image's plane: a difference of grey values times it is a distance.
  double cosine() const;
};

/// Running sums of a plane in grey values: one more pixel is ten additions, whatever the number so far.
class GreySums {
 public:
  /// About a pixel near those that come, so that nothing is lost to large coordinates.
  GreySums() = default;
  GreySums(double u, double v, double g) : u0_(u), v0_(v), g0_(g) {}
  void add(double u, double v, double g);
  double count() const { return n_; }
  /// Least squares in the grey values; false for fewer than three pixels or pixels on one line.
  bool fit(GreyPlane& out) const;

 private:
  double u0_ = 0, v0_ = 0, g0_ = 0;
  double n_ = 0, u_ = 0, v_ = 0, g_ = 0, uu_ = 0, uv_ = 0, vv_ = 0, ug_ = 0, vg_ = 0, gg_ = 0;
};

}  // namespace jalon
