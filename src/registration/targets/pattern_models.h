// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/cholesky.h"
#include "geometry/vec.h"
#include "registration/targets/intensity_pattern.h"

namespace jalon {

inline double tanh_slope(double t) { return 1 - t * t; }

/// Four quadrants: value = level + contrast tanh(d1 / w) tanh(d2 / w), d of the lines through the centre.
struct CheckerModel {
  using Point = BrightPoint;
  static constexpr size_t kUnknowns = 6;
  Vec2 centre;
  double angle[2] = {0, 0};  ///< of the lines' normals
  double level = 0, contrast = 1, width_m = 0.001;

  double residual(const BrightPoint& p, Coefficients<6>& j) const {
    double t[2], across[2], n[2][2];
    for (int k = 0; k < 2; ++k) {
      n[k][0] = std::cos(angle[k]), n[k][1] = std::sin(angle[k]);
      const double du = p.u - centre.u, dv = p.v - centre.v;
      t[k] = std::tanh((n[k][0] * du + n[k][1] * dv) / width_m);
      across[k] = -n[k][1] * du + n[k][0] * dv;
    }
    const double s0 = contrast * tanh_slope(t[0]) * t[1] / width_m,
                 s1 = contrast * t[0] * tanh_slope(t[1]) / width_m;
    j = {-s0 * n[0][0] - s1 * n[1][0],
         -s0 * n[0][1] - s1 * n[1][1],
         s0 * across[0],
         s1 * across[1],
         1,
         t[0] * t[1]};
    return level + contrast * t[0] * t[1] - p.value;
  }
  void move(const Coefficients<6>& x) {
    centre = centre + Vec2{x[0], x[1]};
    angle[0] += x[2], angle[1] += x[3];
    level += x[4], contrast += x[5];
  }
  /// Changes of the unknowns that an edge notices: about its width.
  Coefficients<6> units(double reach_m) const {
    return {width_m, width_m, width_m / reach_m, width_m / reach_m, contrast, contrast};
  }
  bool sound(double size_m) const {
    const double between = std::fabs(std::sin(angle[0] - angle[1]));
    return contrast != 0 && between > 0.5 &&
           size_m > 0;  // lines at 30 degrees are seen askew, or are none
  }
};

/// A disc: value = level + contrast tanh((radius - |p - centre|) / w).
struct DiscModel {
  using Point = BrightPoint;
  static constexpr size_t kUnknowns = 5;
  Vec2 centre;
  double radius_m = 0, level = 0, contrast = 1, width_m = 0.001;

  double residual(const BrightPoint& p, Coefficients<5>& j) const {
    const Vec2 d{p.u - centre.u, p.v - centre.v};
    const double r = norm(d), t = std::tanh((radius_m - r) / width_m),
                 s = contrast * tanh_slope(t) / width_m;
    const Vec2 u = r > 0 ? d * (1 / r) : Vec2{1, 0};
    j = {s * u.u, s * u.v, s, 1, t};
    return level + contrast * t - p.value;
  }
  void move(const Coefficients<5>& x) {
    centre = centre + Vec2{x[0], x[1]};
    radius_m += x[2], level += x[3], contrast += x[4];
  }
  /// Changes of the unknowns that an edge notices: about its width.
  Coefficients<5> units(double) const { return {width_m, width_m, width_m, contrast, contrast}; }
  bool sound(double size_m) const { return radius_m > 0.2 * size_m && radius_m < 0.8 * size_m; }
};

}  // namespace jalon
