// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/curved_kernel.h"

#include "segment/ransac/curved_kernel.inc"

namespace jalon {

uint32_t count_curved_avx2(const PointColumns& points, const CurvedTest& test) {
  return count_curved(points, test);
}

}  // namespace jalon
