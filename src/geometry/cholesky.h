// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace jalon {

template <size_t K>
using Coefficients = std::array<double, K>;
/// Row-major; of symmetric matrices both triangles are kept.
template <size_t K>
using Square = std::array<double, K * K>;

/// Cholesky factor of a symmetric positive definite matrix (Golub & Van Loan, 4.2), for normal
/// equations of few unknowns.
template <size_t K>
class Cholesky {
 public:
  /// False when an unknown is not fixed: its pivot has lost twelve of the sixteen digits of its diagonal element.
  bool factor(const Square<K>& m) {
    constexpr double kPivotShare = 1e-12;
    for (size_t i = 0; i < K; ++i)
      for (size_t j = 0; j <= i; ++j) {
        double sum = m[K * i + j];
        for (size_t k = 0; k < j; ++k) sum -= l_[K * i + k] * l_[K * j + k];
        if (i != j) {
          l_[K * i + j] = sum / l_[K * j + j];
          continue;
        }
        if (!(sum > kPivotShare * m[K * i + i])) return false;
        l_[K * i + i] = std::sqrt(sum);
      }
    return true;
  }

  Coefficients<K> solve(Coefficients<K> x) const {
    for (size_t i = 0; i < K; ++i) {
      for (size_t k = 0; k < i; ++k) x[i] -= l_[K * i + k] * x[k];
      x[i] /= l_[K * i + i];
    }
    for (size_t i = K; i-- > 0;) {
      for (size_t k = i + 1; k < K; ++k) x[i] -= l_[K * k + i] * x[k];
      x[i] /= l_[K * i + i];
    }
    return x;
  }

  Square<K> inverse() const {
    Square<K> out{};
    for (size_t j = 0; j < K; ++j) {
      Coefficients<K> unit{};
      unit[j] = 1;
      const Coefficients<K> column = solve(unit);
      for (size_t i = 0; i < K; ++i) out[K * i + j] = column[i];
    }
    return out;
  }

 private:
  Square<K> l_{};
};

/// a b a for a symmetric a.
template <size_t K>
Square<K> sandwich(const Square<K>& a, const Square<K>& b) {
  Square<K> ab{}, out{};
  for (size_t i = 0; i < K; ++i)
    for (size_t j = 0; j < K; ++j)
      for (size_t k = 0; k < K; ++k) ab[K * i + j] += a[K * i + k] * b[K * k + j];
  for (size_t i = 0; i < K; ++i)
    for (size_t j = 0; j < K; ++j)
      for (size_t k = 0; k < K; ++k) out[K * i + j] += ab[K * i + k] * a[K * k + j];
  return out;
}

/// j m j^T for a matrix j of R rows and K columns, row-major.
template <size_t R, size_t K>
Square<R> propagated(const std::array<double, R * K>& j, const Square<K>& m) {
  std::array<double, R * K> jm{};
  for (size_t r = 0; r < R; ++r)
    for (size_t c = 0; c < K; ++c)
      for (size_t k = 0; k < K; ++k) jm[K * r + c] += j[K * r + k] * m[K * k + c];
  Square<R> out{};
  for (size_t r = 0; r < R; ++r)
    for (size_t s = 0; s < R; ++s)
      for (size_t k = 0; k < K; ++k) out[R * r + s] += jm[K * r + k] * j[K * s + k];
  return out;
}

}  // namespace jalon
