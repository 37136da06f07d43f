// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/plane_kernel.h"

#include "segment/surface/plane_kernel.inc"

namespace jalon {

uint32_t count_block_avx2(const PointColumns& points, const PlaneTest& test) {
  return count_block(points, test);
}

}  // namespace jalon
