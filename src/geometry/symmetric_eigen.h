// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/vec.h"

namespace jalon {

/// Upper triangle of a symmetric 3 x 3 matrix: xx, xy, xz, yy, yz, zz.
using Symmetric3 = std::array<double, 6>;

struct Eigen3 {
  std::array<double, 3> values;  ///< ascending
  std::array<Vec3, 3> vectors;   ///< orthonormal, right-handed, in the order of the values
};

/// Eigenvalues and eigenvectors by cyclic Jacobi rotations (Golub & Van Loan, 8.5): accurate to
/// rounding relative to the largest
/// value, for every input; the same operations in the same order on every machine. About 0.3 us.
Eigen3 symmetric_eigen(const Symmetric3& m);

}  // namespace jalon
