// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/patterns/grid.h"

#include <algorithm>
#include <cmath>

#include "modelling/patterns/patterns.h"
#include "modelling/patterns/place.h"

namespace jalon {

namespace {

// A line costs its first opening a coordinate; every further one agrees with it. So many agreements come not by chance:
// a field of 2 x 3 less one has five, one of 2 x 4 with half of a row four.
constexpr double kLeastAgreements = 4;
constexpr size_t kLeastOfRow = 4;       // a single line: equal distances of three and a gap
constexpr double kLineOccupancy = 0.5;  // of the crossings of a line that can be seen
constexpr double kGridSolid = 0.2;      // share of a crossing's cells that shows the bare wall

/// One axis: 0 = u makes columns, 1 = v makes rows.
double along(const Vec2& p, int axis) { return axis == 0 ? p.u : p.v; }

std::vector<GridLine> lines_of(std::span<const size_t> openings, std::span<const RingBox> boxes,
                               int axis, double reach_m) {
  std::vector<size_t> order(openings.begin(), openings.end());
  const auto at = [&](size_t i) { return along(boxes[i].middle(), axis); };
  std::sort(order.begin(), order.end(),
            [&](size_t a, size_t b) { return at(a) != at(b) ? at(a) < at(b) : a < b; });
  std::vector<GridLine> out;
  for (const size_t i : order) {
    if (out.empty() || at(i) - out.back().at > reach_m) out.emplace_back();
    GridLine& line = out.back();
    line.openings.push_back(i);
    line.at += (at(i) - line.at) / static_cast<double>(line.openings.size());
  }
  return out;
}

enum class Crossing : uint8_t { kTaken, kBare, kUnseen };

bool in_line(const GridLine& line, size_t opening) {
  return std::find(line.openings.begin(), line.openings.end(), opening) != line.openings.end();
}

/// What stands where a row and a column cross.
Crossing crossing_of(const FacadeWall& wall, std::span<const RingBox> boxes, const GridLine& row,
                     const GridLine& column) {
  for (const size_t i : row.openings)
    if (in_line(column, i)) return Crossing::kTaken;
  const RingBox& like = boxes[row.openings[0]];
  const Vec2 half{like.width() / 2, like.height() / 2}, c{column.at, row.at};
  for (const RingBox& box : boxes)
    if (std::fabs(box.middle().u - c.u) < half.u + box.width() / 2 &&
        std::fabs(box.middle().v - c.v) < half.v + box.height() / 2)
      return Crossing::kUnseen;  // another opening is in the way: no sign against the grid
  const std::vector<Vec2> form{
      c - half, {c.u + half.u, c.v - half.v}, c + half, {c.u - half.u, c.v + half.v}};
  const CellCount cells = count_cells(wall.map, form, wall.map.cell_m);
  if (cells.all() == 0 || cells.share(WallCell::kSolid) > kGridSolid) return Crossing::kBare;
  return Crossing::kUnseen;
}

struct Occupancy {
  double taken = 0, seen = 0;
  void add(Crossing c) {
    taken += c == Crossing::kTaken;
    seen += c != Crossing::kUnseen;
  }
  double share() const { return seen > 0 ? taken / seen : 0; }
};

using Crossings = std::vector<std::vector<Crossing>>;  // [row][column]

/// Leaves out the line whose crossings are most bare while one is mostly so.
void prune(OpeningGrid& grid, Crossings& crossings) {
  while (!grid.rows.empty() && !grid.columns.empty()) {
    std::vector<Occupancy> rows(grid.rows.size()), columns(grid.columns.size());
    for (size_t r = 0; r < rows.size(); ++r)
      for (size_t c = 0; c < columns.size(); ++c) {
        rows[r].add(crossings[r][c]);
        columns[c].add(crossings[r][c]);
      }
    const auto emptier = [](const Occupancy& a, const Occupancy& b) {
      return a.share() < b.share();
    };
    const auto row = std::min_element(rows.begin(), rows.end(), emptier);
    const auto column = std::min_element(columns.begin(), columns.end(), emptier);
    if (std::min(row->share(), column->share()) >= kLineOccupancy) return;
    if (row->share() <= column->share()) {
      grid.rows.erase(grid.rows.begin() + (row - rows.begin()));
      crossings.erase(crossings.begin() + (row - rows.begin()));
    } else {
      grid.columns.erase(grid.columns.begin() + (column - columns.begin()));
      for (auto& line : crossings) line.erase(line.begin() + (column - columns.begin()));
    }
  }
}

/// Four and more at whole multiples of one distance, most of the places taken; null's columns for the gaps are added.
bool fill_pitch(std::vector<GridLine>& lines, double reach_m, const PatternSetting& setting) {
  if (lines.size() < kLeastOfRow) return false;
  double pitch = lines[1].at - lines[0].at;
  for (size_t i = 1; i + 1 < lines.size(); ++i)
    pitch = std::min(pitch, lines[i + 1].at - lines[i].at);
  const double places = std::round((lines.back().at - lines.front().at) / pitch) + 1;
  if (static_cast<double>(lines.size()) < setting.least_occupancy * places || places > 1e6)
    return false;
  pitch = (lines.back().at - lines.front().at) / (places - 1);
  std::vector<GridLine> out;
  size_t next = 0;
  for (double k = 0; k < places; ++k) {
    const double at = lines.front().at + k * pitch;
    if (next < lines.size() && std::fabs(lines[next].at - at) <= reach_m)
      out.push_back(lines[next++]);
    else out.push_back({at, {}});
  }
  if (next < lines.size()) return false;
  lines = std::move(out);
  return true;
}

// What is known of builders before a wall is looked at: windows stand to half of the tolerance of sizes on their lines,
// which counts as much as two openings more than lines.
constexpr double kPriorOfTolerance = 0.5, kPriorFreedom = 2;

double scatter_about(const OpeningGrid& grid, std::span<const RingBox> boxes, double tolerance_m) {
  const double prior_m = kPriorOfTolerance * tolerance_m;
  double squares_m2 = kPriorFreedom * prior_m * prior_m, freedom = kPriorFreedom;
  for (int axis = 0; axis < 2; ++axis)
    for (const GridLine& line : axis == 0 ? grid.columns : grid.rows) {
      for (const size_t i : line.openings)
        squares_m2 += std::pow(along(boxes[i].middle(), axis) - line.at, 2);
      freedom += static_cast<double>(std::max<size_t>(1, line.openings.size()) - 1);
    }
  return std::sqrt(squares_m2 / freedom);
}

}  // namespace

const GridLine* OpeningGrid::near(const std::vector<GridLine>& lines, double at, double reach_m) {
  const GridLine* best = nullptr;
  for (const GridLine& line : lines)
    if (std::fabs(line.at - at) <= reach_m &&
        (best == nullptr || std::fabs(line.at - at) < std::fabs(best->at - at)))
      best = &line;
  return best;
}

double grid_reach_m(const FacadeWall& wall, const PatternSetting& setting) {
  return std::max(2 * setting.size_tolerance_m, wall.spacing_m);
}

OpeningGrid find_grid(const FacadeWall& wall, std::span<const size_t> openings,
                      std::span<const RingBox> boxes, const PatternSetting& setting) {
  // 1. Lines of equal centres.
  const double reach_m = grid_reach_m(wall, setting);
  OpeningGrid grid{lines_of(openings, boxes, 1, reach_m), lines_of(openings, boxes, 0, reach_m), 0};

  // 2. Those whose crossings are mostly taken where they can be seen.
  Crossings crossings(grid.rows.size());
  for (size_t r = 0; r < grid.rows.size(); ++r)
    for (const GridLine& column : grid.columns)
      crossings[r].push_back(crossing_of(wall, boxes, grid.rows[r], column));
  prune(grid, crossings);
  Occupancy all;
  for (const auto& line : crossings)
    for (const Crossing c : line) all.add(c);
  if (all.share() < setting.least_occupancy) return {};
  grid.sigma_m = scatter_about(grid, boxes, setting.size_tolerance_m);

  // 3. Enough of them: a field of two rows and columns, or one line with equal distances.
  if (grid.rows.size() == 1 && fill_pitch(grid.columns, reach_m, setting)) return grid;
  if (grid.columns.size() == 1 && fill_pitch(grid.rows, reach_m, setting)) return grid;
  const bool is_field = grid.rows.size() >= 2 && grid.columns.size() >= 2;
  const double agreements =
      2 * all.taken - static_cast<double>(grid.rows.size() + grid.columns.size());
  return is_field && agreements >= kLeastAgreements ? grid : OpeningGrid{};
}

size_t pattern_at(std::span<const Pattern> patterns, const GridLine& row, const GridLine& column) {
  size_t best = patterns.size(), most = 0;
  for (size_t p = 0; p < patterns.size(); ++p) {
    const auto& members = patterns[p].members;
    const auto is_member = [&](size_t i) {
      return std::find(members.begin(), members.end(), i) != members.end();
    };
    const auto count = [&](const GridLine& line) {
      return static_cast<size_t>(
          std::count_if(line.openings.begin(), line.openings.end(), is_member));
    };
    const size_t in_row = count(row), in_column = count(column);
    const bool fits = in_row > 0 || (row.openings.empty() && in_column > 0);
    if (fits && in_row + in_column > most) best = p, most = in_row + in_column;
  }
  return best;
}

}  // namespace jalon
