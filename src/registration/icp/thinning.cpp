// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/thinning.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "cloud/spread.h"
#include "cloud/subsample_cells.h"

namespace jalon {

namespace {

// From this share of points in lines on a cloud is thinned. Scanners on tripods have at most 0.06, of the ground far
// off; single turns of 32 and 64 beams 0.2 to 1, but in rooms of a few metres.
constexpr double kMostInLines = 0.12;
// Share of the points that are marks of no return, all in one place; one of them is left.
constexpr double kMostInOnePlace = 0.01;
constexpr double kOnePlace =
    1.0 / 16;  // edge of the cubes for these, of the extent of neighbours: they thin little
// Noise of a plane, of the extent of its points: from here on it turns the plane by 6 degrees and more.
constexpr double kMostPlaneNoise = 0.4;
constexpr double kCubeNoises = 2;  // edge of cubes whose neighbours span a plane in spite of it
constexpr double kWiden = std::numbers::sqrt2;
constexpr int kMostWidenings = 7;
// Cubes of a whole scene that thinning must leave. With fewer they are as wide as the rooms are: walls that face each
// other pass for one surface.
constexpr size_t kLeastLeft = 1000;

bool is_crowded(const PointSpread& spread) {
  return spread.noise_m > kMostPlaneNoise * spread.radius_m;
}

// Wide enough for the noise: of fewer and fewer cubes, whose means have less of it.
double wide_enough_m(const Cloud& cloud, double edge_m, uint32_t k, Task& task) {
  for (int i = 0; i < kMostWidenings; ++i) {
    const Cloud cubes = one_per_voxel(cloud, edge_m, Keep::kCentroid, task);
    if (cubes.size() < kLeastLeft) break;
    const PointSpread spread = spread_of(*cubes.octree(task), k, task);
    if (!is_crowded(spread)) break;
    edge_m = std::max(kWiden * edge_m, kCubeNoises * spread.noise_m);
  }
  return edge_m;
}

ThinningCells cells_of(const Cloud& cloud, uint32_t k, Task& task) {
  const PointSpread spread = spread_of(*cloud.octree(task), k, task);
  ThinningCells out;
  out.do_widen = spread.in_lines > kMostInLines;
  if (out.do_widen) out.edge_m = spread.length_m;
  if (out.do_widen || is_crowded(spread))
    out.edge_m = wide_enough_m(cloud, std::max(out.edge_m, kCubeNoises * spread.noise_m), k, task);
  if (spread.in_one_place > kMostInOnePlace)
    out.edge_m = std::max(out.edge_m, kOnePlace * spread.length_m);
  return out;
}

// The points alone, with their index as a field that thinning carries along.
Cloud numbered(const Cloud& raw) {
  Cloud out;
  out.xyz_buffer = raw.xyz_buffer;
  out.index = raw.index;
  std::vector<uint32_t> index(raw.size());
  std::iota(index.begin(), index.end(), 0u);
  out.fields.set(make_column<uint32_t>({.name = "index"}, index));
  return out;
}

std::span<const uint32_t> indices_of(const Cloud& thinned) {
  return thinned.fields.require("index").values<uint32_t>();
}

ThinnedCloud as_thinned(const Cloud& centroids) {
  const auto kept = indices_of(centroids);
  return {std::make_shared<const Cloud>(centroids), {kept.begin(), kept.end()}};
}

// Each place by the narrowest cubes there whose neighbours are spread over a surface.
ThinnedCloud widened(Cloud cubes, double edge_m, uint32_t k, size_t raw_size, Task& task) {
  struct Kept {
    uint32_t raw;
    Vec3 place;
  };
  std::vector<Kept> kept;
  std::vector<bool> is_kept(raw_size);
  const Cloud first = cubes;
  for (int widening = 0; widening <= kMostWidenings; ++widening) {
    const auto tree = cubes.octree(task);
    const std::vector<bool> in_lines = points_in_lines(*tree, k, task);
    const auto index = indices_of(cubes);
    for (size_t position = 0; position < tree->size(); ++position) {
      const uint32_t i = tree->order()[position];
      if (in_lines[position] || is_kept[index[i]]) continue;
      is_kept[index[i]] = true;
      kept.push_back({index[i], cubes.point(i)});
    }
    edge_m *= 2;
    Cloud wider = one_per_voxel(cubes, edge_m, Keep::kCentroid, task);
    if (wider.size() < kLeastLeft) break;
    cubes = std::move(wider);
  }
  if (kept.size() < kLeastLeft) return as_thinned(first);
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.raw < b.raw; });
  ThinnedCloud out;
  Buffer<double> xyz(3 * kept.size());
  for (size_t i = 0; i < kept.size(); ++i) {
    out.index.push_back(kept[i].raw);
    for (int c = 0; c < 3; ++c) xyz[3 * i + static_cast<size_t>(c)] = kept[i].place[c];
  }
  out.cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
  return out;
}

}  // namespace

ThinningCells thinning_cells(const Cloud& reference, const Cloud& moving,
                             const IcpSettings& settings, Task& task) {
  if (settings.cell_m > 0) return {settings.cell_m, false};
  if (settings.metric == IcpMetric::kPointToPoint) return {};
  const ThinningCells a = cells_of(reference, settings.k, task),
                      b = cells_of(moving, settings.k, task);
  return {std::max(a.edge_m, b.edge_m), a.do_widen || b.do_widen};
}

ThinnedCloud thinned(const CloudPtr& raw, const ThinningCells& cells, uint32_t k, Task& task) {
  if (!(cells.edge_m > 0)) return {raw, {}};
  const Cloud cubes = one_per_voxel(numbered(*raw), cells.edge_m, Keep::kCentroid, task);
  return cells.do_widen ? widened(cubes, cells.edge_m, k, raw->size(), task) : as_thinned(cubes);
}

}  // namespace jalon
