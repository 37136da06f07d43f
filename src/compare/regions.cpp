// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "base/table_columns.h"
#include "cloud/select.h"
#include "cloud/statistics.h"
#include "compare/changed_points.h"
#include "spatial/components.h"

namespace jalon {

namespace {

constexpr ParamRow kRows[] = {
    choice_row("criterion", "automatic", "automatic|threshold|significance|field", "",
               "Which points are changed: beyond threshold_m, beyond their level of detection, or those whose field is "
               "not 0; automatic: by the level of detection where there is one, else by the threshold"),
    number_row("threshold_m", 0.05, 0, 1e9, "m", "", "Distance (of either sign) above which a point is changed"),
    number_row("spacing_share", 0.6, 0, 100, "1", "",
               "For the threshold: how much of the column reference_spacing, where there is one, is added to it: half, "
               "the way from a row of points to the middle between two, and a fifth more"),
    string_row("field", "changed", "", "Name of the field for criterion field: of the comparison or of its cloud"),
    number_row("cell_m", 0, 0, 1e6, "m", "",
               "Edge length of the grid cells that connect changed points; 0 = from their density"),
    choice_row("connectivity", "26", "6|18|26", "",
               "Neighbours of a cell: those that share a face (6), also an edge (18), also a corner (26)"),
    integer_row("min_points", 10, 1, 1e15, "points", "", "Regions of fewer points are dropped"),
};

// Neighbours whose distance tells the density: with 8, scan lines four times as far apart as their points give half as
// much again; with 16 they give the area within 4 %.
constexpr uint32_t kDensityNeighbours = 16;
// Neighbours all on one side mark a border, where half the disc is empty: their centroid lies 4 / (3 pi) radii away.
// Below a quarter of the radius it is chance.
constexpr double kBorderOffset = 4 / (3 * std::numbers::pi);
constexpr double kChanceOffset = 0.25;
// Cells of two to four times the radius of a point's disc connect what one surface holds (A19); where a scanner looked
// along a surface its points are farther apart in one direction, so the upper end and the sparser points count.
constexpr double kCellFactor = 4;
constexpr double kCellQuantile = 0.9;

double quantile(std::vector<float> values, double q) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return static_cast<double>(*at);
}

Connectivity3 connectivity_of(const std::string& text) {
  return text == "6" ? Connectivity3::k6 : text == "18" ? Connectivity3::k18 : Connectivity3::k26;
}

// Step 2: labels of the changed points among themselves.
std::vector<uint32_t> connect(const Cloud& part, const ParamSet& options, Regions& out, Task& task) {
  const Connectivity3 connectivity = connectivity_of(options.text("connectivity"));
  const auto min_points = static_cast<uint64_t>(options.integer("min_points"));
  const Components found =
      connected_components(part.xyz(), local_origin(part, task), out.cell_m, connectivity, min_points, task);
  out.regions.resize(found.count());
  return found.labels;
}

// Step 3: sums over the points of one region, relative to an origin beside it.
void measure(Region& region, const Comparison& comparison, const std::vector<float>& radii,
             const std::vector<uint32_t>& row_in_part) {
  const auto distance = comparison.points.require("distance").values<double>();
  Moments moments;
  moments.reference = comparison.cloud->point(region.indices.front());
  double sum = 0, squares = 0;
  uint64_t n = 0;
  for (const uint32_t i : region.indices) {
    const Vec3 p = comparison.cloud->point(i);
    moments.add(p);
    region.box.add(p);
    const double r = static_cast<double>(radii[row_in_part[i]]);
    region.area_m2 += std::numbers::pi * r * r;
    const double d = distance[i];
    if (!std::isfinite(d)) continue;
    sum += d;
    squares += d * d;
    ++n;
    if (std::abs(d) > std::abs(region.extreme_m)) region.extreme_m = d;
  }
  region.centroid = moments.centroid();
  region.axes = symmetric_eigen(moments.covariance());
  region.mean_m = n > 0 ? sum / static_cast<double>(n) : std::nan("");
  region.rms_m = n > 0 ? std::sqrt(squares / static_cast<double>(n)) : std::nan("");
}

}  // namespace

std::span<const ParamRow> regions_rows() { return kRows; }

