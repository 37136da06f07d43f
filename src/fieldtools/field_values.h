// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel.h"
#include "base/params.h"
#include "cloud/cloud.h"

namespace jalon {

/// Stands where a point has no value; infinite values count as none either.

/// The values of a field of one component, as doubles. kNotFound lists the names there are; kInvalidArgument for
/// vectors.
std::vector<double> scalar_values(const Cloud& cloud, std::string_view name, Task& task);
/// Those that are finite, in order.
std::vector<double> finite_values(std::span<const double> values);
/// In the order of less, in parallel: chunks are sorted, then merged two by two. Equal elements keep no order.
template <class T, class Less>
std::vector<T> sorted_in_chunks(std::vector<T> values, Less less, Task& task) {
  constexpr size_t kChunk = 1 << 15;
  const size_t n = values.size();
  {
    ProgressSpan span(task, 0, 0.5);
    parallel_for(task, n, kChunk, [&](size_t begin, size_t end) {
      std::sort(values.data() + begin, values.data() + end, less);
    });
  }
  ProgressSpan span(task, 0.5, 1);
  std::vector<T> merged(n);
  for (size_t run = kChunk; run < n; run *= 2) {
    parallel_for(task, n, 2 * run, [&](size_t begin, size_t end) {
      const T* from = values.data();
      const size_t middle = std::min(end, begin + run);
      std::merge(from + begin, from + middle, from + middle, from + end, merged.data() + begin,
                 less);
    });
    values.swap(merged);
  }
  return values;
}
/// Ascending.
inline std::vector<double> sorted_values(std::vector<double> values, Task& task) {
  return sorted_in_chunks(std::move(values), std::less<>(), task);
}

struct MeanAndVariance {
  uint64_t count = 0;
  double mean = 0, variance = 0;  ///< divided by count
};
/// In two passes over fixed chunks, so that neither size nor threads cost digits. NaN for no values.
MeanAndVariance mean_and_variance(std::span<const double> values, Task& task);

/// The points that have a value, under a tree of their own where some have none: a neighbourhood of n points then holds
/// n values.
struct ValuedPoints {
  Buffer<double> own_xyz;  ///< empty when all points have a value
  std::shared_ptr<const Octree> tree;
  std::vector<uint32_t> points;  ///< by sorted position: index in the cloud
  std::vector<double> values;    ///< by sorted position
  size_t size() const { return points.size(); }
};
ValuedPoints valued_points(const Cloud& cloud, std::span<const double> values, Task& task);

/// Coordinates from the corner of the cube around the cloud, which moves with it by whole metres.
Buffer<double> relative_coordinates(const Cloud& cloud, Task& task);

/// Mean distance between neighbours on a surface, 1 / sqrt(density), from the median density around up to 1 000 points
/// spread over the tree's order. NaN for fewer than 8 points or when most of them coincide.
double mean_spacing(const Cloud& cloud, const ValuedPoints& valued);
/// radius_m, or factor times the mean spacing where it is 0: kInsufficientData when that has no answer.
double radius_or_spacings(double radius_m, double factor, const Cloud& cloud,
                          const ValuedPoints& valued);

/// A copy of the cloud with one more field of one component.
template <class T>
Cloud with_field(const Cloud& cloud, const std::string& name, const char* unit, const char* meaning,
                 std::span<const T> values) {
  Cloud out = cloud;
  out.fields.set(make_column<T>({name, element_type_of<T>(), 1, unit, meaning}, values));
  return out;
}
/// The unit that a field has.
std::string unit_of(const Cloud& cloud, std::string_view field);
/// A name for a new field: kInvalidArgument when it is empty.
std::string require_field_name(const std::string& name);

}  // namespace jalon
