// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/cell_classes.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

#include "modelling/evidence/cell_regions.h"
#include "modelling/evidence/cell_sums.h"

namespace jalon {

namespace {

// A pier of bricks is no narrower than half a brick (Boulaassal 2010 merges strips below 10 to 15 cm with what is
// beside them); at coarse spacing two cells, below which nothing has a width.
constexpr double kPier_m = 0.12;
constexpr uint32_t kPierCells = 2;
// Of the cells of a square of a pier's width: all but what gaps between random points leave. Of one three times as
// wide: a wall whose points lie thinly is no strip.
constexpr double kPierShare = 0.8, kThinWallShare = 0.55;

// Leaves and stiles flush with the wall, apart from it: smaller than a pier a storey high, seen through all about. The
// wall itself is in one piece: a room's, seen through windows, is all islands.
constexpr double kIsland_m2 = 0.5, kSeenAbout = 0.5, kMainShare = 0.5;

constexpr double kPilaster_m = 2;  // parapets are no taller than 1.3 m
constexpr double kBar_m =
    0.3;  // of railings, with what neighbouring cells have of them: a sign is broader
constexpr double kFootReach_m = 4;  // half a wide gateway, a van's length

WallState state_of(uint8_t marks) {
  if ((marks & kMarkOn) != 0) return WallState::kOn;
  if ((marks & kMarkBehind) != 0) return WallState::kThrough;
  if ((marks & kMarkFlush) != 0) return WallState::kStrip;
  if ((marks & kMarkRelief) != 0) return WallState::kRelief;
  if ((marks & kMarkProud) != 0) return WallState::kProud;
  // What is deep behind something that stands before the wall was seen past it, through an opening beside.
  if ((marks & kMarkBefore) != 0) return WallState::kHidden;
  return (marks & kMarkDeep) != 0 ? WallState::kDeep : WallState::kEmpty;
}

// Marks what lies in a square of `width` cells of which the share are on the plane.
void keep_squares(const CellSums<int32_t>& on, uint32_t width, double share, const WallCells& cells,
                  std::vector<int32_t>& kept) {
  if (cells.columns < width || cells.rows < width) return;
  const auto least = static_cast<int32_t>(std::ceil(share * width * width));
  // Corners of a sum that says how many such squares cover a cell.
  const size_t stride = cells.columns + 1;
  std::vector<int32_t> corners(stride * (cells.rows + 1), 0);
  for (uint32_t r = 0; r + width <= cells.rows; ++r)
    for (uint32_t c = 0; c + width <= cells.columns; ++c) {
      if (on.of(c, r, c + width, r + width) < least) continue;
      ++corners[r * stride + c];
      --corners[r * stride + c + width];
      --corners[(r + width) * stride + c];
      ++corners[(r + width) * stride + c + width];
    }
  std::vector<int32_t> column(stride, 0);
  for (uint32_t r = 0; r < cells.rows; ++r) {
    int32_t along = 0;
    for (uint32_t c = 0; c < cells.columns; ++c) {
      column[c] += corners[r * stride + c];
      along += column[c];
      kept[static_cast<size_t>(r) * cells.columns + c] += along;
    }
  }
}

// Step 1, pilasters.
void tell_pilasters(std::span<const uint8_t> marks, WallCells& cells, Task& task) {
  std::vector<uint32_t> proud;
  for (size_t k = 0; k < marks.size(); ++k)
    if (cells.states[k] == WallState::kProud && (marks[k] & kMarkParallel) != 0)
      proud.push_back(static_cast<uint32_t>(k));
  if (proud.empty()) return;
  task.checkpoint(0);
  CellRegions regions(cells.columns, cells.rows);
  for (const std::vector<uint32_t>& region : regions.of(proud)) {
    const auto [low, high] = std::minmax_element(region.begin(), region.end());
    const uint32_t rows = *high / cells.columns - *low / cells.columns + 1;
    if (rows * cells.cell_m < kPilaster_m) continue;
    for (const uint32_t k : region) cells.states[k] = WallState::kRelief;
  }
}

// A line of cells through one: what ends a run of proud cells on both sides, within a bar's width.
struct RunEnds {
  WallState first = WallState::kProud, last = WallState::kProud;

