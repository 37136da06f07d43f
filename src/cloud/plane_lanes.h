// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>

namespace jalon {

/// Smallest eigenvalue and eigenvector of four symmetric 3 x 3 matrices at once.
///
/// The smallest root of the characteristic polynomial by Newton's method from 0: all roots of a covariance are real and
/// not negative, so the steps rise to the smallest one and never pass it. The vector is the longest cross product of
/// two rows of C - lambda I (Eberly 2014). Close to double roots and to lines both lose digits: ok says where they did
/// not, and the others are left to symmetric_eigen.
class FourPlanes {
 public:
  using Four = double __attribute__((vector_size(32)));
  using Mask = long long __attribute__((vector_size(32)));

  /// Covariance of lane i (not divided by the number of points), xx xy xz yy yz zz.
  void set(int i, double xx, double xy, double xz, double yy, double yz, double zz) {
    const double values[6] = {xx, xy, xz, yy, yz, zz};
    for (int c = 0; c < 6; ++c) m_[c][i] = values[c];
  }
  void solve() {
    const Four trace = m_[0] + m_[3] + m_[5];
    const Four scale = 1 / trace;
    const Four a = m_[0] * scale, b = m_[1] * scale, c = m_[2] * scale, d = m_[3] * scale,
               e = m_[4] * scale, f = m_[5] * scale;
    const Four c1 = (a * d - b * b) + (a * f - c * c) + (d * f - e * e);
    const Four c0 = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d);
    Four root{}, step{};
    constexpr int kNewtonSteps =
        7;  // doubles the digits each time once it is near; ok says where these were too few
    for (int n = 0; n < kNewtonSteps; ++n) {
      const Four value = ((root - 1) * root + c1) * root - c0, slope = (3 * root - 2) * root + c1;
      step = value / slope;
      root -= step;
    }
    root = root > 0 ? root : Four{};
    const Four p = a - root, q = d - root, r = f - root;
    const Four x0 = b * e - c * q, y0 = c * b - p * e, z0 = p * q - b * b;  // row 0 x row 1
    const Four x1 = b * r - c * e, y1 = c * c - p * r, z1 = p * e - b * c;  // row 0 x row 2
    const Four x2 = q * r - e * e, y2 = e * c - b * r, z2 = b * e - q * c;  // row 1 x row 2
    const Four n0 = x0 * x0 + y0 * y0 + z0 * z0, n1 = x1 * x1 + y1 * y1 + z1 * z1,
               n2 = x2 * x2 + y2 * y2 + z2 * z2;
    const Mask second = n1 > n0;
    Four nx = second ? x1 : x0, ny = second ? y1 : y0, nz = second ? z1 : z0,
         squared = second ? n1 : n0;
    const Mask third = n2 > squared;
    nx = third ? x2 : nx, ny = third ? y2 : ny, nz = third ? z2 : nz,
    squared = third ? n2 : squared;
    for (int i = 0; i < 4; ++i) {
      const double inverse = 1 / __builtin_sqrt(squared[i]);
      normal[i][0] = nx[i] * inverse;
      normal[i][1] = ny[i] * inverse;
      normal[i][2] = nz[i] * inverse;
      variation[i] = root[i];
      // The cross product is about (lambda_1 - lambda_0) (lambda_2 - lambda_0) of a matrix of trace 1.
      constexpr double kLastStep = 1e-12, kShortest = 1e-8;
      ok[i] = step[i] < kLastStep && step[i] > -kLastStep && squared[i] > kShortest;
    }
  }

  double normal[4][3];
  double variation[4];  ///< lambda_0 / (lambda_0 + lambda_1 + lambda_2)
  bool ok[4];

 private:
  Four m_[6];
};

}  // namespace jalon
