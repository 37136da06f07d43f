// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/numbers.h"
#include "base/random.h"
#include "segment/surface/plane_kernel.h"

namespace jalon::test {

/// A block of random points with normals, as the counting loops take it: every ninth was removed,
/// every fifth has no normal.
class PointBlock {
 public:
  explicit PointBlock(RandomStream& random) : values_(6 * kBlockPoints) {
    for (float& x : values_) x = static_cast<float>(2 * random.uniform() - 1);
    for (size_t i = 0; i < kBlockPoints; i += 9) values_[i] = kFloatNaN;
    for (size_t i = 0; i < kBlockPoints; i += 5) values_[3 * kBlockPoints + i] = kFloatNaN;
  }
  PointColumns points() const {
    const float* p = values_.data();
    return {p,
            p + kBlockPoints,
            p + 2 * kBlockPoints,
            p + 3 * kBlockPoints,
            p + 4 * kBlockPoints,
            p + 5 * kBlockPoints};
  }

 private:
  std::vector<float> values_;
};

}  // namespace jalon::test
