// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/symmetric_eigen.h"

#include <cmath>
#include <utility>

namespace jalon {

Eigen3 symmetric_eigen(const Symmetric3& m) {
  double a[3][3] = {{m[0], m[1], m[2]}, {m[1], m[3], m[4]}, {m[2], m[4], m[5]}};
  double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr int kMaxSweeps = 24;  // quadratic convergence: 4-6 sweeps are usual
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    const double off = std::fabs(a[0][1]) + std::fabs(a[0][2]) + std::fabs(a[1][2]);
    if (off == 0) break;
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        const double scale = std::fabs(a[p][p]) + std::fabs(a[q][q]);
        if (scale + 1e-3 * std::fabs(a[p][q]) ==
            scale) {  // below a thousandth of an ulp of the diagonal
          a[p][q] = a[q][p] = 0;
          continue;
        }
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t =
            std::copysign(1.0, theta) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        const int r = 3 - p - q;
        const double apq = a[p][q], arp = a[r][p], arq = a[r][q];
        a[p][p] -= t * apq;
        a[q][q] += t * apq;
        a[p][q] = a[q][p] = 0;
        a[r][p] = a[p][r] = c * arp - s * arq;
        a[r][q] = a[q][r] = s * arp + c * arq;
        for (auto& row : v) {
          const double vp = row[p], vq = row[q];
          row[p] = c * vp - s * vq;
          row[q] = s * vp + c * vq;
        }
      }
  }
  int order[3] = {0, 1, 2};
  if (a[order[1]][order[1]] < a[order[0]][order[0]]) std::swap(order[0], order[1]);
  if (a[order[2]][order[2]] < a[order[1]][order[1]]) std::swap(order[1], order[2]);
  if (a[order[1]][order[1]] < a[order[0]][order[0]]) std::swap(order[0], order[1]);
  Eigen3 out;
  for (size_t i = 0; i < 3; ++i) {
    out.values[i] = a[order[i]][order[i]];
    out.vectors[i] = {v[0][order[i]], v[1][order[i]], v[2][order[i]]};
  }
  if (dot(cross(out.vectors[0], out.vectors[1]), out.vectors[2]) < 0)
    out.vectors[2] = -out.vectors[2];
  return out;
}

}  // namespace jalon
