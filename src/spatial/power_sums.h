// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "geometry/vec.h"

namespace jalon {

/// Sums of x^a y^b z^c, a + b + c <= Degree, over some points as seen from a place: what least squares of planes (2)
/// and of quadrics (4) need of them. Points that are summed once may be seen from many places (Greengard & Rokhlin
/// 1987, A fast algorithm for particle simulations: moments of cells, shifted); a shift costs what some three points do
/// and rounds as adding them from the new place would.
template <int Degree>
class PowerSums {
 public:
  static constexpr size_t kTerms = (Degree + 1) * (Degree + 2) * (Degree + 3) / 6;
  /// The place of a term among the sums.
  static constexpr size_t index(int a, int b, int c) { return kRow[b][c] + static_cast<size_t>(a); }

  double of(int a, int b, int c) const { return sums_[index(a, b, c)]; }
  double count() const { return sums_[0]; }

  void add(const Vec3& p) {
    double z = 1;
    unrolled<0, Degree>([&](auto c) {
      double yz = z;
      unrolled<0, Degree - c.value>([&](auto b) {
        double term = yz;
        unrolled<0, Degree - c.value - b.value>([&](auto a) {
          sums_[index(a, b, c)] += term;
          term *= p.x;
        });
        yz *= p.y;
      });
      z *= p.z;
    });
  }
  PowerSums& operator+=(const PowerSums& b) {
    for (size_t i = 0; i < kTerms; ++i) sums_[i] += b.sums_[i];
    return *this;
  }
  /// Those of the same points, each moved by d.
  PowerSums shifted(const Vec3& d) const {
    PowerSums out = *this;
    // An axis after the other: the binomials of (x + d)^n as products of steps that add a neighbour d times.
    out.shift_rows(d.x, [](auto n, auto i, auto j) { return index(n, i, j); });
    out.shift_rows(d.y, [](auto n, auto i, auto j) { return index(i, n, j); });
    out.shift_rows(d.z, [](auto n, auto i, auto j) { return index(i, j, n); });
    return out;
  }
  /// Those of the same points in a unit that many times as large.
  PowerSums in_units_of(double unit) const {
    PowerSums out;
    const double inverse = 1 / unit;
    size_t i = 0;
    double z = 1;
    for (int c = 0; c <= Degree; ++c, z *= inverse) {
      double yz = z;
      for (int b = 0; b <= Degree - c; ++b, yz *= inverse) {
        double term = yz;
        for (int a = 0; a <= Degree - c - b; ++a, term *= inverse, ++i)
          out.sums_[i] = sums_[i] * term;
      }
    }
    return out;
  }

 private:
  // f(First) ... f(Last), as constants: what they name is known when the loop is compiled, a row stays in registers. A
  // fifth of the instructions of loops.
  template <int First, int Last, class F>
  static void unrolled(const F& f) {
    if constexpr (First <= Last) {
      f(std::integral_constant<int, First>{});
      unrolled<First + 1, Last>(f);
    }
  }

  template <class Index>
  void shift_rows(double d, Index index_of) {
    unrolled<0, Degree>([&](auto i) {
      unrolled<0, Degree - i.value>([&](auto j) {
        constexpr int kLast = Degree - i.value - j.value;
        std::array<double, kLast + 1> row;
        unrolled<0, kLast>([&](auto n) { row[n] = sums_[index_of(n, i, j)]; });
        unrolled<1, kLast>([&](auto step) {
          unrolled<0, kLast - step.value>([&](auto k) {
            constexpr size_t n = kLast - k.value;
            row[n] += d * row[n - 1];
          });
        });
        unrolled<1, kLast>([&](auto n) { sums_[index_of(n, i, j)] = row[n]; });
      });
    });
  }
  // Where the terms of y^b z^c begin.
  static constexpr auto kRow = [] {
    std::array<std::array<size_t, Degree + 1>, Degree + 1> row{};
    size_t at = 0;
    for (int c = 0; c <= Degree; ++c)
      for (int b = 0; b <= Degree - c; ++b) {
        row[static_cast<size_t>(b)][static_cast<size_t>(c)] = at;
        at += static_cast<size_t>(Degree - c - b + 1);
      }
    return row;
  }();

  std::array<double, kTerms> sums_{};
};

}  // namespace jalon
