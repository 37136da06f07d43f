// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "base/random.h"
#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon::test {

inline Task::Hooks threads(unsigned count) {
  Task::Hooks hooks;
  hooks.threads = count;
  return hooks;
}

/// Two walls, a floor and some strays: sides of 20 m, n points in random order.
inline std::vector<double> street(size_t n, uint64_t seed = 1, double grid = 0) {
  RandomStream random(seed, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < n; ++i) {
    const double u = 20 * random.uniform(), v = 20 * random.uniform(), w = 20 * random.uniform();
    const double noise = 0.003 * random.normal();
    double p[3] = {u, v, w};
    const uint64_t kind = random.below(20);
    if (kind != 0) p[kind % 3] = noise;
    for (double c : p) xyz.push_back(grid > 0 ? std::round(c / grid) * grid : c);
  }
  return xyz;
}

inline Box3 box_of(const std::vector<double>& xyz) {
  Box3 box;
  for (size_t i = 0; i < xyz.size(); i += 3) box.add({xyz[i], xyz[i + 1], xyz[i + 2]});
  return box;
}

inline std::shared_ptr<const Octree> build(const std::vector<double>& xyz,
                                           unsigned thread_count = 2) {
  Task task(threads(thread_count));
  return Octree::build(xyz, enclosing_cube(box_of(xyz)), task);
}

inline Vec3 point(const std::vector<double>& xyz, size_t i) {
  return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
}

/// All distances, sorted by (distance, index): the ground truth.
inline std::vector<Neighbour> brute_force(const std::vector<double>& xyz, const Vec3& q, size_t k) {
  std::vector<Neighbour> all;
  for (size_t i = 0; i < xyz.size() / 3; ++i)
    all.push_back({squared_norm(point(xyz, i) - q), static_cast<uint32_t>(i)});
  const auto nearer = [](const Neighbour& a, const Neighbour& b) {
    return a.squared_distance < b.squared_distance ||
           (a.squared_distance == b.squared_distance && a.index < b.index);
  };
  k = std::min(k, all.size());
  std::partial_sort(all.begin(), all.begin() + static_cast<ptrdiff_t>(k), all.end(), nearer);
  all.resize(k);
  return all;
}

/// The batch form in the caller's order: n * k indices, kNoPoint-filled, and squared distances.
struct AllNeighbours {
  std::vector<uint32_t> index;
  std::vector<float> squared;
  bool operator==(const AllNeighbours&) const = default;
};
inline AllNeighbours all_knn(const Octree& tree, uint32_t k, unsigned thread_count = 2) {
  Task task(threads(thread_count));
  AllNeighbours out{std::vector<uint32_t>(tree.size() * k), std::vector<float>(tree.size() * k)};
  tree.for_each_knn(k, task, [&](const Octree::Batch& b) {
    for (size_t i = 0; i < b.count; ++i)
      for (size_t j = 0; j < k; ++j) {
        const uint32_t position = b.neighbours[i * k + j];
        const size_t to = tree.order()[b.first + i] * size_t{k} + j;
        out.index[to] = position == kNoPoint ? kNoPoint : tree.order()[position];
        out.squared[to] = b.squared[i * k + j];
      }
  });
  return out;
}

}  // namespace jalon::test
