// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "base/random.h"
#include "base/task.h"
#include "compare/distance/distance.h"

namespace jalon::test {

inline CloudPtr cloud_of(const std::vector<double>& xyz) {
  Buffer<double> buffer(xyz.size());
  std::copy(xyz.begin(), xyz.end(), buffer.data());
  return std::make_shared<const Cloud>(make_cloud(std::move(buffer)));
}

inline Comparison compared(const CloudPtr& reference, const CloudPtr& compared,
                           const DistanceSettings& settings = {}, unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return compare_distance(reference, compared, settings, task);
}

inline double summary(const Comparison& comparison, const char* name) {
  return comparison.summary.require(name).number(0);
}

/// n random points of the square [0, side) x [0, side) at a height, each axis with normal noise.
inline std::vector<double> random_square(size_t n, double side, double height, uint64_t seed,
                                         double noise = 0) {
  RandomStream random(seed, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < n; ++i) {
    const double p[3] = {side * random.uniform(), side * random.uniform(), height};
    for (const double c : p) xyz.push_back(noise > 0 ? c + noise * random.normal() : c);
  }
  return xyz;
}

}  // namespace jalon::test
