// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/sampling_error.h"

#include <cmath>
#include <numbers>

#include "base/buffer.h"
#include "base/numbers.h"
#include "base/parallel.h"

namespace jalon {

namespace {

// Points around a reference point that tell its density, itself included: R^2 scatters by 1 / sqrt(k), a quarter.
constexpr uint32_t kDensityPoints = 17;

// For every reference point, in the caller's order, R^2 = 1 / (pi lambda). Around a point of a random plane, pi lambda
// r^2 of the j-th other point has the gamma law of order j. But queries fall to the points that stand where the others
// are thin, in proportion to the area that is theirs: seen from the queries the order is j + 1, and r^2 / (j + 1)
// estimates R^2 without bias.
Buffer<float> squared_errors(const Octree& tree, Task& task) {
  Buffer<float> out(tree.size());
  const auto order = tree.order();
  tree.for_each_knn(kDensityPoints, task, [&](const Octree::Batch& batch) {
    for (size_t i = 0; i < batch.count; ++i) {
      const uint32_t* neighbours = batch.neighbours + i * batch.k;
      uint32_t last = batch.k - 1;
      while (last > 0 && neighbours[last] == kNoPoint) --last;
      const float squared = batch.squared[i * size_t{batch.k} + last];
      out[order[batch.first + i]] = last > 0 ? squared / static_cast<float>(last + 1) : kFloatNaN;
    }
  });
  return out;
}

struct Sums {
  double squares = 0, roots = 0, count = 0;
  Sums& operator+=(const Sums& b) {
    squares += b.squares, roots += b.roots, count += b.count;
    return *this;
  }
};

}  // namespace

SamplingError predict_sampling_error(const Octree& reference, std::span<const uint32_t> nearest,
                                     Task& task) {
  SamplingError out;
  FieldInfo info{"sampling_error", ElementType::kFloat32, 1, "m",
                 "rms distance that the reference's sampling makes"};
  out.column = std::make_shared<Column>(std::move(info), nearest.size());
  float* errors = out.column->values<float>().data();
  const Buffer<float> squared = squared_errors(reference, task);
  constexpr size_t kGrain = size_t{1} << 15;
  const Sums sums =
      parallel_reduce(task, nearest.size(), kGrain, Sums{}, [&](size_t begin, size_t end) {
        Sums part;
        for (size_t i = begin; i < end; ++i) {
          const float square = nearest[i] == kNoPoint ? kFloatNaN : squared[nearest[i]];
          errors[i] = std::sqrt(square);
          if (square != square) continue;
          part += {square, std::sqrt(static_cast<double>(square)), 1};
        }
        return part;
      });
  const double per_point = sums.count > 0 ? 1 / sums.count : kNaN;
  out.rms_m = std::sqrt(sums.squares * per_point);
  // 1 / (2 sqrt(lambda)) = R sqrt(pi) / 2
  out.mean_m = sums.roots * per_point * std::sqrt(std::numbers::pi) / 2;
  return out;
}

}  // namespace jalon
