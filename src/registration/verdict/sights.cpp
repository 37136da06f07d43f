// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/sights.h"

#include <array>
#include <cmath>
#include <vector>

#include "geometry/plane.h"
#include "registration/verdict/station_fit.h"

namespace jalon {

namespace {

constexpr size_t kSurfelCells = 4000;  // a share of 1 % of them is known to a fifth of itself
constexpr double kRangeNoises = 5;     // that a range may be off
// Share of a cloud's surfels that a believed station could not have seen. Found where the fit was right to decimetres:
// 0 to 0.057; where it was off by a metre in a corridor 0.14.
constexpr double kMostImpossible = 0.08;
// Of the logarithm of a density that 16 neighbours give: by chance alone 0.2, found at true stations 0.22 to 0.37,
// where the fit was lost 0.41 to 0.6. Less than chance have points that were thinned to a grid: nobody can tell from
// where these were seen, and the inside of a thing may pass for its outside.
constexpr double kLeastSpread = 0.18, kMostSpread = 0.39;
constexpr uint32_t kDensityPoints = 16;
constexpr size_t kDensitySample =
    40000;  // points: of denser ones neighbours are as near as their noise
// Cells along a face of the cube of directions: a station that was found is off by some decimetres.
constexpr int kFittedEdge = 64, kKnownEdge = 256;
constexpr size_t kLeastTold = 100;  // surfels of which the station's view tells anything

// The stations with a pose, each over its own points; surfels know theirs.
void use_known(const Cloud& raw, std::span<const uint32_t> thinned_index, JudgedCloud& out,
               Task& task) {
  const Vec3& origin = out.surface->tree->cube().origin;
  std::vector<int> sight_of(raw.stations.size(), -1);
  for (size_t i = 0; i < raw.stations.size(); ++i) {
    const Station& station = raw.stations[i];
    if (!station.has_pose || station.count == 0) continue;
    sight_of[i] = static_cast<int>(out.sights.size());
    const auto points = raw.xyz().subspan(3 * station.first, 3 * station.count);
    out.sights.push_back(
        SightMap::build(points, origin, station.pose.translation() - origin, kKnownEdge, task));
  }
  const auto order = out.surface->tree->order();
  for (Surfel& surfel : out.surfels) {
    const uint32_t index = order[surfel.position];
    const Station* station = station_of(raw, thinned_index.empty() ? index : thinned_index[index]);
    if (station != nullptr)
      surfel.sight = sight_of[static_cast<size_t>(station - raw.stations.data())];
  }
}

// Of the surfels that a station's view tells of, the share that it cannot have seen; 1 where it tells of too few.
double impossible_share(const SightMap& sight, const JudgedCloud& cloud) {
  const double margin_m = kRangeNoises * cloud.surface->noise_m;
  size_t told = 0, impossible = 0;
  for (const Surfel& surfel : cloud.surfels) {
    const Sighted seen = sight.look_at_own(surfel.place, surfel.normal, margin_m);
    told += seen != Sighted::kUnknown;
    impossible += seen == Sighted::kHidden;
  }
  return told < kLeastTold ? 1 : static_cast<double>(impossible) / static_cast<double>(told);
}

// By the surfels themselves where these are few points' neighbours; else by an even sample of the cloud: not by a
// thinned surface, nor by points so many that their noise is as wide as they are apart.
std::vector<DensityPlace> density_of(const Cloud& raw, const JudgedCloud& cloud, Task& task) {
  std::vector<DensityPlace> out;
  for (const Surfel& s : cloud.surfels) out.push_back({s.place, s.normal, s.radius_m});
  if (raw.size() == cloud.surface->size() && raw.size() <= kDensitySample) return out;
  const Vec3& origin = cloud.surface->tree->cube().origin;
  std::vector<double> xyz;
  Box3 box;
  for (size_t i = 0; i < raw.size(); i += raw.size() / kDensitySample + 1) {
    const Vec3 place = raw.point(i) - origin;
    for (int axis = 0; axis < 3; ++axis) xyz.push_back(place[axis]);
    box.add(place);
  }
  const auto tree = Octree::build(xyz, enclosing_cube(box), task);
  std::array<Neighbour, kDensityPoints> found;
  for (DensityPlace& at : out) {
    const size_t n = tree->knn(at.place, kDensityPoints, found);
    Moments moments;
    moments.reference = at.place;
    for (size_t k = 0; k < n; ++k) {
      const double* p = xyz.data() + 3 * size_t{found[k].index};
      moments.add({p[0], p[1], p[2]});
    }
    at.normal = symmetric_eigen(moments.covariance()).vectors[0];
    at.spacing_m = std::sqrt(found[n - 1].squared_distance);
  }
  return out;
}

void find_one(const Cloud& raw, JudgedCloud& out, Task& task) {
  const std::vector<DensityPlace> density = density_of(raw, out, task);
  for (const Spreading spreading : {Spreading::kEvenAngles, Spreading::kEvenDirections}) {
    const StationFit fit = fit_station(density, spreading, task);
    if (!(fit.spread >= kLeastSpread && fit.spread <= kMostSpread)) continue;
    SightMap sight =
        SightMap::build(raw.xyz(), out.surface->tree->cube().origin, fit.place, kFittedEdge, task);
    if (impossible_share(sight, out) > kMostImpossible) continue;
    out.sights.push_back(std::move(sight));
    break;
  }
  if (out.sights.empty()) return;
  for (Surfel& surfel : out.surfels) surfel.sight = 0;
}

}  // namespace

JudgedCloud judged_cloud(const Cloud& raw, const SurfacePlanes& surface,
                         std::span<const uint32_t> thinned_index, Task& task, bool is_of_lines) {
  JudgedCloud out{&surface, sample_surface(surface, kSurfelCells, task), {}};
  use_known(raw, thinned_index, out, task);
  out.are_told = !out.sights.empty();
  if (!out.are_told && !is_of_lines) find_one(raw, out, task);
  return out;
}

}  // namespace jalon
