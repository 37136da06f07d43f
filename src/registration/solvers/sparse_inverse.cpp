// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/sparse_inverse.h"

#include <algorithm>
#include <vector>

namespace jalon {

namespace {

using Index = Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;

// The unit lower factor with its diagonal, rows ascending.
Sparse whole_factor(const SparseInverse::Factor& factor) {
  const Sparse strict = factor.matrixL().nestedExpression();
  const Index n = strict.rows();
  std::vector<Eigen::Triplet<double>> elements;
  elements.reserve(static_cast<size_t>(strict.nonZeros() + n));
  for (Index j = 0; j < n; ++j) {
    elements.emplace_back(static_cast<int>(j), static_cast<int>(j), 1.0);
    for (Sparse::InnerIterator it(strict, j); it; ++it)
      if (it.row() > j)
        elements.emplace_back(static_cast<int>(it.row()), static_cast<int>(j), it.value());
  }
  Sparse made(n, n);
  made.setFromTriplets(elements.begin(), elements.end());
  made.makeCompressed();
  return made;
}

// Z = D^-1 L^-1 + (I - L^T) Z, by columns from the last column to the first: Z_ij = -sum_k L_kj Z_ik over the rows k of
// column j. Rows i and k of one column have an element Z_ik themselves.
class Takahashi {
 public:
  Takahashi(const Sparse& factor, const Eigen::VectorXd& diagonal, Sparse& inverse)
      : starts_(factor.outerIndexPtr()),
        rows_(factor.innerIndexPtr()),
        l_(factor.valuePtr()),
        z_(inverse.valuePtr()),
        sums_(static_cast<size_t>(factor.rows()), 0),
        l_of_row_(static_cast<size_t>(factor.rows()), 0),
        is_row_(static_cast<size_t>(factor.rows()), 0) {
    for (Index j = factor.cols() - 1; j >= 0; --j) column(j, diagonal[j]);
  }

 private:
  void column(Index j, double pivot) {
    const auto first = starts_[j] + 1, end = starts_[j + 1];
    for (auto p = first; p < end; ++p) is_row_[at(rows_[p])] = 1, l_of_row_[at(rows_[p])] = l_[p];
    for (auto p = first; p < end; ++p) {
      const auto k = rows_[p];
      const double l = l_[p];
      sums_[at(k)] -= l * z_[starts_[k]];
      for (auto q = starts_[k] + 1; q < starts_[k + 1]; ++q) {
        const auto i = rows_[q];
        if (is_row_[at(i)] == 0) continue;
        sums_[at(i)] -= l * z_[q];
        sums_[at(k)] -= l_of_row_[at(i)] * z_[q];
      }
    }
    double own = 1 / pivot;
    for (auto p = first; p < end; ++p) {
      const size_t i = at(rows_[p]);
      z_[p] = sums_[i];
      own -= l_[p] * sums_[i];
      sums_[i] = 0, is_row_[i] = 0;
    }
    z_[starts_[j]] = own;
  }
  static size_t at(int i) { return static_cast<size_t>(i); }

  const int *starts_, *rows_;
  const double* l_;
  double* z_;
  std::vector<double> sums_, l_of_row_;
  std::vector<uint8_t> is_row_;
};

}  // namespace

SparseInverse::SparseInverse(const Factor& factor)
    : lower_(whole_factor(factor)), places_(factor.permutationP()) {
  const Sparse l = lower_;
  Takahashi(l, factor.vectorD(), lower_);
}

double SparseInverse::at(Eigen::Index row, Eigen::Index column) const {
  const auto place = [&](Index i) { return places_.size() > 0 ? Index{places_.indices()[i]} : i; };
  const auto [low, high] = std::minmax({place(row), place(column)});
  const int *rows = lower_.innerIndexPtr(), *from = rows + lower_.outerIndexPtr()[low],
            *to = rows + lower_.outerIndexPtr()[low + 1],
            *found = std::lower_bound(from, to, static_cast<int>(high));
  return found != to && *found == high ? lower_.valuePtr()[found - rows] : 0;
}

}  // namespace jalon
