// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/range_sample.h"

#include <cmath>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kRangeSampleGrain = 1 << 16;

struct Intensities {
  uint64_t n = 0;
  double sum = 0, squares = 0;
  Intensities& operator+=(const Intensities& b) {
    n += b.n;
    sum += b.sum;
    squares += b.squares;
    return *this;
  }
};

template <class At>
void set_intensity(const Column& column, size_t n, At&& at, Task& task, RangeSample& out) {
  const double about = column.number(at(0));  // near the mean: the squares stay small
  const Intensities sums =
      parallel_reduce(task, n, kRangeSampleGrain, Intensities{}, [&](size_t begin, size_t end) {
        Intensities part;
        for (size_t i = begin; i < end; ++i) {
          const double v = column.number(at(i)) - about;
          if (!std::isfinite(v)) continue;
          ++part.n;
          part.sum += v;
          part.squares += v * v;
        }
        return part;
      });
  if (sums.n == 0) return;
  const double count = static_cast<double>(sums.n), mean = sums.sum / count;
  out.mean_intensity = about + mean;
  if (sums.n > 1)
    out.std_intensity = std::sqrt(std::max(0.0, sums.squares - count * mean * mean) / (count - 1));
}

}  // namespace

RangeSample range_sample(const Cloud& cloud, std::span<const uint64_t> indices, Task& task) {
  for (const uint64_t i : indices)
    if (i >= cloud.size())
      fail(Status::kInvalidArgument, "index %llu; the cloud has %zu points",
           static_cast<unsigned long long>(i), cloud.size());
  const size_t n = indices.empty() ? cloud.size() : indices.size();
  if (n < 3) fail(Status::kInsufficientData, "a plane needs 3 points, not %zu", n);
  const auto at = [&](size_t i) { return indices.empty() ? i : static_cast<size_t>(indices[i]); };
  Moments zero;
  zero.reference = cloud.point(at(0));
  const Moments moments =
      parallel_reduce(task, n, kRangeSampleGrain, zero, [&](size_t begin, size_t end) {
        Moments part = zero;
        for (size_t i = begin; i < end; ++i) part.add(cloud.point(at(i)));
        return part;
      });
  RangeSample out;
  if (!fit_plane(moments, out.fit))
    fail(Status::kDegenerate, "the points of the sample are equal or collinear");
  const double count = static_cast<double>(n);
  out.range_precision_m = std::sqrt(out.fit.eigenvalues[0] * count / (count - 1));
  if (const Column* intensity = cloud.fields.find("intensity"))
    set_intensity(*intensity, n, at, task, out);
  return out;
}

}  // namespace jalon
