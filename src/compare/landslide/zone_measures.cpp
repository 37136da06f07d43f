// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/zone_measures.h"

#include <algorithm>
#include <cmath>

#include "base/table_columns.h"

namespace jalon {

namespace {

constexpr int kAroundCell[8][2] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0},
                                   {1, 0},   {-1, 1}, {0, 1},  {1, 1}};
constexpr int kAcrossEdges[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};

// Whose volume each cell is part of; 0: nobody's.
std::vector<uint32_t> owners_of(const CellTable& cells) {
  std::vector<uint32_t> out(cells.zone.begin(), cells.zone.end());
  for (size_t i = 0; i < cells.size(); ++i) {
    if (cells.zone[i] != 0 || !cells.is_measured(i)) continue;
    for (const auto& [columns, rows] : kAroundCell) {
      const size_t other = cells.beside(i, columns, rows);
      if (other == CellTable::kNone || cells.zone[other] == 0) continue;
      out[i] = out[i] == 0 ? cells.zone[other] : std::min(out[i], cells.zone[other]);
    }
  }
  return out;
}

void measure_boundary(const CellTable& cells, ZoneMeasure& zone) {
  for (const uint32_t i : zone.rows)
    for (const auto& [columns, rows] : kAcrossEdges) {
      const size_t other = cells.beside(i, columns, rows);
      if (other != CellTable::kNone && cells.zone[other] == zone.zone) continue;
      zone.boundary_m += cells.cell_m;
      if (other == CellTable::kNone || !cells.is_measured(other))
        zone.open_boundary_m += cells.cell_m;
    }
}

/// What the cells of a volume are worth together. At the border of ground that was not measured what a cell hides lies
/// to the same side as in the next one: such errors add up, those of the others by their squares.
struct VolumeError {
  double variance = 0, border = 0, area = 0;

  void add(const CellTable& cells, size_t row) {
    const double a = cells.cell_area_m2(), own = a * cells.sigma[row];
    area += a;
    for (const auto& [columns, rows] : kAroundCell) {
      const size_t other = cells.beside(row, columns, rows);
      if (other != CellTable::kNone && cells.is_measured(other)) continue;
      border += own;
      return;
    }
    variance += own * own;
  }
  double sigma(double systematic_m) const {
    const double shared = area * systematic_m;
    return std::sqrt(variance + border * border + shared * shared);
  }
};

/// Zones of either sign or of all.
struct ZoneTotal {
  double volume = 0, area = 0, boundary = 0, open = 0;
  VolumeError error;
};

// Cells not measured that hang together with one beside a zone.
double unmeasured_beside(const CellTable& cells) {
  std::vector<uint8_t> is_listed(cells.size(), 0);
  std::vector<size_t> open;
  const auto list = [&](size_t i) {
    for (const auto& [columns, rows] : kAroundCell) {
      const size_t other = cells.beside(i, columns, rows);
      if (other == CellTable::kNone || cells.is_measured(other) || is_listed[other] != 0) continue;
      is_listed[other] = 1;
      open.push_back(other);
    }
  };
  for (size_t i = 0; i < cells.size(); ++i)
    if (cells.zone[i] != 0) list(i);
  double count = 0;
  while (!open.empty()) {
    const size_t i = open.back();
    open.pop_back();
    count += 1;
    list(i);
  }
  return count * cells.cell_area_m2();
}

