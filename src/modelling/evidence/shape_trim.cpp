// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/shape_trim.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jalon {

namespace {

constexpr double kSeenInBand = 0.04, kSeenInRest = 0.25;  // shares of cells that were seen through
constexpr double kHiddenInBand = 0.1;
constexpr int kLeastBand = 3;    // cells
constexpr int kBeside = 4;       // cells beside the opening
constexpr double kGoesOn = 0.5;  // of them without wall, on either side

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
  // Nothing was seen there, and nothing before it explains that.
  bool is_blank(int line) const {
    const auto is_hidden = [](WallState s) { return s == WallState::kHidden; };
    return seen(line, line + 1) <= kSeenInBand &&
           share(line, line + 1, from, to, is_hidden) <= kHiddenInBand;
  }
  // Whether the band between two lines goes on beside the rectangle, at one of its ends.
  bool goes_on(int line0, int line1) const {
    const auto is_open = [](WallState s) { return !is_wall(s) && s != WallState::kOutside; };
    return std::max(share(line0, line1, from - 1 - kBeside, from - 1, is_open),
                    share(line0, line1, to + 1, to + 1 + kBeside, is_open)) >= kGoesOn;
  }
};

// What is left between bands, as pairs of lines.
std::vector<std::pair<int, int>> without_bands(const Lines& lines) {
  std::vector<std::pair<int, int>> out;
  int start = lines.first;
  for (int line = lines.first; line < lines.last;) {
    int end = line;
    while (end < lines.last && lines.is_blank(end)) ++end;
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
