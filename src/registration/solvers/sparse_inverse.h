// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/SparseCholesky>

namespace jalon {

/// Elements of the inverse of a sparse symmetric matrix where its factor L has elements, which is wherever the matrix
/// itself has them: what standard deviations need, without the whole inverse (Takahashi et al. 1973; Erisman &
/// Tinney 1975). O(sum of the squares of the columns' lengths).
class SparseInverse {
 public:
  using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
  explicit SparseInverse(const Factor& factor);

  /// Row and column of the matrix as it was factorised, in either order; 0 where L has no element.
  double at(Eigen::Index row, Eigen::Index column) const;

 private:
  Eigen::SparseMatrix<double> lower_;  ///< diagonal first in each column, rows ascending
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>
      places_;  ///< of rows in the factor's order
};

}  // namespace jalon
