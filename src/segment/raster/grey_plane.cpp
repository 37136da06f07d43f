// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/grey_plane.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kLeastDeterminant = 1e-9;  // of the product of the variances: pixels on one line

}  // namespace

double GreyPlane::cosine() const { return 1 / std::sqrt(1 + a * a + b * b); }

void GreySums::add(double u, double v, double g) {
  u -= u0_;
  v -= v0_;
  g -= g0_;
  n_ += 1;
  u_ += u;
  v_ += v;
  g_ += g;
  uu_ += u * u;
  uv_ += u * v;
  vv_ += v * v;
  ug_ += u * g;
  vg_ += v * g;
  gg_ += g * g;
}

// The normal equations about the centroid: two unknowns, then c.
bool GreySums::fit(GreyPlane& out) const {
  if (n_ < 3) return false;
  const double mu = u_ / n_, mv = v_ / n_, mg = g_ / n_;
  const double uu = uu_ / n_ - mu * mu, uv = uv_ / n_ - mu * mv, vv = vv_ / n_ - mv * mv;
  const double ug = ug_ / n_ - mu * mg, vg = vg_ / n_ - mv * mg, gg = gg_ / n_ - mg * mg;
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > kLeastDeterminant * uu * vv)) return false;
  out.a = (ug * vv - vg * uv) / determinant;
  out.b = (vg * uu - ug * uv) / determinant;
  out.c = g0_ + mg - out.a * (u0_ + mu) - out.b * (v0_ + mv);
  out.rms = std::sqrt(std::max(0.0, gg - out.a * ug - out.b * vg));
  return true;
}

}  // namespace jalon