// Radius of the disc of a point from its k nearest others, nearest first.
static double disc_radius(const Cloud& cloud, const Vec3& p, std::span<const Neighbour> others) {
  const double farthest = others.back().squared_distance;
  Vec3 offset;
  for (const Neighbour& other : others) offset += cloud.point(other.index) - p;
  const auto k = static_cast<double>(others.size());
  const double share = farthest > 0 ? norm(offset) / (k * std::sqrt(farthest)) : 0;
  const double beside = std::clamp((share - kChanceOffset) / (kBorderOffset - kChanceOffset), 0.0, 1.0);
  return std::sqrt(farthest / k * (1 - 0.5 * beside));  // pi d^2 / k = 1 / density in the mean, on a plane
}

std::vector<float> point_radii(const Cloud& cloud, std::span<const uint64_t> rows, Task& task) {
  std::vector<float> radii(rows.size(), 0);
  if (cloud.size() < 2) return radii;
  const auto tree = cloud.octree(task);
  const uint32_t k = static_cast<uint32_t>(std::min<size_t>(kDensityNeighbours, cloud.size() - 1));
  parallel_for(task, rows.size(), 1 << 10, [&](size_t begin, size_t end) {
    std::array<Neighbour, kDensityNeighbours + 1> found;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud.point(rows[i]);
      tree->knn(p, k + 1, found);
      radii[i] = static_cast<float>(disc_radius(cloud, p, {found.data() + 1, k}));
    }
  });
  return radii;
}

Regions change_regions(const Comparison& comparison, const ParamSet& options, Task& task) {
  Regions out;
  out.changed = changed_points(comparison, options, task);
  out.labels.assign(comparison.cloud->size(), 0);
  const std::vector<uint64_t> rows = indices_of(out.changed, 1, task);
  if (rows.empty()) return out;
  const Cloud part = select_unchecked(*comparison.cloud, rows, task);
  const std::vector<float> radii = point_radii(*comparison.cloud, rows, task);
  out.spacing_m = quantile(radii, 0.5);
  out.cell_m = options.number("cell_m");
  if (!(out.cell_m > 0)) out.cell_m = std::max(kCellFactor * quantile(radii, kCellQuantile), 1e-6);
  const std::vector<uint32_t> labels = connect(part, options, out, task);
  std::vector<uint32_t> row_in_part(comparison.cloud->size(), 0);
  for (size_t i = 0; i < rows.size(); ++i) {
    row_in_part[rows[i]] = static_cast<uint32_t>(i);
    out.labels[rows[i]] = labels[i];
    if (labels[i] > 0) out.regions[labels[i] - 1].indices.push_back(static_cast<uint32_t>(rows[i]));
  }
  parallel_for(task, out.regions.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      out.regions[i].label = static_cast<uint32_t>(i + 1);
      measure(out.regions[i], comparison, radii, row_in_part);
    }
  });
  return out;
}

FieldTable region_points_table(const Regions& regions) {
  FieldTable table;
  table.set(make_column<uint8_t>({"changed", ElementType::kUint8, 1, "", "1 = changed"}, regions.changed));
  table.set(make_column<uint32_t>({"region", ElementType::kUint32, 1, "", "change region, 1 = most points, 0 = none"},
                                  regions.labels));
  return table;
}

FieldTable regions_table(const Regions& found) {
  FieldTable table;
  const auto& rows = found.regions;
  add_column<uint32_t>(table, rows, "region", "", "label", [](const Region& r) { return r.label; });
  add_column<uint64_t>(table, rows, "points", "", "", [](const Region& r) { return r.indices.size(); });
  add_column<double>(table, rows, "area", "m2", "of the sampled surface", [](const Region& r) { return r.area_m2; });
  add_column<double>(table, rows, "mean", "m", "mean distance", [](const Region& r) { return r.mean_m; });
  add_column<double>(table, rows, "rms", "m", "root mean square distance", [](const Region& r) { return r.rms_m; });
  add_column<double>(table, rows, "extreme", "m", "largest distance, with its sign",
                     [](const Region& r) { return r.extreme_m; });
  const auto vec = [&](const char* name, const char* meaning, auto&& of) {
    add_columns<double, 3>(table, rows, name, "m", meaning, [&](const Region& r, double* out) {
      const Vec3 v = of(r);
      for (int k = 0; k < 3; ++k) out[k] = v[k];
    });
  };
  vec("centroid", "mean of its points", [](const Region& r) { return r.centroid; });
  vec("box_min", "lowest corner", [](const Region& r) { return r.box.min; });
  vec("box_max", "highest corner", [](const Region& r) { return r.box.max; });
  return table;
}

}  // namespace jalon
