// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/cell_decomposition.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modelling/evidence/cell_regions.h"
#include "modelling/evidence/cell_sums.h"
#include "modelling/evidence/shape_cells.h"

namespace jalon {

namespace {

constexpr uint32_t kEndWindow = 1;    // cells: ends of one straight border fall in two of them
constexpr double kLeastInside = 0.5;  // of a cell, within the wall's border

// The text has points of the facade or none: strips on the plane and what is fixed to it are points too.
bool has_points(WallState state) {
  return is_wall(state) || state == WallState::kStrip || state == WallState::kProud;
}

// One end of the wall's points along a line of cells: before the cell `at`, on the line `along`.
struct WallEnds {
  uint32_t places = 0, lines = 0;        // places at = 0 ... places
  std::vector<uint8_t> falling, rising;  // by line and place: wall before, wall behind
  bool holds(const std::vector<uint8_t>& ends, uint32_t line, uint32_t at) const {
    return ends[static_cast<size_t>(line) * (places + 1) + at] != 0;
  }
};

// at(place, line) of the states of the wall.
template <class At>
WallEnds ends_of(uint32_t places, uint32_t lines, At&& at) {
  WallEnds out{places, lines, {}, {}};
  const size_t size = static_cast<size_t>(places + 1) * lines;
  out.falling.assign(size, 0);
  out.rising.assign(size, 0);
  for (uint32_t line = 0; line < lines; ++line)
    for (uint32_t place = 1; place < places; ++place) {
      const WallState before = at(place - 1, line), behind = at(place, line);
      if (before == WallState::kOutside || behind == WallState::kOutside) continue;
      const size_t k = static_cast<size_t>(line) * (places + 1) + place;
      out.falling[k] = has_points(before) && !has_points(behind);
      out.rising[k] = !has_points(before) && has_points(behind);
    }
  return out;
}

// An end is no gap between points where the next line has one beside it.
bool is_isolated(const WallEnds& all, const std::vector<uint8_t>& ends, uint32_t line,
                 uint32_t place) {
  const uint32_t low = place - std::min(place, kEndWindow),
                 high = std::min(all.places, place + kEndWindow);
  for (uint32_t p = low; p <= high; ++p) {
    if (line > 0 && all.holds(ends, line - 1, p)) return false;
    if (line + 1 < all.lines && all.holds(ends, line + 1, p)) return false;
  }
  return true;
}

// Places with at least so many ends in line, each the mean of its window; the strongest of those side by side.
void add_lines(const WallEnds& all, const std::vector<uint8_t>& ends, double least,
               std::vector<double>& out) {
  std::vector<double> count(all.places + 1, 0.0);
  for (uint32_t line = 0; line < all.lines; ++line)
    for (uint32_t place = 1; place < all.places; ++place)
      if (all.holds(ends, line, place) && !is_isolated(all, ends, line, place)) ++count[place];
  const auto sum = [&](uint32_t place) {
    double s = 0;
    for (uint32_t p = place - kEndWindow; p <= place + kEndWindow; ++p) s += count[p];
    return s;
  };
  for (uint32_t place = kEndWindow; place + kEndWindow <= all.places; ++place) {
    const double here = sum(place);
    if (here < least) continue;
    bool is_peak = true;
    for (uint32_t p = place - kEndWindow; p <= place + kEndWindow; ++p) {
      if (p < kEndWindow || p + kEndWindow > all.places || p == place) continue;
      is_peak &= p < place ? sum(p) < here : sum(p) <= here;
    }
    if (!is_peak) continue;
    double mean = 0;
    for (uint32_t p = place - kEndWindow; p <= place + kEndWindow; ++p) mean += p * count[p];
    out.push_back(mean / here);
  }
}

// Both kinds of ends, and the wall's own border; lines in one cell of the raster are one.
std::vector<double> lines_of(const WallEnds& all, double least) {
  std::vector<double> out{0, static_cast<double>(all.places)};
  add_lines(all, all.falling, least, out);
  add_lines(all, all.rising, least, out);
  std::sort(out.begin(), out.end());
  std::vector<double> apart;
  for (const double place : out)
    if (apart.empty() || std::round(place) > std::round(apart.back())) apart.push_back(place);
  return apart;
}

/// The cells between the lines, row by row; open ones are openings.
struct Decomposition {
  std::vector<double> along, up;
  std::vector<uint8_t> open;
  size_t columns() const { return along.size() - 1; }
  size_t rows() const { return up.size() - 1; }
  uint8_t& at(size_t column, size_t row) { return open[row * columns() + column]; }
};

// Step 3.
void tell_cells(const WallCells& cells, double wall_share, Decomposition& out) {
  const CellSums<uint32_t> walls(cells.columns, cells.rows,
                                 [&](size_t k) { return uint32_t{has_points(cells.states[k])}; });
  const CellSums<uint32_t> inside(cells.columns, cells.rows, [&](size_t k) {
    return uint32_t{cells.states[k] != WallState::kOutside};
  });
  const auto place = [](double line) { return static_cast<uint32_t>(std::round(line)); };
  out.open.assign(out.columns() * out.rows(), 0);
  for (size_t r = 0; r < out.rows(); ++r)
    for (size_t c = 0; c < out.columns(); ++c) {
      const uint32_t c0 = place(out.along[c]), c1 = place(out.along[c + 1]);
      const uint32_t r0 = place(out.up[r]), r1 = place(out.up[r + 1]);
      const double all = static_cast<double>(c1 - c0) * (r1 - r0);
      const double within = inside.of(c0, r0, c1, r1), wall = walls.of(c0, r0, c1, r1);
      out.at(c, r) = within >= kLeastInside * all && wall < wall_share * within;
    }
}

struct Block {
  size_t c0 = 0, r0 = 0, c1 = 0, r1 = 0;
  double area = 0;
};

// The largest rectangle of open cells whose lower left is a given one, by raster area.
Block block_from(Decomposition& d, size_t column, size_t row) {
  Block best;
  size_t right = d.columns();
  for (size_t r = row; r < d.rows() && d.at(column, r) != 0; ++r) {
    size_t c = column;
    while (c < right && d.at(c, r) != 0) ++c;
    right = c;
    const double area = (d.along[right] - d.along[column]) * (d.up[r + 1] - d.up[row]);
    if (area > best.area) best = {column, row, right, r + 1, area};
  }
  return best;
}

// Largest first; cells that a block has taken are no other's.
void take_blocks(Decomposition& d, std::vector<uint32_t> region, Task& task,
                 std::vector<Block>& out) {
  std::sort(region.begin(), region.end());
  while (true) {
    task.checkpoint(0);
    Block best;
    for (const uint32_t k : region) {
      if (d.open[k] == 0) continue;
      const Block block = block_from(d, k % d.columns(), k / d.columns());
      if (block.area > best.area) best = block;
    }
    if (!(best.area > 0)) return;
    for (size_t r = best.r0; r < best.r1; ++r)
      for (size_t c = best.c0; c < best.c1; ++c) d.at(c, r) = 0;
    out.push_back(best);
  }
}

// Step 4.
std::vector<Block> blocks_of(Decomposition& d, Task& task) {
  std::vector<uint32_t> open;
  for (size_t k = 0; k < d.open.size(); ++k)
    if (d.open[k] != 0) open.push_back(static_cast<uint32_t>(k));
  CellRegions regions(static_cast<uint32_t>(d.columns()), static_cast<uint32_t>(d.rows()));
  std::vector<Block> out;
  for (std::vector<uint32_t>& region : regions.of(open))
    take_blocks(d, std::move(region), task, out);
  return out;
}

}  // namespace

std::vector<OpeningCandidate> decomposed_openings(const WallCells& cells,
                                                  const OpeningSearch& setting, Task& task) {
  if (cells.empty()) return {};
  const double least = std::max(1.0, setting.edge_length_m / cells.cell_m);
  Decomposition d;
  d.along = lines_of(
      ends_of(cells.columns, cells.rows, [&](uint32_t c, uint32_t r) { return cells.at(c, r); }),
      least);
  d.up = lines_of(
      ends_of(cells.rows, cells.columns, [&](uint32_t r, uint32_t c) { return cells.at(c, r); }),
      least);
  tell_cells(cells, setting.wall_share, d);
  const double least_side = setting.least_width_m / cells.cell_m;
  std::vector<OpeningCandidate> out;
  for (const Block& block : blocks_of(d, task)) {
    const double left = d.along[block.c0], right = d.along[block.c1], foot = d.up[block.r0],
                 head = d.up[block.r1];
    if (right - left < least_side || head - foot < least_side) continue;
    const OpeningShape shape{ShapeKind::kRectangle, {left, right, foot, head, 0, 0}};
    OpeningCandidate candidate = looked_at(cells, shape);
    const OpenEnds open = open_ends(cells, shape);
    candidate.is_opening = !(open.head && open.foot);
    out.push_back(candidate);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const OpeningCandidate& a, const OpeningCandidate& b) {
                     return a.shape.box().low.u < b.shape.box().low.u;
                   });
  return out;
}

}  // namespace jalon
