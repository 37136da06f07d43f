// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "geometry/rigid_motion.h"
#include "scan/misfit.h"
#include "scan/pulse.h"
#include "scan/returns.h"
#include "scan/scan_output.h"
#include "scan/scanner.h"
#include "scan/static_settings.h"
#include "spatial/triangles/tree.h"

namespace jalon {

namespace {

/// The columns that only this scanner has.
struct Output : ScanOutput {
  Output(size_t n, bool with_incidence) : ScanOutput(n) {
    const auto column = [&](const char* name, const char* unit, const char* meaning) {
      return std::make_shared<Column>(FieldInfo{name, ElementType::kFloat32, 1, unit, meaning}, n);
    };
    range = column("range", "m", "distance from the scanner, without noise");
    if (with_incidence)
      incidence = column("incidence_angle", "rad", "between the ray and the face's normal");
  }
  std::shared_ptr<Column> range, incidence;
};

class Scan {
 public:
  Scan(const Surfaces& surfaces, const StaticSettings& settings, const RayGrid& grid,
       const Vec3& offset, const TriangleTree& tree, Task& task)
      : surfaces_(surfaces),
        settings_(settings),
        offset_(offset),
        tree_(tree),
        streams_(settings.seed),
        directions_(settings, grid, task),
        pulses_(settings, tree, surfaces) {}

  Returns cast(const Transform& pose, size_t station, Task& task) const {
    if (tree_.size() == 0) return {};
    const uint64_t rays = directions_.grid().rays();
    Returns returns((rays + kRayGrain - 1) / kRayGrain);
    parallel_for(task, rays, kRayGrain, [&](size_t begin, size_t end) {
      std::vector<Return> found;
      for (uint64_t ray = begin; ray < end; ++ray) cast_one(pose, station, ray, begin, found);
      found.shrink_to_fit();
      returns[begin / kRayGrain] = std::move(found);
    });
    return returns;
  }

  void record(const Transform& pose, size_t station, const Returns& returns, size_t first,
              Output& out, Task& task) const {
    const Misfit misfit(settings_, station);
    std::vector<size_t> start(returns.size());
    for (size_t c = 0; c < returns.size(); ++c) {
      start[c] = first;
      first += returns[c].size();
    }
    parallel_chunks(task, returns.size(), [&](size_t c) {
      for (size_t k = 0; k < returns[c].size(); ++k)
        record_one(pose, misfit, station, c * kRayGrain, returns[c][k], start[c] + k, out);
    });
  }

 private:
  /// A unit vector whatever the last digits of the pose, so that t along it is the range.
  Vec3 direction_of(const Transform& pose, uint64_t ray) const {
    return normalized(pose.direction(directions_.of(ray)));
  }

  void cast_one(const Transform& pose, size_t station, uint64_t ray, uint64_t first,
                std::vector<Return>& found) const {
    const Vec3 direction = direction_of(pose, ray);
    Echo echo;
    // Range limits apply to what is first met: a surface too near shadows those behind it.
    if (!pulses_.send(pose.translation(), direction, streams_.panes(station, ray), echo)) return;
    if (!(echo.range >= settings_.min_range_m && echo.range <= settings_.max_range_m)) return;
    RandomStream random = streams_.decisions(station, ray);
    if (random.uniform() < settings_.dropout) return;
    uint32_t mark = random.uniform() < settings_.outliers ? kOutlierBit : 0;
    if (echo.is_mixed) mark |= kMixedBit;
    if (settings_.spacing_m > 0 &&
        streams_.thinning(station, ray).uniform() >= kept_share(echo, direction, ray))
      return;
    found.push_back({echo.range, echo.triangle, static_cast<uint32_t>(ray - first) | mark});
  }

  /// Area on the surface that the ray stands for, in squares of the spacing.
  double kept_share(const Echo& echo, const Vec3& direction, uint64_t ray) const {
    const double across =
        directions_.of_horizon(ray) * settings_.horizontal_step_rad * settings_.vertical_step_rad;
    return echo.range * echo.range * across /
           (settings_.spacing_m * settings_.spacing_m * surfaces_.cosine(echo.triangle, direction));
  }

  void record_one(const Transform& pose, const Misfit& misfit, size_t station, uint64_t first_ray,
                  const Return& r, size_t i, Output& out) const {
    const uint64_t ray = first_ray + (r.ray & kRayMask);
    const bool is_outlier = (r.ray & kOutlierBit) != 0, is_mixed = (r.ray & kMixedBit) != 0;
    const Vec3 origin = tree_.origin(), from = pose.translation() - origin;
    const Vec3 direction = direction_of(pose, ray);
    RandomStream random = streams_.noise(station, ray);
    Vec3 exact, measured;  // relative to the tree's origin
    if (is_outlier) {
      exact = outlier(random, from, direction, r.range);
      measured = misfit.is_none() ? exact : misfit.recorded(from, exact - from);
    } else {
      exact = from + direction * r.range;
      measured = misfit.recorded(from, disturbed(random, pose, ray, direction, r.range));
    }
    const double range = is_outlier ? norm(exact - from) : r.range;
    out.set_point(i, stepped(measured, settings_.coordinate_step_m) + origin + offset_,
                  exact + origin + offset_, is_outlier ? kNoFace : surfaces_.face(r.triangle),
                  is_outlier || is_mixed ? kNoSegment : surfaces_.segment(r.triangle));
    out.range->values<float>()[i] = static_cast<float>(range);
    if (out.incidence)
      out.incidence->values<float>()[i] =
          is_outlier ? kFloatNaN
                     : static_cast<float>(std::acos(surfaces_.cosine(r.triangle, direction)));
  }

