// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/survey.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "modelling/plane/point_stations.h"
#include "modelling/walls/raster.h"

namespace jalon {

namespace {

constexpr size_t kPointsPerChunk = 1 << 14;
constexpr double kSigmas = 4;  // beyond this a point is not of the wall
constexpr double kNearFront_m =
    10;  // without stations: what stands this near before the wall may hide it
constexpr double kGrazing =
    0.05;  // sine of rays too flat for the wall's plane to say where they cross it

enum Seen : uint8_t { kWall = 1, kBehind = 2, kBefore = 4 };

// One wall on its way through the cloud. Marks are set by many threads: OR is the same in any order.
struct Survey {
  const SurveyedWall& wall;
  WallRaster raster;
  double tolerance_m;
  std::vector<uint8_t> seen;

  Survey(const SurveyedWall& w, const SurveySetting& setting)
      : wall(w),
        raster(rasterise_wall(*w.plane, w.holes)),
        tolerance_m(std::max(setting.min_depth_m, kSigmas * w.sigma_m)),
        seen(raster.hole.size(), 0) {}

  void mark(uint32_t cell, Seen what) {
    if (cell == kNoCell) return;
    const std::atomic_ref<uint8_t> at(seen[cell]);
    if ((at.load(std::memory_order_relaxed) & what) != what)
      at.fetch_or(what, std::memory_order_relaxed);
  }
  double height_of(const Vec3& p) const {
    return dot(p - wall.plane->frame.origin, wall.plane->frame.normal) - wall.plane->frame.height;
  }
};

// Where the ray from the eye to the point crosses the wall's plane, and on which side it ends.
void look_along_ray(Survey& survey, const Vec3& eye, const Vec3& p, double w) {
  const double height = survey.height_of(eye), fall = height - w;
  if (height <= survey.tolerance_m || std::fabs(w) <= survey.tolerance_m) return;
  if (fall < kGrazing * norm(p - eye)) return;
  const Vec3 crossing = eye + (p - eye) * (height / fall);
  survey.mark(survey.raster.cell_of(survey.wall.plane->frame.project(crossing)),
              w < 0 ? kBehind : kBefore);
}

void look_straight(Survey& survey, uint32_t cell, double w, const SurveySetting& setting) {
  if (w < -survey.tolerance_m && w >= -setting.max_depth_m) survey.mark(cell, kBehind);
  if (w > survey.tolerance_m && w <= kNearFront_m) survey.mark(cell, kBefore);
}

void look_at_point(Survey& survey, const Vec3& p, uint32_t label, const Vec3* eye,
                   const SurveySetting& setting, std::vector<HolePoint>& out) {
  const double w = survey.height_of(p);
  if (eye != nullptr) look_along_ray(survey, *eye, p, w);
  const bool is_own = label == survey.wall.plane->label;
  if (!is_own &&
      (w < -setting.max_depth_m || w > (eye != nullptr ? setting.front_m : kNearFront_m)))
    return;
  const Vec2 q = survey.wall.plane->frame.project(p);
  const uint32_t cell = survey.raster.cell_of(q);
  if (cell == kNoCell) return;
  if (is_own) survey.mark(cell, kWall);
  else if (eye == nullptr) look_straight(survey, cell, w, setting);
  const uint32_t hole = survey.raster.near_hole[cell];
  if (hole != kNoHole && w <= setting.front_m)
    out.push_back(
        {hole, label, static_cast<float>(q.u), static_cast<float>(q.v), static_cast<float>(w)});
}

WallCell cell_of(uint8_t seen) {
  if ((seen & kWall) != 0) return WallCell::kSolid;
  if ((seen & kBehind) != 0) return WallCell::kThrough;
  return (seen & kBefore) != 0 ? WallCell::kHidden : WallCell::kUnknown;
}

WallSurvey result_of(Survey&& survey, Task& task) {
  WallSurvey out;
  out.tolerance_m = survey.tolerance_m;
  out.holes.resize(survey.wall.holes.size());
  WallRaster& raster = survey.raster;
  out.map = {raster.origin, raster.cell_m, raster.columns, raster.rows, {}};
  out.map.cells.resize(survey.seen.size());
  for (size_t k = 0; k < survey.seen.size(); ++k) {
    if (k % kPointsPerChunk == 0) task.checkpoint(1);
    out.map.cells[k] = cell_of(survey.seen[k]);
    if (raster.hole[k] == kNoHole) continue;
    HoleSurvey& hole = out.holes[raster.hole[k]];
    ++hole.cells;
    hole.through += (survey.seen[k] & kBehind) != 0;
    hole.hidden += (survey.seen[k] & (kBehind | kBefore)) == kBefore;
  }
  return out;
}

}  // namespace

std::vector<WallSurvey> survey_walls(const Segmentation& segmentation,
                                     std::span<const SurveyedWall> walls,
                                     const SurveySetting& setting, Task& task) {
  std::vector<Survey> surveys;
  for (const SurveyedWall& wall : walls) {
    task.checkpoint(0);
    surveys.emplace_back(wall, setting);
  }
  const Cloud& cloud = *segmentation.cloud;
  const auto labels = segmentation.labels->values<uint32_t>();
  const size_t n = walls.empty() ? 0 : cloud.size(),
               chunks = (n + kPointsPerChunk - 1) / kPointsPerChunk;
  std::vector<std::vector<std::vector<HolePoint>>> found(chunks);
  parallel_for(task, n, kPointsPerChunk, [&](size_t begin, size_t end) {
    auto& mine = found[begin / kPointsPerChunk];
    mine.resize(surveys.size());
    PointStations stations(cloud);
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud.point(i);
      const Station* station = stations.of(i);
      Vec3 eye;
      if (station != nullptr) eye = station->pose.translation();
      for (size_t s = 0; s < surveys.size(); ++s)
        look_at_point(surveys[s], p, labels[i], station != nullptr ? &eye : nullptr, setting,
                      mine[s]);
    }
  });
  std::vector<WallSurvey> out;
  for (Survey& survey : surveys) out.push_back(result_of(std::move(survey), task));
  for (auto& chunk : found) {
    task.checkpoint(1);
    for (size_t s = 0; s < out.size(); ++s)
      for (const HolePoint& p : chunk[s]) out[s].holes[p.hole].points.push_back(p);
    chunk = {};
  }
  return out;
}

}  // namespace jalon
