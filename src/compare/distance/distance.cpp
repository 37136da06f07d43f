// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Method "distance": from each compared point to the nearest reference point (Girardeau-Montaut 2006, 2.3.1).

#include "compare/distance/distance.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/table_columns.h"
#include "compare/detection/detection.h"
#include "compare/detection/found_stations.h"
#include "compare/distance/distance_columns.h"
#include "compare/distance/hausdorff.h"
#include "compare/distance/local_models.h"
#include "compare/distance/sampling_error.h"
#include "compare/distance/visible_comparison.h"
#include "compare/summary.h"
#include "spatial/neighbours/nearest.h"

namespace jalon {

namespace {

struct Trees {
  std::shared_ptr<const Octree> reference, compared;
};

Trees trees_of(const Cloud& reference, const Cloud& compared, Task& task) {
  Trees trees;
  {
    ProgressSpan span(task, 0, 0.5, "index of the reference");
    trees.reference = reference.octree(task);
  }
  ProgressSpan span(task, 0.5, 1, "index of the compared cloud");
  trees.compared = compared.octree(task);
  return trees;
}

// positions, if any: for each sorted position of the compared points that of the nearest reference point.
void nearest_points(const Cloud& reference, const Cloud& compared, const Trees& trees,
                    double max_distance_m, const DistanceColumns& columns,
                    std::span<uint32_t> positions, Task& task) {
  const auto reference_order = trees.reference->order(), order = trees.compared->order();
  for_each_nearest(
      *trees.reference, *trees.compared, max_distance_m, task, [&](const NearestBatch& batch) {
        if (!positions.empty())
          std::copy_n(batch.nearest, batch.count, positions.data() + batch.first);
        for (size_t j = 0; j < batch.count; ++j) {
          const size_t i = order[batch.first + j];
          const bool found = batch.nearest[j] != kNoPoint;
          const uint32_t nearest = found ? reference_order[batch.nearest[j]] : kNoPoint;
          columns.distances[i] = found ? std::sqrt(batch.squared[j]) : kNaN;
          columns.nearests[i] = nearest;
          columns.statuses[i] =
              static_cast<uint8_t>(found ? CompareStatus::kCompared : CompareStatus::kNothingNear);
          if (columns.differences[0] != nullptr)
            columns.set_difference(
                i, found ? compared.point(i) - reference.point(nearest) : Vec3{kNaN, kNaN, kNaN});
        }
      });
}

void add_sampling_error(const Octree& reference, const DistanceColumns& columns, Comparison& made,
                        Task& task) {
  const SamplingError error =
      predict_sampling_error(reference, {columns.nearests, columns.nearest->count()}, task);
  made.points.set(error.column);
  add_value<double>(made.summary, "sampling_rms", "m",
                    "root mean square distance that sampling alone would make", error.rms_m);
  add_value<double>(made.summary, "sampling_mean", "m",
                    "mean distance that sampling alone would make", error.mean_m);
}

Comparison compare_all(const CloudPtr& reference, const CloudPtr& compared,
                       const DistanceSettings& settings, Task& task) {
  Trees trees;
  {
    ProgressSpan span(task, 0, 0.3);
    trees = trees_of(*reference, *compared, task);
  }
  const DistanceColumns columns(compared->size(), settings.differences);
  Comparison made;
  made.cloud = compared;
  const bool with_model = settings.local_model != LocalModelKind::kNone;
  uint64_t modelled = 0;
  {
    ProgressSpan span(task, 0.3, 0.8);
    Buffer<uint32_t> positions(with_model ? compared->size() : 0);
    {
      ProgressSpan part(task, 0, with_model ? 0.3 : 1, "nearest points");
      nearest_points(*reference, *compared, trees, settings.limit_m(), columns,
                     {positions.data(), positions.size()}, task);
    }
    ProgressSpan part(task, with_model ? 0.3 : 1, 1, "local models");
    if (with_model)
      modelled = apply_local_models(*trees.reference, *trees.compared, *compared,
                                    {positions.data(), positions.size()}, settings, columns, task);
  }
  columns.attach(made.points);
  made.summary =
      summarise(columns.distance->values<double>(), columns.status->values<uint8_t>(), task);
  if (with_model)
    add_value<uint64_t>(made.summary, "modelled", "", "points whose distance is to a local surface",
                        modelled);
  if (settings.sampling_error) {
    ProgressSpan span(task, 0.8, 0.9, "sampling error");
    add_sampling_error(*trees.reference, columns, made, task);
  }
  if (settings.hausdorff) {
    ProgressSpan span(task, 0.9, 1);
    add_hausdorff(*trees.reference, *trees.compared, task, made.summary);
  }
  return made;
}

// Nearest points, then tests of the surfaces about them.
Comparison detect(const CloudPtr& reference, const CloudPtr& compared,
                  const DistanceSettings& settings, Task& task) {
  DistanceSettings nearest = settings;
  nearest.local_model = LocalModelKind::kNone;
  Comparison made = [&] {
    const ProgressSpan span(task, 0, 0.5);
    return compare_all(reference, compared, nearest, task);
  }();
  const ProgressSpan span(task, 0.5, 1);
  const bool use_stations = settings.visibility != DistanceSettings::VisibleFrom::kAnywhere;
  add_detection(reference, compared, use_stations,
                {settings.false_discovery_rate, settings.alignment_sigma_m}, made, task);
  return made;
}

}  // namespace

Comparison compare_distance(const CloudPtr& reference, const CloudPtr& compared,
                            const DistanceSettings& settings, Task& task) {
  if (reference->size() == 0) fail(Status::kInsufficientData, "the reference cloud is empty");
  if (compared->size() == 0) fail(Status::kInsufficientData, "the compared cloud is empty");
  if (settings.visibility == DistanceSettings::VisibleFrom::kFound) {
    DistanceSettings known = settings;
    const auto seen = [&](const CloudPtr& cloud, double from) {
      const ProgressSpan span(task, from, from + 0.025, "stations");
      return with_found_stations(cloud, task);
    };
    const CloudPtr from = seen(reference, 0), to = seen(compared, 0.025);
    known.visibility = has_all_stations(*from) ? DistanceSettings::VisibleFrom::kStations
                                               : DistanceSettings::VisibleFrom::kAnywhere;
    const ProgressSpan span(task, 0.05, 1);
    return compare_distance(from, to, known, task);
  }
  if (settings.detection) return detect(reference, compared, settings, task);
  if (settings.visibility == DistanceSettings::VisibleFrom::kAnywhere)
    return compare_all(reference, compared, settings, task);
  return compare_visible(reference, compared, settings, compare_all, task);
}

}  // namespace jalon
