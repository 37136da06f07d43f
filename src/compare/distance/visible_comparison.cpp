// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/visible_comparison.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "base/parallel.h"
#include "compare/distance/distance_columns.h"
#include "compare/summary.h"
#include "compare/visibility/recovery.h"
#include "compare/visibility/visibility.h"

namespace jalon {

namespace {

constexpr size_t kVisibleComparisonGrain = 1 << 15;  // rows a chunk

std::vector<uint64_t> points_with(std::span<const uint8_t> labels, Visibility label) {
  std::vector<uint64_t> out;
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == static_cast<uint8_t>(label)) out.push_back(i);
  return out;
}

/// The points alone: no method reads the fields of the compared points.
CloudPtr points_of(const Cloud& cloud, std::span<const uint64_t> indices, Task& task) {
  Buffer<double> xyz(3 * indices.size());
  parallel_for(task, indices.size(), kVisibleComparisonGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      std::memcpy(xyz.data() + 3 * i, cloud.xyz().data() + 3 * indices[i], 3 * sizeof(double));
  });
  Cloud out = make_cloud(std::move(xyz));
  out.crs = cloud.crs;
  return std::make_shared<const Cloud>(std::move(out));
}

/// "No value" of a column: NaN, no point, 0.
template <class T>
constexpr T nothing() {
  if constexpr (std::is_floating_point_v<T>) return std::numeric_limits<T>::quiet_NaN();
  else if constexpr (std::is_same_v<T, uint32_t>) return kNoPoint;
  else return 0;
}

/// The rows of the visible points among all n.
std::shared_ptr<Column> spread(const Column& column, std::span<const uint64_t> indices, size_t n) {
  auto out = std::make_shared<Column>(column.info(), n);
  const size_t components = column.info().components;
  visit(column.info().type, [&](auto zero) {
    using T = decltype(zero);
    const auto from = column.values<T>();
    const auto to = out->template values<T>();
    std::fill(to.begin(), to.end(), nothing<T>());
    for (size_t k = 0; k < indices.size(); ++k)
      for (size_t c = 0; c < components; ++c)
        to[indices[k] * components + c] = from[k * components + c];
  });
  return out;
}

/// Rows for all points from those of the visible ones.
FieldTable all_rows(const FieldTable& visible, std::span<const uint64_t> indices,
                    std::span<const uint8_t> labels) {
  FieldTable out;
  for (const ColumnPtr& column : visible) {
    auto all = spread(*column, indices, labels.size());
    if (column->info().name == "status") {
      const auto status = all->values<uint8_t>();
      for (size_t i = 0; i < labels.size(); ++i)
        if (labels[i] != 0) status[i] = labels[i];
    }
    out.set(std::move(all));
  }
  return out;
}

/// What the method adds to the summary stays; the counts are those of all points.
FieldTable whole_summary(const FieldTable& points, const FieldTable& of_visible, Task& task) {
  FieldTable out = summarise(points.require("distance").values<double>(),
                             points.require("status").values<uint8_t>(), task);
  for (const ColumnPtr& column : of_visible)
    if (out.find(column->info().name) == nullptr) out.set(column);
  return out;
}

ColumnPtr spacing_column(const VisibilityTest& test, const Cloud& cloud, Task& task) {
  auto column =
      std::make_shared<Column>(FieldInfo{"reference_spacing", ElementType::kFloat32, 1, "m",
                                         "of the reference's points where this one is seen"},
                               cloud.size());
  const auto out = column->values<float>();
  parallel_for(task, cloud.size(), kVisibleComparisonGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      out[i] = static_cast<float>(test.spacing_m(cloud.point(i)));
  });
  return column;
}

}  // namespace

Comparison compare_visible(const CloudPtr& reference, const CloudPtr& compared,
                           const DistanceSettings& settings, CompareRun run, Task& task) {
  // 1. Labels.
  const auto test = [&] {
    const ProgressSpan span(task, 0, 0.2);
    return VisibilityTest(*reference, settings.depth, task);
  }();
  const auto labels = [&] {
    const ProgressSpan span(task, 0.2, 0.3, "visibility");
    return visibility_labels(test, *compared, task);
  }();
  // 2. The method, on what was seen.
  const std::vector<uint64_t> visible = points_with(labels, Visibility::kVisible);
  Comparison made;
  {
    const ProgressSpan span(task, 0.3, 0.8);
    if (visible.empty()) {
      DistanceColumns(0, false).attach(made.points);
    } else {
      const CloudPtr seen =
          visible.size() == compared->size() ? compared : points_of(*compared, visible, task);
      made = run(reference, seen, settings, task);
    }
  }
  made.cloud = compared;
  made.points = all_rows(made.points, visible, labels);
  if (settings.reference_spacing) made.points.set(spacing_column(test, *compared, task));
  // 3. Hidden points.
  const ProgressSpan span(task, 0.8, 1, "hidden points");
  settings.hidden.check();
  if (settings.hidden.way != HiddenSettings::Way::kLeave)
    recover_hidden(*reference, *compared, test, points_with(labels, Visibility::kHidden),
                   settings.hidden, made.points, task);
  made.summary = whole_summary(made.points, made.summary, task);
  return made;
}

}  // namespace jalon
