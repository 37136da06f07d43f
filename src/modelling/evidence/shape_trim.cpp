// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/shape_trim.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jalon {

namespace {

constexpr double kSeenInBand = 0.04, kSeenInRest = 0.25;  // shares of cells that were seen through
// Strays are seen in bands too. A line may be a band's up to the share that either share explains as well:
// log(0.96 / 0.75) / log(0.96 * 0.25 / (0.75 * 0.04)).
constexpr double kSeenInLine = 0.119;
constexpr double kHiddenInBand = 0.1;
constexpr int kLeastBand = 3;    // cells
constexpr int kBeside = 2;       // cells beside the opening
constexpr double kGoesOn = 0.5;  // of the lines there, without wall

bool is_seen(WallState state) { return state == WallState::kThrough || state == WallState::kDeep; }

// Lines across a rectangle of cells: its rows, or its columns.
struct Lines {
  const WallCells& cells;
  int first, last;  ///< lines [first, last)
  int from, to;     ///< along them
  bool are_rows;

  WallState at(int line, int along) const {
    const int c = are_rows ? along : line, r = are_rows ? line : along;
    const bool is_there =
        c >= 0 && r >= 0 && c < static_cast<int>(cells.columns) && r < static_cast<int>(cells.rows);
    return is_there ? cells.at(static_cast<uint32_t>(c), static_cast<uint32_t>(r))
                    : WallState::kOutside;
  }
  template <class F>
  double share(int line0, int line1, int along0, int along1, F&& holds) const {
    int all = 0, yes = 0;
    for (int line = line0; line < line1; ++line)
      for (int along = along0; along < along1; ++along, ++all) yes += holds(at(line, along));
    return all > 0 ? static_cast<double>(yes) / all : 0;
  }
  double seen(int line0, int line1) const { return share(line0, line1, from, to, is_seen); }
  // Hardly anything was seen there, and nothing before it explains that.
  bool is_blank(int line, double most_seen) const {
    const auto is_hidden = [](WallState s) { return s == WallState::kHidden; };
    return seen(line, line + 1) <= most_seen &&
           share(line, line + 1, from, to, is_hidden) <= kHiddenInBand;
  }
  // The end of the band that begins at a line; that line: none does. One cell may be seen in its first and last lines,
  // more only in those between.
  int end_of_band(int line) const {
    const double at_end = std::max(kSeenInBand, 1.0 / (to - from));
    int end = line;
    for (int at = line; at < last && is_blank(at, kSeenInLine); ++at)
      if (is_blank(at, at_end) && seen(line, at + 1) <= kSeenInBand) end = at + 1;
    return end;
  }
  // Whether the band between two lines goes on beside the rectangle, at one of its ends: in every cell of so many, for
  // a neighbour's opening may lie behind a pier.
  bool goes_on(int line0, int line1) const {
    const auto is_open = [](WallState s) { return !is_wall(s) && s != WallState::kOutside; };
    const auto are_open = [&](int along, int step) {
      for (int k = 0; k < kBeside; ++k, along += step)
        if (share(line0, line1, along, along + 1, is_open) < kGoesOn) return false;
      return true;
    };
    return are_open(from - 2, -1) || are_open(to + 1, 1);
  }
};

// What is left between bands, as pairs of lines.
std::vector<std::pair<int, int>> without_bands(const Lines& lines) {
  std::vector<std::pair<int, int>> out;
  int start = lines.first;
  for (int line = lines.first; line < lines.last;) {
    const int end = lines.end_of_band(line);
    if (end - line >= kLeastBand && lines.goes_on(line, end)) {
      if (line > start) out.push_back({start, line});
      start = end;
    }
    line = std::max(end, line + 1);
  }
  if (lines.last > start) out.push_back({start, lines.last});
  const bool are_seen = std::all_of(out.begin(), out.end(), [&](const auto& part) {
    return lines.seen(part.first, part.second) >= kSeenInRest;
  });
  if (out.empty() || !are_seen) return {{lines.first, lines.last}};
  return out;
}

}  // namespace

std::vector<OpeningShape> parts_of(const WallCells& cells, const OpeningShape& shape) {
  if (shape.kind != ShapeKind::kRectangle) return {shape};
  const auto line = [&](size_t i) { return static_cast<int>(std::lround(shape.sizes[i])); };
  const Lines rows{cells, line(2), line(3), line(0), line(1), true};
  std::vector<OpeningShape> out;
  for (const auto& [foot, head] : without_bands(rows)) {
    const Lines columns{cells, line(0), line(1), foot, head, false};
    for (const auto& [left, right] : without_bands(columns)) {
      OpeningShape part = shape;
      const auto keep = [&](size_t i, int before, int now) {
        if (now != before) part.sizes[i] = now;  // a side that stays keeps its fraction of a cell
      };
      keep(0, line(0), left);
      keep(1, line(1), right);
      keep(2, line(2), foot);
      keep(3, line(3), head);
      out.push_back(part);
    }
  }
  return out;
}

}  // namespace jalon
