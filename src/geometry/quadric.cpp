// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/quadric.h"

#include <array>
#include <cmath>

namespace jalon {

namespace {

constexpr size_t kQuadricUnknowns = 6;
// A pivot below this share of its diagonal element has lost ten of the sixteen digits: the unknown is not fixed.
constexpr double kPivotShare = 1e-10;

using Row = std::array<double, kQuadricUnknowns>;

/// Solves the normal equations by Cholesky's method in place (Golub & Van Loan, 4.2); only the lower triangle is read.
bool solve(std::array<Row, kQuadricUnknowns>& m, Row& x) {
  for (size_t i = 0; i < kQuadricUnknowns; ++i) {
    const double diagonal = m[i][i];
    for (size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (size_t k = 0; k < j; ++k) sum -= m[i][k] * m[j][k];
      if (j < i) {
        m[i][j] = sum / m[j][j];
      } else {
        if (!(sum > kPivotShare * diagonal)) return false;
        m[i][i] = std::sqrt(sum);
      }
    }
  }
  for (size_t i = 0; i < kQuadricUnknowns; ++i) {
    for (size_t k = 0; k < i; ++k) x[i] -= m[i][k] * x[k];
    x[i] /= m[i][i];
  }
  for (size_t i = kQuadricUnknowns; i-- > 0;) {
    for (size_t k = i + 1; k < kQuadricUnknowns; ++k) x[i] -= m[k][i] * x[k];
    x[i] /= m[i][i];
  }
  return true;
}

}  // namespace

Vec3 Quadric::normal(double x, double y) const {
  return normalized({-(2 * a * x + b + c * y), -(c * x + d + 2 * e * y), 1});
}

double Quadric::mean_curvature(double x, double y) const {
  const double zx = 2 * a * x + b + c * y, zy = c * x + d + 2 * e * y;
  const double g = 1 + zx * zx + zy * zy;
  return ((1 + zy * zy) * 2 * a - 2 * zx * zy * c + (1 + zx * zx) * 2 * e) / (2 * g * std::sqrt(g));
}

double Quadric::gaussian_curvature(double x, double y) const {
  const double zx = 2 * a * x + b + c * y, zy = c * x + d + 2 * e * y;
  const double g = 1 + zx * zx + zy * zy;
  return (4 * a * e - c * c) / (g * g);
}

bool fit_quadric(const QuadricSums& sums, Quadric& out) {
  if (!(sums.powers[0][0] >= kQuadricUnknowns)) return false;
  // The terms u^2, u, u v, v, v^2, 1.
  constexpr size_t kU[kQuadricUnknowns] = {2, 1, 1, 0, 0, 0},
                   kV[kQuadricUnknowns] = {0, 0, 1, 1, 2, 0};
  std::array<Row, kQuadricUnknowns> m{};
  Row right{};
  for (size_t i = 0; i < kQuadricUnknowns; ++i) {
    for (size_t j = 0; j <= i; ++j) m[i][j] = sums.powers[kU[i] + kU[j]][kV[i] + kV[j]];
    right[i] = sums.heights[kU[i]][kV[i]];
  }
  if (!solve(m, right)) return false;
  out = {right[0], right[1], right[2], right[3], right[4], right[5]};
  return true;
}

bool fit_quadric(std::span<const Vec3> points, double scale, Quadric& out) {
  if (points.size() < kQuadricUnknowns || !(scale > 0)) return false;
  std::array<Row, kQuadricUnknowns> m{};
  Row right{};
  for (const Vec3& p : points) {
    const double x = p.x / scale, y = p.y / scale;
    const Row terms{x * x, x, x * y, y, y * y, 1};
    for (size_t i = 0; i < kQuadricUnknowns; ++i) {
      for (size_t j = 0; j <= i; ++j) m[i][j] += terms[i] * terms[j];
      right[i] += terms[i] * p.z;
    }
  }
  if (!solve(m, right)) return false;
  const double s2 = scale * scale;
  out = {right[0] / s2, right[1] / scale, right[2] / s2, right[3] / scale, right[4] / s2, right[5]};
  return true;
}

}  // namespace jalon
