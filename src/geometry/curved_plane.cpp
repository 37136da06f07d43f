// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/curved_plane.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
constexpr double kLeastPivot = 1e-9;  // of the largest: below, the points lie near one conic

}  // namespace

void BendSums::add(double u, double v, double d) {
  const double terms[6] = {1, u, v, u * u, u * v, v * v};
  size_t at = 0;
  for (size_t i = 0; i < 6; ++i) {
    for (size_t j = i; j < 6; ++j) products[at++] += terms[i] * terms[j];
    heights[i] += terms[i] * d;
  }
  squares += d * d;
  ++n;
}

BendSums& BendSums::operator+=(const BendSums& b) {
  for (size_t i = 0; i < products.size(); ++i) products[i] += b.products[i];
  for (size_t i = 0; i < heights.size(); ++i) heights[i] += b.heights[i];
  squares += b.squares;
  n += b.n;
  return *this;
}

bool largest_bend(const BendSums& sums, double length_u, double length_v, Bend& out) {
  if (sums.n <= 6) return false;
  Matrix6 normal;
  Vector6 right;
  size_t at = 0;
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) normal(i, j) = normal(j, i) = sums.products[at++];
    right(i) = sums.heights[static_cast<size_t>(i)];
  }
  const Eigen::LDLT<Matrix6> solver(normal);
  const Vector6 pivots = solver.vectorD();
  if (!(pivots.minCoeff() > kLeastPivot * pivots.maxCoeff())) return false;
  const Vector6 c = solver.solve(right);
  const double residual = std::max(0.0, sums.squares - c.dot(right));
  const double variance = residual / static_cast<double>(sums.n - 6);
  // Principal directions of the second derivatives [[2 c3, c4], [c4, 2 c5]], taken back to metres.
  const double uu = c(3) / (length_u * length_u), uv = c(4) / (length_u * length_v),
               vv = c(5) / (length_v * length_v);
  const double angle = 0.5 * std::atan2(uv, uu - vv);
  const auto along = [&](double x, double y) {
    Vector6 gradient = Vector6::Zero();
    gradient(3) = 2 * x * x / (length_u * length_u);
    gradient(4) = 2 * x * y / (length_u * length_v);
    gradient(5) = 2 * y * y / (length_v * length_v);
    return Bend{gradient.dot(c), std::sqrt(variance * gradient.dot(solver.solve(gradient)))};
  };
  const Bend first = along(std::cos(angle), std::sin(angle)),
             second = along(-std::sin(angle), std::cos(angle));
  out = std::fabs(first.curvature) >= std::fabs(second.curvature) ? first : second;
  return true;
}

}  // namespace jalon
