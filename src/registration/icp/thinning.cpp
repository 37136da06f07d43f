// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/thinning.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "cloud/subsample_cells.h"
#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr size_t kSample =
    1000;  // neighbourhoods looked at: a median of so many is sure to a few per cent
// Sides of the neighbourhoods, the shorter over the longer: of points spread evenly about 0.75, of a grid that is three
// times as dense one way 0.4, of a line the noise.
constexpr double kLeastSides = 0.25;
constexpr double kWiden = std::numbers::sqrt2;
constexpr int kMostWidenings = 12;
constexpr size_t kLeastLeft = 1000;  // points that thinning must leave

struct Neighbourhoods {
  double sides = 1;     ///< median ratio of the middle extent to the largest
  double length_m = 0;  ///< median of the largest
};

Neighbourhoods neighbourhoods_of(const Cloud& cloud, uint32_t k, Task& task) {
  const auto tree = cloud.octree(task);
  std::vector<double> sides, lengths;
  std::vector<Neighbour> found(k);
  for (size_t i = 0; i < cloud.size(); i += cloud.size() / kSample + 1) {
    const Vec3 at = cloud.point(i);
    const size_t n = tree->knn(at, k, found);
    Moments moments;
    moments.reference = at;
    for (size_t j = 0; j < n; ++j) moments.add(cloud.point(found[j].index));
    const Eigen3 e = symmetric_eigen(moments.covariance());
    if (!(e.values[2] > 0)) continue;
    sides.push_back(std::sqrt(std::max(0.0, e.values[1]) / e.values[2]));
    lengths.push_back(std::sqrt(e.values[2]));
  }
  if (sides.empty()) return {};
  const auto median = [](std::vector<double>& v) {
    const auto middle = v.begin() + static_cast<ptrdiff_t>(v.size() / 2);
    std::nth_element(v.begin(), middle, v.end());
    return *middle;
  };
  return {median(sides), median(lengths)};
}

double cell_of(const Cloud& cloud, uint32_t k, Task& task) {
  const Neighbourhoods all = neighbourhoods_of(cloud, k, task);
  if (all.sides >= kLeastSides) return 0;
  double cell_m = all.length_m;
  for (int i = 0; i < kMostWidenings; ++i, cell_m *= kWiden) {
    const Cloud thinned = one_per_voxel(cloud, cell_m, Keep::kCentroid, task);
    if (thinned.size() < kLeastLeft) return cell_m / kWiden;
    if (neighbourhoods_of(thinned, k, task).sides >= kLeastSides) return cell_m;
  }
  return cell_m;
}

}  // namespace

double thinning_cell_m(const Cloud& reference, const Cloud& moving, const IcpSettings& settings,
                       Task& task) {
  if (settings.cell_m > 0) return settings.cell_m;
  if (settings.metric == IcpMetric::kPointToPoint) return 0;
  return std::max(cell_of(reference, settings.k, task), cell_of(moving, settings.k, task));
}

ThinnedCloud thinned(const CloudPtr& raw, double cell_m, Task& task) {
  if (!(cell_m > 0)) return {raw, {}};
  // The points alone, with their index as a field that thinning carries along.
  Cloud numbered;
  numbered.xyz_buffer = raw->xyz_buffer;
  numbered.index = raw->index;
  std::vector<uint32_t> index(raw->size());
  std::iota(index.begin(), index.end(), 0u);
  numbered.fields.set(make_column<uint32_t>({.name = "index"}, index));
  const Cloud centroids = one_per_voxel(numbered, cell_m, Keep::kCentroid, task);
  const auto kept = centroids.fields.require("index").values<uint32_t>();
  ThinnedCloud out;
  out.index.assign(kept.begin(), kept.end());
  out.cloud = std::make_shared<const Cloud>(centroids);
  return out;
}

}  // namespace jalon
