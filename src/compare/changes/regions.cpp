// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/table_columns.h"
#include "cloud/select.h"
#include "cloud/statistics.h"
#include "compare/changes/changed_points.h"
#include "compare/changes/measured_steps.h"
#include "compare/changes/point_discs.h"
#include "compare/changes/zone_regions.h"
#include "compare/landslide/cell_table.h"

namespace jalon {

namespace {

using S = RegionSettings;

constexpr auto kRows = setting_rows(
    choice_row<&S::criterion>(
        "criterion", "automatic|threshold|significance|field", "",
        "Which points are changed: beyond threshold_m, beyond their level of detection, or those "
        "whose field is not 0; automatic: by the level of detection where there is one, else by "
        "the threshold"),
    number_row<&S::threshold_m>("threshold_m", 0, 1e9, "m", "",
                                "Distance (of either sign) above which a point is changed"),
    number_row<&S::spacing_share>(
        "spacing_share", 0, 100, "1", "",
        "For the threshold: how much of the column reference_spacing, where there is one, is "
        "added to it: half, the way from a row of points to the middle between two, and a fifth "
        "more"),
    string_row<&S::field>(
        "field", "", "Name of the field for criterion field: of the comparison or of its cloud"),
    number_row<&S::cell_m>(
        "cell_m", 0, 1e6, "m", "",
        "Edge length of the grid cells that connect changed points; 0 = from their density"),
    choice_row<&S::connectivity>(
        "connectivity", "6|18|26", "",
        "Neighbours of a cell: those that share a face (6), also an edge (18), also a corner "
        "(26)"),
    integer_row<&S::min_points>("min_points", 1, 1e15, "points", "",
                                "Regions of fewer points are dropped"),
    number_row<&S::twin_reach>(
        "twin_reach", 0, 1e6, "1", "",
        "Of the diagnosis of comparisons with detection: how far a thing may have gone to be found "
        "again elsewhere, in its own sizes"));

// Step 2: labels of the changed points among themselves.
std::vector<uint32_t> connect(const Cloud& part, const RegionSettings& settings, ChangeRegions& out,
                              Task& task) {
  const Components found = connected_components(part.xyz(), local_origin(part, task), out.cell_m,
                                                settings.connectivity, settings.min_points, task);
  out.regions.resize(found.count());
  return found.labels;
}

// Step 3: sums over the points of one region, relative to an origin beside it.
void measure(ChangeRegion& region, const Comparison& comparison,
             const std::vector<PointDisc>& discs, const std::vector<uint32_t>& row_in_part) {
  const auto distance = comparison.points.require("distance").values<double>();
  Moments moments;
  moments.reference = comparison.cloud->point(region.indices.front());
  double sum = 0, squares = 0;
  uint64_t n = 0;
  for (const uint32_t i : region.indices) {
    const Vec3 p = comparison.cloud->point(i);
    moments.add(p);
    region.box.add(p);
    region.area_m2 += discs[row_in_part[i]].area_m2();
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

// Step 4: what lies between the region and the other epoch, a prism a point: its disc, seen along its distance.
void measure_volume(ChangeRegion& region, const MeasuredSteps& steps,
                    const std::vector<PointDisc>& discs, const std::vector<uint32_t>& row_in_part) {
  for (const uint32_t i : region.indices) {
    const PointDisc& disc = discs[row_in_part[i]];
    const Vec3 step = steps.of(i, region.axes.vectors[0]);
    if (std::isfinite(step.x))
      region.volume_m3 += disc.area_m2() * std::abs(dot(disc.normal(), step));
  }
}

}  // namespace

std::span<const ParamRow> regions_rows() { return kRows; }

ChangeRegions change_regions(const Comparison& comparison, const RegionSettings& settings,
                             Task& task, const Cloud* reference) {
  using Criterion = RegionSettings::Criterion;
  const bool by_level =
      settings.criterion == Criterion::kAutomatic || settings.criterion == Criterion::kSignificance;
  if (by_level && is_landslide(comparison)) return zone_regions(comparison);
  ChangeRegions out;
  out.changed = changed_points(comparison, settings, task);
  out.labels.assign(comparison.cloud->size(), 0);
  const std::vector<uint64_t> rows = indices_of(out.changed, 1, task);
  if (rows.empty()) return out;
  const Cloud part = select_unchecked(*comparison.cloud, rows, task);
  const std::vector<PointDisc> discs = point_discs(*comparison.cloud, rows, task);
  out.spacing_m = radius_quantile(discs, 0.5);
  out.cell_m = settings.cell_m;
  if (!(out.cell_m > 0)) out.cell_m = joining_distance(discs);
  const std::vector<uint32_t> labels = connect(part, settings, out, task);
  std::vector<uint32_t> row_in_part(comparison.cloud->size(), 0);
  for (size_t i = 0; i < rows.size(); ++i) {
    row_in_part[rows[i]] = static_cast<uint32_t>(i);
    out.labels[rows[i]] = labels[i];
    if (labels[i] > 0) out.regions[labels[i] - 1].indices.push_back(static_cast<uint32_t>(rows[i]));
  }
  const MeasuredSteps steps(comparison, reference);
  parallel_for(task, out.regions.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      out.regions[i].label = static_cast<uint32_t>(i + 1);
      measure(out.regions[i], comparison, discs, row_in_part);
      measure_volume(out.regions[i], steps, discs, row_in_part);
    }
  });
  return out;
}

FieldTable region_points_table(const ChangeRegions& regions) {
  FieldTable table;
  table.set(make_column<uint8_t>({"changed", ElementType::kUint8, 1, "", "1 = changed"},
                                 regions.changed));
  table.set(make_column<uint32_t>(
      {"region", ElementType::kUint32, 1, "", "change region, 1 = most points, 0 = none"},
      regions.labels));
  return table;
}

FieldTable regions_table(const ChangeRegions& found) {
  FieldTable table;
  const auto& rows = found.regions;
  add_column<uint32_t>(table, rows, "region", "", "label",
                       [](const ChangeRegion& r) { return r.label; });
  add_column<uint64_t>(table, rows, "points", "", "",
                       [](const ChangeRegion& r) { return r.indices.size(); });
  add_column<double>(table, rows, "area", "m2", "of the sampled surface",
                     [](const ChangeRegion& r) { return r.area_m2; });
  add_column<double>(table, rows, "volume", "m3", "between it and the other epoch",
                     [](const ChangeRegion& r) { return r.volume_m3; });
  add_column<double>(table, rows, "mean", "m", "mean distance",
                     [](const ChangeRegion& r) { return r.mean_m; });
  add_column<double>(table, rows, "rms", "m", "root mean square distance",
                     [](const ChangeRegion& r) { return r.rms_m; });
  add_column<double>(table, rows, "extreme", "m", "largest distance, with its sign",
                     [](const ChangeRegion& r) { return r.extreme_m; });
  const auto vec = [&](const char* name, const char* meaning, auto&& of) {
    add_columns<double, 3>(table, rows, name, "m", meaning,
                           [&](const ChangeRegion& r, double* out) {
                             const Vec3 v = of(r);
                             for (int k = 0; k < 3; ++k) out[k] = v[k];
                           });
  };
  vec("centroid", "mean of its points", [](const ChangeRegion& r) { return r.centroid; });
  vec("box_min", "lowest corner", [](const ChangeRegion& r) { return r.box.min; });
  vec("box_max", "highest corner", [](const ChangeRegion& r) { return r.box.max; });
  if (!found.has_zones) return table;
  add_column<double>(table, rows, "volume_sigma", "m3", "standard deviation of the volume",
                     [](const ChangeRegion& r) { return r.zone.volume_sigma_m3; });
  add_column<double>(table, rows, "boundary", "m", "length of its outline",
                     [](const ChangeRegion& r) { return r.zone.boundary_m; });
  add_column<double>(table, rows, "open_boundary", "m",
                     "of that, along ground that was not measured",
                     [](const ChangeRegion& r) { return r.zone.open_boundary_m; });
  return table;
}

}  // namespace jalon