void add_unmeasured(FieldTable& summary, const CellTable& cells) {
  uint64_t only_reference = 0, only_compared = 0, both = 0, hidden = 0, measured = 0;
  constexpr uint8_t kHidden = static_cast<uint8_t>(CompareStatus::kHidden);
  for (size_t i = 0; i < cells.size(); ++i) {
    const bool before = cells.reference_status[i] == 0, after = cells.compared_status[i] == 0;
    measured += before && after ? 1 : 0;
    only_reference += !before && after ? 1 : 0;
    only_compared += before && !after ? 1 : 0;
    both += !before && !after ? 1 : 0;
    hidden += cells.reference_status[i] == kHidden || cells.compared_status[i] == kHidden ? 1 : 0;
  }
  const double a = cells.cell_area_m2();
  const auto area = [&](const char* name, const char* meaning, uint64_t count) {
    add_value<double>(summary, name, "m2", meaning, a * static_cast<double>(count));
  };
  area("measured_area", "cells that both epochs have measured", measured);
  area("unmeasured_reference", "not measured in the reference alone", only_reference);
  area("unmeasured_compared", "not measured in the compared epoch alone", only_compared);
  area("unmeasured_both", "not measured in either epoch", both);
  area("unmeasured_hidden", "of those what stood in a shadow in at least one epoch", hidden);
  add_value<double>(summary, "unmeasured_beside_zones", "m2",
                    "of those what hangs together with the border of a zone: the zone may go on "
                    "there, and no volume holds it",
                    unmeasured_beside(cells));
  add_value<double>(
      summary, "unmeasured_share", "1", "of the whole area",
      static_cast<double>(cells.size() - measured) / static_cast<double>(cells.size()));
}

}  // namespace

std::vector<ZoneMeasure> zone_measures(const CellTable& cells) {
  uint32_t count = 0;
  for (const uint32_t label : cells.zone) count = std::max(count, label);
  std::vector<ZoneMeasure> out(count);
  const std::vector<uint32_t> owners = owners_of(cells);
  std::vector<VolumeError> errors(count);
  const double a = cells.cell_area_m2();
  for (size_t i = 0; i < cells.size(); ++i) {
    if (cells.zone[i] != 0) out[cells.zone[i] - 1].rows.push_back(static_cast<uint32_t>(i));
    if (owners[i] == 0 || !std::isfinite(cells.distance[i])) continue;
    out[owners[i] - 1].volume_m3 += a * cells.distance[i];
    errors[owners[i] - 1].add(cells, i);
  }
  for (uint32_t k = 0; k < count; ++k) {
    ZoneMeasure& zone = out[k];
    zone.zone = k + 1;
    zone.area_m2 = a * static_cast<double>(zone.rows.size());
    zone.volume_sigma_m3 = errors[k].sigma(cells.systematic_m);
    measure_boundary(cells, zone);
  }
  return out;
}

void add_totals(Comparison& comparison) {
  const CellTable cells(comparison);
  ZoneTotal gone, came, net;
  std::vector<uint8_t> is_gone(cells.size() + 1, 0);
  for (const ZoneMeasure& zone : zone_measures(cells)) {
    is_gone[zone.zone] = zone.volume_m3 < 0 ? 1 : 0;
    ZoneTotal& side = zone.volume_m3 < 0 ? gone : came;
    for (ZoneTotal* total : {&side, &net}) {
      total->volume += zone.volume_m3;
      total->area += zone.area_m2;
      total->boundary += zone.boundary_m;
      total->open += zone.open_boundary_m;
    }
  }
  const std::vector<uint32_t> owners = owners_of(cells);
  for (size_t i = 0; i < cells.size(); ++i) {
    if (owners[i] == 0 || !std::isfinite(cells.distance[i])) continue;
    for (ZoneTotal* total : {is_gone[owners[i]] != 0 ? &gone : &came, &net})
      total->error.add(cells, i);
  }
  FieldTable& summary = comparison.summary;
  const auto add = [&](const std::string& name, const char* unit, const char* meaning,
                       double value) { add_value<double>(summary, name, unit, meaning, value); };
  add("depletion", "m3", "of the zones that went down", -gone.volume);
  add("depletion_sigma", "m3", "its standard deviation", gone.error.sigma(cells.systematic_m));
  add("accumulation", "m3", "of the zones that rose", came.volume);
  add("accumulation_sigma", "m3", "its standard deviation", came.error.sigma(cells.systematic_m));
  add("net", "m3", "accumulation less depletion", net.volume);
  add("net_sigma", "m3", "its standard deviation", net.error.sigma(cells.systematic_m));
  add("depletion_area", "m2", "of the zones that went down", gone.area);
  add("accumulation_area", "m2", "of the zones that rose", came.area);
  add("boundary", "m", "of all zones", net.boundary);
  add("open_boundary", "m", "of that, along ground that was not measured", net.open);
  add_unmeasured(summary, cells);
}

}  // namespace jalon
