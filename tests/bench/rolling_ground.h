// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "base/random.h"
#include "cloud/cloud.h"

namespace jalon::test {

inline CloudPtr cloud_of(const std::vector<double>& xyz) {
  Buffer<double> buffer(xyz.size());
  std::copy(xyz.begin(), xyz.end(), buffer.data());
  return std::make_shared<const Cloud>(make_cloud(std::move(buffer)));
}

// Rolling ground of 60 m x 40 m as a scanner at its edge samples it, a heap on it on some days; 6 mm noise.
inline CloudPtr earthworks(size_t points, uint64_t day, bool with_heap) {
  RandomStream random(day, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < points; ++i) {
    const double range = 3 * std::pow(20.0, random.uniform()),
                 turn = std::numbers::pi * random.uniform();
    const double x = range * std::cos(turn), y = range * std::sin(turn);
    const double apart2 = (x - 8) * (x - 8) + (y - 12) * (y - 12);
    const double heap = with_heap ? std::max(0.0, 1 - apart2 / 2.25) : 0;
    const double z = 0.5 * std::sin(0.3 * x) * std::cos(0.2 * y) + heap;
    for (const double c : {x, y, z}) xyz.push_back(c + 0.006 * random.normal());
  }
  return cloud_of(xyz);
}

}  // namespace jalon::test
