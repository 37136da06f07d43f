// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/cylinder.h"

#include <algorithm>
#include <cmath>

#include "fieldtools/sort_along.h"

namespace jalon {

CylinderComparer::CylinderComparer(const M3c2Settings& settings, const CloudPtr& reference,
                                   const CloudPtr& compared, Task& task)
    : settings_(settings),
      gap_m_(settings.gap_m()),
      at_median_(settings.position == M3c2Settings::Position::kMedian),
      by_covariances_(settings.precision_from == M3c2Settings::PrecisionFrom::kCovariances),
      registration_(settings.registration()),
      reference_(epoch(reference, "reference", task)),
      compared_(epoch(compared, "compared", task)),
      detection_(settings.confidence) {}

CylinderComparer::Epoch CylinderComparer::epoch(const CloudPtr& cloud, const char* name,
                                                Task& task) const {
  Epoch out{cloud, cloud->octree(task), {}};
  if (by_covariances_) out.covariances = PointCovariances(*cloud, name);
  return out;
}

CylinderComparer::Side CylinderComparer::side(const Epoch& epoch) const {
  return {ShapeSearch(*epoch.tree),
          SurfaceFinder(gap_m_, settings_.min_points),
          {},
          {},
          {},
          {},
          {},
          {}};
}

CylinderComparer::Work CylinderComparer::work() const {
  return {side(reference_), side(compared_)};
}

// Where the points of one cloud in the cylinder lie along it, ascending.
void CylinderComparer::take_points(const Vec3& centre, const Vec3& normal, Side& side) const {
  side.points =
      side.search.cylinder(centre, normal, settings_.cylinder_radius_m, settings_.max_depth_m);
  side.along_m.resize(side.points.size());
  for (size_t i = 0; i < side.points.size(); ++i) side.along_m[i] = side.points[i].along_m;
  sort_along(side.along_m, side.work_m);
}

// The same in a crowd: what lies at one place along the cylinder is sorted as one.
void CylinderComparer::take_runs(const Vec3& centre, const Vec3& normal, Side& side) const {
  side.along_m.clear();
  side.runs.clear();
  for (const ShapeSearch::AlongRun& run : side.search.cylinder_runs(
           centre, normal, settings_.cylinder_radius_m, settings_.max_depth_m))
    if (run.count == 1) side.along_m.push_back(run.along_m);
    else side.runs.push_back(run);
  sort_along(side.along_m, side.work_m);
  if (side.runs.empty()) return;
  std::sort(side.runs.begin(), side.runs.end(),
            [](const ShapeSearch::AlongRun& a, const ShapeSearch::AlongRun& b) {
              return a.along_m < b.along_m;
            });
  side.work_m.clear();
  auto single = side.along_m.cbegin();
  for (const ShapeSearch::AlongRun& run : side.runs) {
    const auto first = single;
    while (single != side.along_m.cend() && *single < run.along_m) ++single;
    side.work_m.insert(side.work_m.end(), first, single);
    side.work_m.insert(side.work_m.end(), run.count, run.along_m);
  }
  side.work_m.insert(side.work_m.end(), single, side.along_m.cend());
  side.along_m.swap(side.work_m);
}

// The points of one cloud in the cylinder and the surfaces they lie on.
void CylinderComparer::fill(const Epoch& epoch, const Vec3& centre, const Vec3& normal,
                            Side& side) const {
  if (epoch.tree->has_crowds() && !by_covariances_) take_runs(centre, normal, side);
  else take_points(centre, normal, side);
  side.surfaces = side.finder(side.along_m);
}

SurfaceInCylinder CylinderComparer::measure(const Epoch& epoch, const Vec3& normal, Side& side,
                                            const CylinderSurface& surface) const {
  const auto along_m = std::span(side.along_m).subspan(surface.first, surface.count);
  SurfaceInCylinder out;
  out.count = static_cast<uint32_t>(surface.count);
  out.position = at_median_ ? median_(along_m) : mean_position(along_m);
  if (!by_covariances_) return out;
  side.variances.clear();
  for (const ShapeSearch::Along& point : side.points)
    if (point.along_m >= along_m.front() && point.along_m <= along_m.back())
      side.variances.add(
          epoch.covariances.variance_along(epoch.tree->order()[point.position], normal));
  out.position.variance_m2 = at_median_ ? side.variances.of_median() : side.variances.of_mean();
  out.position.dof = std::numeric_limits<double>::infinity();
  return out;
}

CylinderResult CylinderComparer::at(const Vec3& centre, const Vec3& normal, Work& work) const {
  fill(reference_, centre, normal, work.reference);
  fill(compared_, centre, normal, work.compared);
  CylinderResult result;
  result.reference.count = static_cast<uint32_t>(work.reference.along_m.size());
  result.compared.count = static_cast<uint32_t>(work.compared.along_m.size());
  if (result.reference.count == 0 || result.compared.count == 0)
    result.status = CompareStatus::kNothingNear;
  if (work.reference.surfaces.empty() || work.compared.surfaces.empty()) return result;
  const SurfacePair pair = nearest_surfaces(work.reference.along_m, work.reference.surfaces,
                                            work.compared.along_m, work.compared.surfaces);
  result.status = CompareStatus::kCompared;
  result.reference =
      measure(reference_, normal, work.reference, work.reference.surfaces[pair.reference]);
  result.compared =
      measure(compared_, normal, work.compared, work.compared.surfaces[pair.compared]);
  result.distance_m = result.compared.position.position_m - result.reference.position.position_m;
  const double registration_m2 = registration_ ? registration_->variance_along(centre, normal) : 0;
  result.lod_m = detection_.level_m(result.reference.position, result.compared.position,
                                    settings_.registration_error_m, registration_m2);
  return result;
}

}  // namespace jalon
