// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/symmetric_eigen6.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

using namespace jalon;

namespace {

Square<6> sum_of_squares(RandomStream& random, size_t terms) {
  Square<6> m{};
  for (size_t t = 0; t < terms; ++t) {
    Coefficients<6> row;
    for (double& value : row) value = 2 * random.uniform() - 1;
    for (size_t i = 0; i < 6; ++i)
      for (size_t j = 0; j < 6; ++j) m[6 * i + j] += row[i] * row[j];
  }
  return m;
}

double product(const Coefficients<6>& a, const Coefficients<6>& b) {
  double sum = 0;
  for (size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}

constexpr double kRounding = 1e-13;  // of matrices whose elements are some units at most

}  // namespace

TEST_CASE("symmetric_eigen6__values_ascend_and_vectors_give_the_matrix_back") {
  RandomStream random(5, 0);
  for (const size_t terms : {2, 6, 12}) {  // two terms: four values are 0
    const Square<6> m = sum_of_squares(random, terms);
    const Eigen6 eigen = symmetric_eigen(m, 1);
    for (size_t k = 0; k < 6; ++k) {
      if (k > 0) CHECK(eigen.values[k] >= eigen.values[k - 1]);
      for (size_t l = 0; l < 6; ++l)
        CHECK(std::abs(product(eigen.vectors[k], eigen.vectors[l]) - (k == l)) < kRounding);
    }
    for (size_t i = 0; i < 6; ++i)
      for (size_t j = 0; j < 6; ++j) {
        double sum = 0;
        for (size_t k = 0; k < 6; ++k)
          sum += eigen.values[k] * eigen.vectors[k][i] * eigen.vectors[k][j];
        CHECK(std::abs(sum - m[6 * i + j]) < kRounding);
      }
    if (terms == 2) CHECK(std::abs(eigen.values[3]) < kRounding);
  }
}

TEST_CASE("symmetric_eigen6__turns_are_taken_times_their_unit") {
  Square<6> m{};
  for (size_t i = 0; i < 6; ++i) m[7 * i] = 1;
  m[3] = m[18] = 0.25;  // the first turn and the first shift
  const Eigen6 eigen = symmetric_eigen(m, 10);
  // Of [100 2.5; 2.5 1] and the diagonal 100, 100, 1, 1.
  const double half = std::hypot(49.5, 2.5);
  CHECK(std::abs(eigen.values[0] - (50.5 - half)) < 100 * kRounding);
  CHECK(std::abs(eigen.values[5] - (50.5 + half)) < 100 * kRounding);
  CHECK(std::abs(eigen.values[1] - 1) < 100 * kRounding);
  CHECK(std::abs(eigen.values[4] - 100) < 100 * kRounding);
}