  RunEnds(const WallCells& cells, uint32_t c, uint32_t r, bool is_level) {
    const auto reach = std::max(uint32_t{1}, static_cast<uint32_t>(kBar_m / cells.cell_m));
    const auto end = [&](bool is_up) {
      for (uint32_t k = 1; k <= reach; ++k) {
        const uint32_t x = is_level ? (is_up ? c + k : c - k) : c,
                       y = is_level ? r : (is_up ? r + k : r - k);
        if (x >= cells.columns || y >= cells.rows) break;  // below 0 too
        if (cells.at(x, y) != WallState::kProud) return cells.at(x, y);
      }
      return WallState::kProud;
    };
    first = end(false);
    last = end(true);
  }
  // Bars end at gaps, the last one at a jamb; rails have gaps above and below, sills only above.
  bool is_bar() const {
    return (is_gap(first) && last != WallState::kProud) ||
           (is_gap(last) && first != WallState::kProud);
  }
  bool is_rail() const { return is_gap(first) && is_gap(last); }
  static bool is_gap(WallState state) {
    return state == WallState::kEmpty || state == WallState::kThrough || state == WallState::kDeep;
  }
};

// Step 1, railings.
void tell_railings(WallCells& cells, Task& task) {
  task.checkpoint(0);
  std::vector<uint32_t> bars;
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c)
      if (cells.at(c, r) == WallState::kProud &&
          (RunEnds(cells, c, r, true).is_bar() || RunEnds(cells, c, r, false).is_rail()))
        bars.push_back(r * cells.columns + c);
  for (const uint32_t k : bars) cells.states[k] = WallState::kHidden;
}

// Step 2.
void tell_strips(WallCells& cells, Task& task) {
  CellSums<int32_t> on(cells.columns, cells.rows, [&](size_t k) {
    return static_cast<int32_t>(cells.states[k] == WallState::kOn);
  });
  task.checkpoint(0);
  const uint32_t pier =
      std::max(kPierCells, static_cast<uint32_t>(std::ceil(kPier_m / cells.cell_m)));
  std::vector<int32_t> kept(cells.states.size(), 0);
  keep_squares(on, pier, kPierShare, cells, kept);
  task.checkpoint(0);
  keep_squares(on, 3 * pier, kThinWallShare, cells, kept);
  for (size_t k = 0; k < kept.size(); ++k)
    if (cells.states[k] == WallState::kOn && kept[k] == 0) cells.states[k] = WallState::kStrip;
}

// Step 3.
void tell_islands(WallCells& cells, Task& task) {
  std::vector<uint32_t> on;
  for (size_t k = 0; k < cells.states.size(); ++k)
    if (cells.states[k] == WallState::kOn) on.push_back(static_cast<uint32_t>(k));
  task.checkpoint(0);
  CellRegions regions(cells.columns, cells.rows);
  const std::vector<std::vector<uint32_t>> parts = regions.of(on);
  const bool has_main = std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
    return static_cast<double>(part.size()) >= kMainShare * static_cast<double>(on.size());
  });
  if (!has_main) return;
  const double most = kIsland_m2 / (cells.cell_m * cells.cell_m);
  for (const std::vector<uint32_t>& region : parts) {
    if (static_cast<double>(region.size()) > most) continue;
    size_t about = 0, seen = 0;
    const auto look = [&](uint32_t c, uint32_t r) {
      if (c >= cells.columns || r >= cells.rows) return;
      const WallState state = cells.at(c, r);
      if (state == WallState::kOn) return;
      ++about;
      seen += state == WallState::kThrough || state == WallState::kStrip;
    };
    for (const uint32_t k : region) {
      const uint32_t c = k % cells.columns, r = k / cells.columns;
      look(c - 1, r);
      look(c + 1, r);
      look(c, r - 1);
      look(c, r + 1);
    }
    if (static_cast<double>(seen) < kSeenAbout * static_cast<double>(about)) continue;
    for (const uint32_t k : region) cells.states[k] = WallState::kStrip;
  }
}

// First and last wall cell of each row or column; first > last: none.
struct Reach {
  std::vector<uint32_t> first, last;
  explicit Reach(size_t n) : first(n, ~uint32_t{0}), last(n, 0) {}
  void add(size_t line, uint32_t at) {
    first[line] = std::min(first[line], at);
    last[line] = std::max(last[line], at);
  }
};

// The wall's foot below each column: its lowest cell within reach, so that a gateway's or a parked car's width keeps
// the foot of the wall beside it.
std::vector<uint32_t> foot_line(const std::vector<uint32_t>& first, uint32_t reach) {
  std::vector<uint32_t> out(first.size());
  std::deque<size_t> least;  // of the window, ascending rows
  for (size_t c = 0, next = 0; c < first.size(); ++c) {
    for (; next < first.size() && next <= c + reach; ++next) {
      while (!least.empty() && first[least.back()] >= first[next]) least.pop_back();
      least.push_back(next);
    }
    while (least.front() + reach < c) least.pop_front();
    out[c] = first[least.front()];
  }
  return out;
}

// Step 4.
void tell_outside(WallCells& cells) {
  Reach along_row(cells.rows), along_column(cells.columns);
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c)
      if (is_wall(cells.at(c, r))) {
        along_row.add(r, c);
        along_column.add(c, r);
      }
  const std::vector<uint32_t> foot =
      foot_line(along_column.first, static_cast<uint32_t>(std::ceil(kFootReach_m / cells.cell_m)));
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c) {
      WallState& state = cells.states[static_cast<size_t>(r) * cells.columns + c];
      if (is_wall(state) || state == WallState::kStrip) continue;
      const bool has_column = along_column.first[c] <= along_column.last[c];
      const bool above = has_column && r < along_column.last[c];
      const bool beside = along_row.first[r] < c && c < along_row.last[r];
      const bool is_inside = (above && r >= foot[c]) || (beside && state == WallState::kThrough);
      if (!is_inside) state = WallState::kOutside;
    }
}

}  // namespace

void classify_cells(std::span<const uint8_t> marks, WallCells& out, Task& task) {
  out.states.resize(marks.size());
  for (size_t k = 0; k < marks.size(); ++k) out.states[k] = state_of(marks[k]);
  if (marks.empty()) return;
  tell_pilasters(marks, out, task);
  tell_railings(out, task);
  tell_strips(out, task);
  tell_islands(out, task);
  tell_outside(out);
}

}  // namespace jalon