  /// Measured point as seen from the scanner: errors of the range, then of the two angles, then of the point itself.
  /// The field "range" stays the true one.
  Vec3 disturbed(RandomStream& random, const Transform& pose, uint64_t ray, const Vec3& direction,
                 double true_range) const {
    const StaticSettings& s = settings_;
    const double range_noise = s.range_noise_m + s.range_noise_ppm * 1e-6 * true_range;
    const double range = range_noise > 0 ? true_range + range_noise * random.normal() : true_range;
    Vec3 seen = direction;
    if (s.angle_noise_rad > 0 || s.vertical_noise_rad > 0) {
      const double error_h = s.angle_noise_rad * random.normal();
      const double error_v = s.vertical_noise_rad * random.normal();
      seen = normalized(pose.direction(directions_.of(ray, error_h, error_v)));
    }
    Vec3 p = seen * range;
    if (s.point_noise_m > 0)
      for (int a = 0; a < 3; ++a) p[a] += s.point_noise_m * random.normal();
    return p;
  }

  /// Along the ray in front of the surface (dust, mixed returns), or anywhere in the model's box.
  Vec3 outlier(RandomStream& random, const Vec3& from, const Vec3& direction, double range) const {
    if (settings_.outlier_place == StaticSettings::OutlierPlace::kRay)
      return from + direction * (settings_.min_range_m +
                                 (range - settings_.min_range_m) * random.uniform());
    const Box3& box = tree_.local_bounds();
    Vec3 p;
    for (int a = 0; a < 3; ++a) p[a] = box.min[a] + (box.max[a] - box.min[a]) * random.uniform();
    return p;
  }

  const Surfaces& surfaces_;
  const StaticSettings& settings_;
  Vec3 offset_;
  const TriangleTree& tree_;
  RayStreams streams_;
  Directions directions_;
  PulseCaster pulses_;
};

std::vector<Returns> cast_all(const Scan& scan, std::span<const ScanStation> stations, Task& task) {
  std::vector<Returns> returns;
  const double n = static_cast<double>(stations.size());
  for (size_t s = 0; s < stations.size(); ++s) {
    const double part = static_cast<double>(s);
    const ProgressSpan span(task, part / n, (part + 1) / n);
    returns.push_back(scan.cast(stations[s].pose, s, task));
  }
  return returns;
}

/// Points and fields, station by station; the returns are used up.
Cloud record_all(const Scan& scan, const StaticSettings& settings, const Vec3& offset,
                 std::span<const ScanStation> stations, std::vector<Returns>& returns, Task& task) {
  std::vector<size_t> first(stations.size() + 1, 0);
  for (size_t s = 0; s < stations.size(); ++s) {
    first[s + 1] = first[s];
    for (const auto& chunk : returns[s]) first[s + 1] += chunk.size();
  }
  Output out(first.back(), settings.incidence_angle);
  const double n = static_cast<double>(stations.size());
  for (size_t s = 0; s < stations.size(); ++s) {
    const double part = static_cast<double>(s);
    const ProgressSpan span(task, part / n, (part + 1) / n);
    scan.record(stations[s].pose, s, returns[s], first[s], out, task);
    returns[s] = {};
  }
  Cloud cloud = out.take();
  cloud.fields.set(out.range);
  if (out.incidence) cloud.fields.set(out.incidence);
  for (size_t s = 0; s < stations.size(); ++s) {
    Station station{stations[s].name, true, Misfit(settings, s).recorded(stations[s].pose),
                    first[s], first[s + 1] - first[s]};
    if (station.name.empty()) station.name = "station " + std::to_string(s + 1);
    for (int a = 0; a < 3; ++a) station.pose.m[static_cast<size_t>(4 * a + 3)] += offset[a];
    cloud.stations.push_back(station);
  }
  return cloud;
}

}  // namespace

Cloud scan_static(const Model& model, std::span<const ScanStation> stations,
                  const StaticSettings& asked, Task& task) {
  // 1. What to do, and from where.
  const RayGrid grid = ray_grid(asked);
  const StaticSettings settings = resolved(asked);
  const Vec3 offset = offset_of(settings.offset_m);
  validate(model);
  std::vector<ScanStation> automatic;
  if (stations.empty()) {
    automatic = automatic_stations(model, settings.stations, settings.station_distance_m);
    stations = automatic;
  }
  if (stations.size() > kMaxStations) fail(Status::kLimit, "more than 2^26 stations");
  for (const ScanStation& station : stations) require_rigid(station.pose, "a station's pose");

  // 2. The surfaces, and the tree of their triangles.
  std::shared_ptr<const TriangleTree> tree;
  std::optional<Surfaces> surfaces;
  {
    const ProgressSpan span(task, 0, 0.05, "finding the true planes");
    surfaces.emplace(model, settings.surfaces, settings.seed, task);
  }
  {
    const ProgressSpan span(task, 0.05, 0.1, "indexing the model");
    tree = TriangleTree::build(model.vertices, model.triangles, task);
  }
  const Scan scan(*surfaces, settings, grid, offset, *tree, task);

  // 3. All rays: what they meet, without noise; and which of it is kept.
  std::vector<Returns> returns;
  {
    const ProgressSpan span(task, 0.1, 0.8, "scanning");
    returns = cast_all(scan, stations, task);
  }
  {
    const ProgressSpan span(task, 0.8, 0.82, "thinning");
    thin(returns, settings.max_points, RayStreams(settings.seed), task);
  }

  // 4. Points with noise and truth.
  const ProgressSpan span(task, 0.82, 1, "recording points");
  return record_all(scan, settings, offset, stations, returns, task);
}

}  // namespace jalon
