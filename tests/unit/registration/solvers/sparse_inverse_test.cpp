// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/sparse_inverse.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "base/random.h"

using namespace jalon;

namespace {

// A chain, some elements apart from it and one row that all hang on: positive definite by its diagonal.
Eigen::SparseMatrix<double> arrow_matrix(Eigen::Index n, uint64_t seed) {
  RandomStream random(seed, 0);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  const auto join = [&](Eigen::Index i, Eigen::Index j) {
    dense(i, j) = dense(j, i) = random.uniform() - 0.5;
  };
  for (Eigen::Index i = 0; i + 1 < n; ++i) join(i, i + 1);
  for (Eigen::Index i = 0; i + 7 < n; i += 5) join(i, i + 7);
  for (Eigen::Index i = 0; i + 2 < n; i += 3) join(i, n - 1);
  for (Eigen::Index i = 0; i < n; ++i) dense(i, i) = dense.row(i).cwiseAbs().sum() + 0.1;
  return dense.sparseView();
}

}  // namespace

TEST_CASE("sparse_inverse__where_the_matrix_has_elements__is_the_dense_inverse") {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const Eigen::SparseMatrix<double> matrix = arrow_matrix(60, seed);
    const SparseInverse::Factor factor(matrix);
    REQUIRE(factor.info() == Eigen::Success);
    const SparseInverse inverse(factor);
    const Eigen::MatrixXd dense = Eigen::MatrixXd(matrix).inverse();
    double worst = 0;
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
        worst = std::max(worst, std::fabs(inverse.at(it.row(), j) - dense(it.row(), j)));
    CHECK(worst < 1e-12);
  }
}
