// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/cell_rings.h"

#include <algorithm>
#include <array>
#include <map>

#include "geometry/polygon2.h"

namespace jalon {

namespace {

using GridCorner =
    std::array<int64_t,
               2>;  // row, column of a corner: that of the cell above and to the right of it
constexpr int kSteps[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};  // right, up, left, down

/// Edges of one piece with its cells to their left, by where they start: two where cells touch at a corner.
using EdgeMap = std::map<GridCorner, std::vector<int>>;

void add_edges(const CellTable& cells, const std::vector<uint32_t>& piece_of, uint32_t row,
               EdgeMap& edges) {
  const int64_t c = cells.column[row], r = cells.line[row];
  const auto is_outside = [&](int columns, int rows) {
    const size_t other = cells.beside(row, columns, rows);
    return other == CellTable::kNone || piece_of[other] != piece_of[row];
  };
  if (is_outside(0, -1)) edges[{r, c}].push_back(0);
  if (is_outside(1, 0)) edges[{r, c + 1}].push_back(1);
  if (is_outside(0, 1)) edges[{r + 1, c + 1}].push_back(2);
  if (is_outside(-1, 0)) edges[{r + 1, c}].push_back(3);
}

// Middles of the edges of one ring; straight runs keep their ends only.
std::vector<Vec2> next_ring(EdgeMap& edges, double cell_m) {
  std::vector<Vec2> middles;
  const GridCorner start = edges.begin()->first;
  GridCorner at = start;
  int heading = edges.begin()->second.front();
  std::vector<int> headings;
  do {
    auto found = edges.find(at);
    std::vector<int>& out = found->second;
    // Where two go on, the turn to the left stays with the same cell.
    const auto left = std::find(out.begin(), out.end(), (heading + 1) % 4);
    const auto chosen = left != out.end() ? left : out.begin();
    heading = *chosen;
    out.erase(chosen);
    if (out.empty()) edges.erase(found);
    const double column = static_cast<double>(at[1]) + kSteps[heading][1] * 0.5 - 0.5,
                 row = static_cast<double>(at[0]) + kSteps[heading][0] * 0.5 - 0.5;
    middles.push_back({column * cell_m, row * cell_m});
    headings.push_back(heading);
    at = {at[0] + kSteps[heading][0], at[1] + kSteps[heading][1]};
  } while (at != start || edges.contains(at));
  std::vector<Vec2> ring;
  const size_t n = middles.size();
  for (size_t k = 0; k < n; ++k) {
    const Vec2 in = middles[k] - middles[(k + n - 1) % n], out = middles[(k + 1) % n] - middles[k];
    if (cross(in, out) != 0) ring.push_back(middles[k]);
  }
  return ring;
}

CellPiece piece_with(const CellTable& cells, const std::vector<uint32_t>& piece_of,
                     std::vector<uint32_t> rows) {
  EdgeMap edges;
  for (const uint32_t row : rows) add_edges(cells, piece_of, row, edges);
  CellPiece out;
  while (!edges.empty()) {
    std::vector<Vec2> ring = next_ring(edges, cells.cell_m);
    if (signed_area(ring) > 0) out.outline = std::move(ring);
    else out.openings.push_back(std::move(ring));
  }
  out.rows = std::move(rows);
  return out;
}

}  // namespace

std::vector<CellPiece> cell_pieces(const CellTable& cells,
                                   const std::function<bool(size_t row)>& belongs, size_t fewest) {
  std::vector<uint32_t> piece_of(cells.size(), 0);
  std::vector<CellPiece> out;
  uint32_t pieces = 0;
  for (size_t first = 0; first < cells.size(); ++first) {
    if (piece_of[first] != 0 || !belongs(first)) continue;
    piece_of[first] = ++pieces;
    std::vector<uint32_t> rows{static_cast<uint32_t>(first)};
    for (size_t k = 0; k < rows.size(); ++k)
      for (const auto& [lines, columns] : kSteps) {
        const size_t other = cells.beside(rows[k], columns, lines);
        if (other == CellTable::kNone || piece_of[other] != 0 || !belongs(other)) continue;
        piece_of[other] = pieces;
        rows.push_back(static_cast<uint32_t>(other));
      }
    if (rows.size() < fewest) continue;
    std::sort(rows.begin(), rows.end());
    out.push_back(piece_with(cells, piece_of, std::move(rows)));
  }
  return out;
}

}  // namespace jalon
