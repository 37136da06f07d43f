// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/parallel.h"
#include "base/setting_rows.h"
#include "cloud/operations.h"

namespace jalon {

namespace {

constexpr size_t kOutliersGrain = 1 << 15;

struct Sums {
  double sum = 0;
  uint64_t n = 0;
  Sums& operator+=(const Sums& b) {
    sum += b.sum;
    n += b.n;
    return *this;
  }
  double mean() const { return n > 0 ? sum / static_cast<double>(n) : 0; }
};

/// Mean distance of each point to its k nearest others, in the tree's order: sums then do not
/// depend on the threads.
std::vector<float> mean_distances(const Octree& tree, uint32_t k, Task& task) {
  std::vector<float> out(tree.size());
  tree.for_each_knn(k + 1, task, [&](const Octree::Batch& batch) {
    for (size_t i = 0; i < batch.count; ++i) {
      double sum = 0;
      uint32_t n = 0;
      for (uint32_t j = 0; j < batch.k && batch.neighbours[i * batch.k + j] != kNoPoint; ++j, ++n)
        sum +=
            std::sqrt(double{batch.squared[i * batch.k + j]});  // its own distance 0 adds nothing
      out[batch.first + i] = n > 1 ? static_cast<float>(sum / (n - 1)) : 0.0f;
    }
  });
  return out;
}

std::vector<uint8_t> statistical_mask(const Octree& tree, uint32_t k, double sigmas, Task& task) {
  std::vector<float> distance;
  {
    ProgressSpan span(task, 0, 0.9);
    distance = mean_distances(tree, k, task);
  }
  ProgressSpan span(task, 0.9, 1);
  const auto sum_over = [&](auto&& term) {
    return parallel_reduce(task, distance.size(), kOutliersGrain, Sums{},
                           [&](size_t begin, size_t end) {
                             Sums part;
                             for (size_t i = begin; i < end; ++i)
                               part += Sums{term(double{distance[i]}), 1};
                             return part;
                           });
  };
  const double mean = sum_over([](double d) { return d; }).mean();
  const double variance = sum_over([&](double d) { return (d - mean) * (d - mean); }).mean();
  const double limit = mean + sigmas * std::sqrt(variance);
  std::vector<uint8_t> keep(tree.size());
  const auto order = tree.order();
  parallel_for(task, tree.size(), kOutliersGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) keep[order[i]] = double{distance[i]} <= limit;
  });
  return keep;
}

/// The n-th nearest other point decides, so that a large ball costs no more than a small one.
std::vector<uint8_t> radius_mask(const Octree& tree, double radius_m, uint32_t neighbours,
                                 Task& task) {
  std::vector<uint8_t> keep(tree.size());
  const auto order = tree.order();
  tree.for_each_knn(neighbours + 1, task, [&](const Octree::Batch& batch) {
    for (size_t i = 0; i < batch.count; ++i) {
      const size_t last = i * batch.k + neighbours;
      keep[order[batch.first + i]] =
          batch.neighbours[last] != kNoPoint && double{batch.squared[last]} <= radius_m * radius_m;
    }
  });
  return keep;
}

}  // namespace

std::span<const ParamRow> outliers_rows() {
  using S = OutliersSettings;
  static constexpr auto kRows = setting_rows(
      choice_row<&S::method>("method", "statistical|radius", "",
                             "statistical: far from its neighbours compared with the other points; "
                             "radius: too few neighbours in a ball"),
      integer_row<&S::k>("k", 1, 255, "points", "statistical",
                         "Number of nearest neighbours, the point itself not counted"),
      number_row<&S::sigmas>("sigmas", 0, 100, "1", "statistical",
                             "A point goes when its mean distance to its neighbours exceeds the "
                             "mean of all by this many standard deviations"),
      number_row<&S::radius_m>("radius_m", 1e-6, 1e6, "m", "radius",
                               "Radius of the ball around each point"),
      integer_row<&S::neighbours>("neighbours", 1, 255, "points", "radius",
                                  "A point stays when at least this many others are in its ball"));
  return kRows;
}

Cloud without_outliers(const Cloud& cloud, const OutliersSettings& settings, Task& task) {
  if (cloud.size() == 0) return cloud;
  std::shared_ptr<const Octree> tree;
  {
    ProgressSpan span(task, 0, 0.2, "index");
    tree = cloud.octree(task);
  }
  std::vector<uint8_t> keep;
  {
    ProgressSpan span(task, 0.2, 0.9, "outliers");
    keep = settings.method == OutliersSettings::Method::kRadius
               ? radius_mask(*tree, settings.radius_m, settings.neighbours, task)
               : statistical_mask(*tree, settings.k, settings.sigmas, task);
  }
  ProgressSpan span(task, 0.9, 1, "copying");
  return select_mask(cloud, keep, 1, task);
}

}  // namespace jalon
