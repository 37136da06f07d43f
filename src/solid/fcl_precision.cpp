// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/fcl_precision.h"

#include <cmath>

namespace jalon {

bool calculates_in_doubles(CcdPointTriangle point_triangle) {
  constexpr double kHeight = 1 + 1e-9;  // its square differs from 1 in doubles only
  const ccd_vec3_t a{{-1, -1, 0}}, b{{1, -1, 0}}, c{{0, 1, 0}}, point{{0, 0, kHeight}};
  ccd_vec3_t witness{{9, 9, 9}};
  const double squared = point_triangle(&point, &a, &b, &c, &witness);
  const double foot = std::abs(witness.v[0]) + std::abs(witness.v[1]) + std::abs(witness.v[2]);
  return std::abs(squared - kHeight * kHeight) < 1e-12 && foot < 1e-12;
}

}  // namespace jalon
