// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/zone_regions.h"

#include <cmath>

#include "base/numbers.h"
#include "compare/landslide/zone_measures.h"

namespace jalon {

namespace {

ChangeRegion region_of(const Comparison& comparison, const CellTable& cells, ZoneMeasure zone) {
  ChangeRegion out;
  out.label = zone.zone;
  out.area_m2 = zone.area_m2;
  out.volume_m3 = std::abs(zone.volume_m3);
  out.zone = {zone.volume_sigma_m3, zone.boundary_m, zone.open_boundary_m};
  Moments moments;
  moments.reference = comparison.cloud->point(zone.rows.front());
  double sum = 0, squares = 0;
  for (const uint32_t row : zone.rows) {
    const Vec3 p = comparison.cloud->point(row);
    moments.add(p);
    out.box.add(p);
    const double d = cells.distance[row];
    sum += d;
    squares += d * d;
    if (std::abs(d) > std::abs(out.extreme_m)) out.extreme_m = d;
  }
  const auto n = static_cast<double>(zone.rows.size());
  out.mean_m = sum / n;
  out.rms_m = std::sqrt(squares / n);
  out.centroid = moments.centroid();
  out.axes = symmetric_eigen(moments.covariance());
  out.indices = std::move(zone.rows);
  return out;
}

}  // namespace

ChangeRegions zone_regions(const Comparison& comparison) {
  const CellTable cells(comparison);
  ChangeRegions out;
  out.has_zones = true;
  out.cell_m = cells.cell_m;
  out.changed.assign(cells.size(), 0);
  out.labels.assign(cells.size(), 0);
  for (ZoneMeasure& zone : zone_measures(cells)) {
    if (zone.rows.empty()) continue;  // of a number that no cell has: from bytes of elsewhere
    zone.zone = static_cast<uint32_t>(out.regions.size() + 1);
    for (const uint32_t row : zone.rows) {
      out.changed[row] = 1;
      out.labels[row] = zone.zone;
    }
    out.regions.push_back(region_of(comparison, cells, std::move(zone)));
  }
  return out;
}

}  // namespace jalon
