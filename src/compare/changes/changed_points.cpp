// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/changed_points.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kGrain = 1 << 15;

// A column with one number a point: of the comparison, else of its cloud.
const Column& number_column(const Comparison& comparison, const std::string& name) {
  const Column* column = comparison.points.find(name);
  if (column == nullptr) column = &comparison.cloud->fields.require(name);
  if (column->info().components != 1)
    fail(Status::kInvalidArgument, "field \"%.100s\" has %u components; one is needed",
         name.c_str(), column->info().components);
  return *column;
}

template <class F>
std::vector<uint8_t> where(size_t n, Task& task, F&& is_changed) {
  std::vector<uint8_t> changed(n);
  parallel_for(task, n, kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) changed[i] = is_changed(i) ? 1 : 0;
  });
  return changed;
}

/// Where the reference's points lie far apart, under grazing rays and across edges in depth, so may unchanged ones.
std::vector<uint8_t> beyond(const Comparison& comparison, double threshold_m, double spacing_share,
                            Task& task) {
  const auto distance = comparison.points.require("distance").values<double>();
  const Column* column = comparison.points.find("reference_spacing");
  if (column == nullptr)
    return where(distance.size(), task,
                 [&](size_t i) { return std::abs(distance[i]) > threshold_m; });
  const auto spacing = column->values<float>();
  return where(distance.size(), task, [&](size_t i) {
    const double apart = spacing[i] > 0 ? double{spacing[i]} : 0.0;
    return std::abs(distance[i]) > threshold_m + spacing_share * apart;
  });
}

std::vector<uint8_t> set_in(const Comparison& comparison, const std::string& name, Task& task) {
  const Column& column = number_column(comparison, name);
  return visit(column.info().type, [&](auto zero) {
    const auto values = column.values<decltype(zero)>();
    return where(values.size(), task,
                 [&](size_t i) { return values[i] != zero && values[i] == values[i]; });
  });
}

}  // namespace

std::vector<uint8_t> changed_points(const Comparison& comparison, const RegionSettings& settings,
                                    Task& task) {
  using Criterion = RegionSettings::Criterion;
  const Criterion criterion = settings.criterion;
  const bool has_level = comparison.points.find("significant") != nullptr;
  if (criterion == Criterion::kField) return set_in(comparison, settings.field, task);
  if (criterion == Criterion::kSignificance && !has_level)
    fail(Status::kInvalidArgument,
         "this comparison has no level of detection; method m3c2 gives one");
  if (criterion == Criterion::kSignificance || (criterion == Criterion::kAutomatic && has_level))
    return set_in(comparison, "significant", task);
  std::vector<uint8_t> changed =
      beyond(comparison, settings.threshold_m, settings.spacing_share, task);
  // What the tests of a comparison with detection explain is no change, however far.
  if (comparison.points.find("evidence") != nullptr) {
    const auto evidence = comparison.points.require("evidence").values<uint8_t>();
    for (size_t i = 0; i < changed.size(); ++i)
      if (evidence[i] == 0) changed[i] = 0;
  }
  return changed;
}

}  // namespace jalon
