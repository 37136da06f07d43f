// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/symmetric_eigen6.h"

#include <Eigen/Eigenvalues>

namespace jalon {

Eigen6 symmetric_eigen(const Square<6>& m, double turn_unit) {
  using Matrix = Eigen::Matrix<double, 6, 6>;
  constexpr Eigen::Index kTurns = 3;
  const auto unit_of = [&](Eigen::Index i) { return i < kTurns ? turn_unit : 1; };
  Matrix scaled;
  for (Eigen::Index i = 0; i < 6; ++i)
    for (Eigen::Index j = 0; j < 6; ++j)
      scaled(i, j) = m[static_cast<size_t>(6 * i + j)] * unit_of(i) * unit_of(j);
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(scaled);
  Eigen6 out;
  for (size_t k = 0; k < 6; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    out.values[k] = solver.eigenvalues()(column);
    for (size_t i = 0; i < 6; ++i)
      out.vectors[k][i] = solver.eigenvectors()(static_cast<Eigen::Index>(i), column);
  }
  return out;
}

}  // namespace jalon
