// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/field_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kFieldValuesGrain = 1 << 15;

std::vector<uint32_t> finite_indices(std::span<const double> values) {
  std::vector<uint32_t> out;
  for (size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) out.push_back(static_cast<uint32_t>(i));
  return out;
}

double mean_of(std::span<const double> values, double from, bool squared, Task& task) {
  const double sum =
      parallel_reduce(task, values.size(), kFieldValuesGrain, 0.0, [&](size_t begin, size_t end) {
        double part = 0;
        for (size_t i = begin; i < end; ++i) {
          const double d = values[i] - from;
          part += squared ? d * d : d;
        }
        return part;
      });
  return sum / static_cast<double>(values.size());
}

}  // namespace

std::vector<double> scalar_values(const Cloud& cloud, std::string_view name, Task& task) {
  const Column& column = cloud.fields.require(name);
  if (column.info().components != 1)
    fail(Status::kInvalidArgument, "field \"%s\" has %u components; one is needed",
         column.info().name.c_str(), column.info().components);
  std::vector<double> out(column.count());
  visit(column.info().type, [&](auto zero) {
    using T = decltype(zero);
    const auto from = column.values<T>();
    parallel_for(task, out.size(), kFieldValuesGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) out[i] = static_cast<double>(from[i]);
    });
  });
  return out;
}

std::vector<double> finite_values(std::span<const double> values) {
  std::vector<double> out;
  out.reserve(values.size());
  for (const double v : values)
    if (std::isfinite(v)) out.push_back(v);
  return out;
}

MeanAndVariance mean_and_variance(std::span<const double> values, Task& task) {
  if (values.empty()) return {0, kNaN, kNaN};
  MeanAndVariance out;
  out.count = values.size();
  out.mean = values[0] + mean_of(values, values[0], false, task);
  out.variance = mean_of(values, out.mean, true, task);
  return out;
}

ValuedPoints valued_points(const Cloud& cloud, std::span<const double> values, Task& task) {
  ValuedPoints out;
  const std::vector<uint32_t> with = finite_indices(values);
  const bool all = with.size() == values.size();
  if (all) {
    out.tree = cloud.octree(task);
  } else {
    out.own_xyz = Buffer<double>(3 * with.size());
    for (size_t i = 0; i < with.size(); ++i)
      std::copy_n(cloud.xyz().data() + 3 * size_t{with[i]}, 3, out.own_xyz.data() + 3 * i);
    const Cube cube = with.empty() ? Cube{} : enclosing_cube(bounds(cloud, task));
    out.tree = Octree::build({out.own_xyz.data(), out.own_xyz.size()}, cube, task);
  }
  const auto order = out.tree->order();
  out.points.resize(order.size());
  out.values.resize(order.size());
  parallel_for(task, order.size(), kFieldValuesGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      out.points[i] = all ? order[i] : with[order[i]];
      out.values[i] = values[out.points[i]];
    }
  });
  return out;
}

Buffer<double> relative_coordinates(const Cloud& cloud, Task& task) {
  Buffer<double> out(3 * cloud.size());
  if (cloud.size() == 0) return out;
  const Vec3 origin = enclosing_cube(bounds(cloud, task)).origin;
  parallel_for(task, cloud.size(), kFieldValuesGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud.point(i) - origin;
      for (int c = 0; c < 3; ++c) out[3 * i + static_cast<size_t>(c)] = p[c];
    }
  });
  return out;
}

double mean_spacing(const Cloud& cloud, const ValuedPoints& valued) {
  constexpr size_t kSamples = 1000;
  constexpr uint32_t kNearest = 8;  // the point itself and seven others
  const size_t n = valued.size();
  if (n < kNearest) return kNaN;
  std::vector<double> squared;
  const size_t step = std::max<size_t>(1, n / kSamples);
  for (size_t i = step / 2; i < n; i += step) {
    Neighbour found[kNearest];
    valued.tree->knn(cloud.point(valued.points[i]), kNearest, found);
    squared.push_back(found[kNearest - 1].squared_distance);
  }
  const auto middle = squared.begin() + static_cast<ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return *middle > 0 ? std::sqrt(std::numbers::pi * *middle / (kNearest - 1)) : kNaN;
}

double radius_or_spacings(double radius_m, double factor, const Cloud& cloud,
                          const ValuedPoints& valued) {
  if (radius_m > 0) return radius_m;
  const double spacing_m = mean_spacing(cloud, valued);
  if (!(spacing_m > 0))
    fail(Status::kInsufficientData,
         "%zu points with a value give no spacing to take lengths from; state them", valued.size());
  return factor * spacing_m;
}

std::string unit_of(const Cloud& cloud, std::string_view field) {
  return cloud.fields.require(field).info().unit;
}

std::string require_field_name(const std::string& name) {
  if (name.empty()) fail(Status::kInvalidArgument, "the name of the new field is empty");
  return name;
}

}  // namespace jalon
