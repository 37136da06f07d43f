// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/cholesky.h"

namespace jalon {

/// Of the six unknowns of a pose: eigenvalues ascending, and with them orthonormal eigenvectors.
struct Eigen6 {
  std::array<double, 6> values;
  std::array<Coefficients<6>, 6> vectors;
};

/// By tridiagonalisation and implicit QR steps (Golub & Van Loan, 8.3), of a symmetric matrix whose
/// first three unknowns, the turns, are taken times `turn_unit`: so that they compare with shifts.
/// Eigen's solver is compiled here alone: its templates take seconds.
Eigen6 symmetric_eigen(const Square<6>& m, double turn_unit);

}  // namespace jalon
