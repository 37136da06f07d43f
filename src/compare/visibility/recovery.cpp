// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/recovery.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"

namespace jalon {

namespace {

std::shared_ptr<Column> recovered_column(size_t n) {
  auto column = std::make_shared<Column>(FieldInfo{"recovered", ElementType::kUint8, 1, "",
                                                   "0 not, 1 along a direction, 2 from what hides "
                                                   "it, 3 probably unchanged, 4 changed meanwhile"},
                                         n);
  std::fill_n(column->values<uint8_t>().begin(), n, uint8_t{0});
  return column;
}

std::shared_ptr<Column> empty_lengths(const char* name, const char* meaning, size_t n) {
  auto column =
      std::make_shared<Column>(FieldInfo{name, ElementType::kFloat64, 1, "m", meaning}, n);
  std::fill_n(column->values<double>().begin(), n, kNaN);
  return column;
}

/// The columns that a recovery writes.
struct Target {
  Target(const FieldTable& table, const char* extra, const char* meaning)
      : distance(empty_lengths("distance", table.require("distance").info().meaning.c_str(),
                               table.require("distance").count())),
        status(std::make_shared<Column>(table.require("status").info(), distance->count())),
        recovered(recovered_column(distance->count())),
        value(empty_lengths(extra, meaning, distance->count())) {
    std::copy_n(table.require("distance").values<double>().begin(), distance->count(),
                distance->values<double>().begin());
    std::copy_n(table.require("status").values<uint8_t>().begin(), distance->count(),
                status->values<uint8_t>().begin());
  }
  void set(size_t i, double metres, Recovered how) const {
    distance->values<double>()[i] = metres;
    status->values<uint8_t>()[i] = static_cast<uint8_t>(CompareStatus::kCompared);
    recovered->values<uint8_t>()[i] = static_cast<uint8_t>(how);
  }
  void attach(FieldTable& table) const {
    for (const auto& column : {distance, status, recovered, value}) table.set(column);
  }
  std::shared_ptr<Column> distance, status, recovered, value;
};

}  // namespace

void recover_hidden(const Cloud& reference, const Cloud& compared, const VisibilityTest& test,
                    std::span<const uint64_t> hidden, const HiddenSettings& settings,
                    FieldTable& points, Task& task) {
  if (settings.way == HiddenSettings::Way::kVertical) {
    const Target target(points, "height", "of a recovered point over the reference's surface");
    const auto heights = heights_along(reference, compared, hidden, settings.unit_direction(),
                                       settings.radius_m, task);
    for (size_t k = 0; k < hidden.size(); ++k) {
      if (std::isnan(heights[k])) continue;
      target.set(hidden[k], std::abs(heights[k]), Recovered::kAlongDirection);
      target.value->values<double>()[hidden[k]] = heights[k];
    }
    target.attach(points);
  } else {
    const Target target(points, "shape_residual",
                        "of a hidden zone after a rigid fit to what hides it");
    const OccluderMatch match =
        match_occluders(reference, compared, test, hidden, settings.zone_m, task);
    for (size_t k = 0; k < hidden.size(); ++k) {
      target.value->values<double>()[hidden[k]] = match.residuals[k];
      if (match.ratios[k] <= settings.shape_ratio)
        target.set(hidden[k], match.distances[k], Recovered::kOccluder);
    }
    target.attach(points);
  }
}

Comparison with_third_epoch(const Comparison& hidden, const Comparison& across, double tolerance_m,
                            Task& task) {
  const size_t n = hidden.cloud->size();
  if (across.cloud->size() != n ||
      !std::equal(hidden.cloud->xyz().begin(), hidden.cloud->xyz().end(),
                  across.cloud->xyz().begin()))
    fail(Status::kInvalidArgument, "the two comparisons are of different points");
  if (!(tolerance_m >= 0)) fail(Status::kInvalidArgument, "the tolerance must not be negative");
  const auto status = hidden.points.require("status").values<uint8_t>();
  const auto known = across.points.require("status").values<uint8_t>();
  const auto distance = across.points.require("distance").values<double>();
  const auto how = recovered_column(n);
  const Column* before = hidden.points.find("recovered");
  constexpr size_t kPerCheck = 1 << 18;
  for (size_t i = 0; i < n; ++i) {
    if (i % kPerCheck == 0) task.checkpoint(static_cast<double>(i) / static_cast<double>(n));
    uint8_t& out = how->values<uint8_t>()[i];
    if (before != nullptr) out = before->values<uint8_t>()[i];
    if (status[i] != static_cast<uint8_t>(CompareStatus::kHidden) ||
        known[i] != static_cast<uint8_t>(CompareStatus::kCompared))
      continue;
    out = static_cast<uint8_t>(std::abs(distance[i]) <= tolerance_m ? Recovered::kProbablyUnchanged
                                                                    : Recovered::kChangedMeanwhile);
  }
  Comparison made = hidden;
  made.points.set(how);
  return made;
}

}  // namespace jalon
