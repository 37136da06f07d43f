// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/detection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/numbers.h"
#include "base/parallel.h"
#include "base/table_columns.h"
#include "cloud/statistics.h"
#include "compare/detection/coherence.h"
#include "compare/detection/found_stations.h"
#include "compare/detection/kept_cores.h"
#include "compare/summary.h"
#include "spatial/neighbours/nearest.h"

namespace jalon {

namespace {

constexpr double kLevelSigmas = 1.96;  // 95 %, of a single test

struct DetectionColumns {
  explicit DetectionColumns(size_t n)
      : level(std::make_shared<Column>(
            FieldInfo{"level_of_detection", ElementType::kFloat32, 1, "m",
                      "95 %, of the surface about the point; NaN: no surface to compare with"},
            n)),
        significant(std::make_shared<Column>(
            FieldInfo{"significant", ElementType::kUint8, 1, "", "1 = changed"}, n)),
        evidence(std::make_shared<Column>(
            FieldInfo{"evidence", ElementType::kUint8, 1, "",
                      "of a change: 1 a surface that both epochs saw moved, 2 the other epoch saw "
                      "through this place or, without stations, has nothing near"},
            n)) {}
  std::shared_ptr<Column> level, significant, evidence;
};

/// Distances and verdicts of points from those of the cores that they lie about.
class Spreader {
 public:
  Spreader(const SurfaceCores& reference, const CoreTests& tests, const Cloud& compared,
           const Vec3& origin, Comparison& made)
      : reference_(reference),
        tests_(tests),
        compared_(compared),
        origin_(origin),
        columns_(compared.size()),
        distance_(
            std::make_shared<Column>(made.points.require("distance").info(), compared.size())),
        status_(std::make_shared<Column>(made.points.require("status").info(), compared.size())),
        nearest_m_(made.points.require("distance").values<double>()) {}

  void spread(size_t core, size_t point) {
    const CoreTest& test = tests_.cores[core];
    double distance = nearest_m_[point];
    if (test.has_surface) {
      const SurfaceCore& surface = reference_[test.surface];
      const Vec3 p = compared_.point(point) - origin_;
      const double from_surface = std::abs(dot(surface.normal, p - surface.centroid));
      if (from_surface < distance) distance = from_surface;
    }
    const bool is_untold = test.state == CoreState::kUntold;
    const bool is_far = !(distance >= 0);  // beyond the greatest distance
    const bool is_changed = test.state == CoreState::kMoved || test.state == CoreState::kNew;
    distance_->values<double>()[point] = is_untold ? kNaN : distance;
    status_->values<uint8_t>()[point] = static_cast<uint8_t>(is_untold ? CompareStatus::kHidden
                                                             : is_far  ? CompareStatus::kNothingNear
                                                                       : CompareStatus::kCompared);
    columns_.level->values<float>()[point] = static_cast<float>(
        test.has_surface ? kLevelSigmas * tests_.null_scale * test.sigma_m : kNaN);
    columns_.significant->values<uint8_t>()[point] = is_changed ? 1 : 0;
    columns_.evidence->values<uint8_t>()[point] =
        static_cast<uint8_t>(!is_changed                       ? ChangeEvidence::kNone
                             : test.state == CoreState::kMoved ? ChangeEvidence::kMovedSurface
                                                               : ChangeEvidence::kSeenThrough);
  }

  void attach(FieldTable& points) const {
    for (const auto& column :
         {distance_, status_, columns_.level, columns_.significant, columns_.evidence})
      points.set(column);
  }

 private:
  const SurfaceCores& reference_;
  const CoreTests& tests_;
  const Cloud& compared_;
  Vec3 origin_;
  DetectionColumns columns_;
  std::shared_ptr<Column> distance_, status_;
  std::span<const double> nearest_m_;
};

void add_choice(const CoreTests& tests, uint64_t stations, double rate, FieldTable& summary) {
  add_value<double>(summary, "noise", "m", "scatter of the points about smooth surfaces",
                    tests.noise_m);
  add_value<double>(summary, "null_scale", "1",
                    "by which unchanged surfaces differ more than noise explains",
                    tests.null_scale);
  add_value<double>(summary, "misalignment", "m",
                    "by which most surfaces differ beside noise, in all levels of detection",
                    tests.misalignment_m);
  add_value<double>(summary, "limit_sigmas", "1",
                    "beyond which a surface has moved, by the rate of false discoveries",
                    tests.limit_sigmas);
  add_value<double>(summary, "false_discovery_rate", "1", "asked for", rate);
  add_value<uint64_t>(summary, "tests", "", "surfaces that were tested", tests.tested);
  add_value<uint64_t>(summary, "stations", "", "of the reference, known or found; 0: none",
                      stations);
}

CorePair cores_of(const Cloud& reference, const Cloud& compared, const Vec3& origin, Task& task) {
  CorePair out;
  {
    const ProgressSpan span(task, 0, 0.5, "surfaces");
    out.reference = std::make_shared<const SurfaceCores>(reference, origin, task);
  }
  const ProgressSpan span(task, 0.5, 1, "surfaces");
  out.compared = std::make_shared<const SurfaceCores>(compared, origin, task);
  return out;
}

// The same for both ways of a comparison, which so have the same surfaces.
Vec3 common_origin(const Cloud& a, const Cloud& b, Task& task) {
  const Vec3 p = local_origin(a, task), q = local_origin(b, task);
  return {std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)};
}

}  // namespace

void add_detection(const CloudPtr& reference, const CloudPtr& compared, bool use_stations,
                   const DetectionRates& rates, Comparison& made, Task& task) {
  const Vec3 origin = common_origin(*reference, *compared, task);
  // 1. Surfaces of both.
  CorePair pair = take_kept_cores(*reference, *compared, origin, task);
  const bool is_kept = pair.reference != nullptr;
  if (!is_kept) {
    const ProgressSpan span(task, 0, 0.7);
    pair = cores_of(*reference, *compared, origin, task);
  }
  const SurfaceCores &surfaces = *pair.reference, &cores = *pair.compared;
  // 2. What the reference's stations saw.
  std::optional<Sights> sights;
  if (use_stations && has_all_stations(*reference)) {
    const ProgressSpan span(task, 0.7, 0.8, "depth maps");
    sights.emplace(*reference, task);
  }
  // 3. Tests; 4. their points.
  const ProgressSpan span(task, 0.8, 1, "significance");
  CoreTests tests = test_cores(surfaces, cores, made.points.require("distance").values<double>(),
                               sights ? &*sights : nullptr, origin, rates, task);
  settle_together(surfaces, cores, tests, task);
  Spreader spreader(surfaces, tests, *compared, origin, made);
  const auto order = compared->octree(task)->order();
  const auto core_order = cores.tree().order();
  for_each_nearest(cores.tree(), *compared->octree(task), std::numeric_limits<double>::infinity(),
                   task, [&](const NearestBatch& batch) {
                     for (size_t j = 0; j < batch.count; ++j)
                       spreader.spread(core_order[batch.nearest[j]], order[batch.first + j]);
                   });
  spreader.attach(made.points);
  FieldTable summary = summarise(made.points.require("distance").values<double>(),
                                 made.points.require("status").values<uint8_t>(), task);
  for (const ColumnPtr& column : made.summary)
    if (summary.find(column->info().name) == nullptr) summary.set(column);
  made.summary = std::move(summary);
  add_choice(tests, sights ? reference->stations.size() : 0, rates.false_discovery, made.summary);
  if (!is_kept) made.kept = keep_cores(*reference, std::move(pair));
}

}  // namespace jalon
