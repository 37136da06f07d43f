// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/cell_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/serial.h"

namespace jalon {

namespace {

constexpr double kMaxCells = 0x1p30;  // rows and columns, well inside 31 bits
constexpr uint64_t kRow = uint64_t{1} << 32;

constexpr size_t kRowPointsPerLook = size_t{1} << 16;  // each in another place: some milliseconds
constexpr uint64_t kRowCellsPerLook = uint64_t{1} << 20;

constexpr uint64_t kDenseCells = 8,
                   kDenseFloor = 65536;  // a counter a cell pays off up to so many cells a point

// Counting sort: O(points + cells).
void count_into_cells(std::span<const Vec2> points, uint64_t columns, uint64_t rows, CellRows& out,
                      Task& task) {
  const auto cell_of = [&](const Vec2& p) {
    const uint64_t key = out.key_of(p);
    return ((key >> 32) - 1) * columns + (key & 0xffffffffu) - 1;
  };
  std::vector<uint32_t> next(rows * columns, 0);
  serial_for(task, points.size(), kRowPointsPerLook, [&](size_t begin, size_t end) {
    for (const Vec2& p : points.subspan(begin, end - begin)) ++next[cell_of(p)];
  });
  uint32_t before = 0;  // points in the cells before
  for (uint64_t cell = 0; cell < next.size(); ++cell) {
    if (cell % kRowCellsPerLook == 0) task.checkpoint(0);
    if (next[cell] == 0) continue;
    out.keys.push_back((cell / columns + 1) << 32 | (cell % columns + 1));
    out.first.push_back(before);
    before += std::exchange(next[cell], before);
  }
  out.order.resize(points.size());
  serial_for(task, points.size(), kRowPointsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      out.order[next[cell_of(points[i])]++] = static_cast<uint32_t>(i);
  });
}

// Few points in a wide raster: O(n log n).
void compare_into_cells(std::span<const Vec2> points, CellRows& out, Task& task) {
  std::vector<std::pair<uint64_t, uint32_t>> keyed(points.size());
  for (size_t i = 0; i < points.size(); ++i)
    keyed[i] = {out.key_of(points[i]), static_cast<uint32_t>(i)};
  serial_sort(task, keyed.begin(), keyed.end());
  out.order.resize(points.size());
  for (size_t i = 0; i < keyed.size(); ++i) {
    out.order[i] = keyed[i].second;
    if (i != 0 && keyed[i].first == keyed[i - 1].first) continue;
    out.keys.push_back(keyed[i].first);
    out.first.push_back(static_cast<uint32_t>(i));
  }
}

}  // namespace

uint64_t CellRows::key_of(const Vec2& p) const {
  const auto column = static_cast<uint64_t>((p.u - corner.u) / cell_m) + 1;
  const auto row = static_cast<uint64_t>((p.v - corner.v) / cell_m) + 1;
  return row << 32 | column;
}

size_t CellRows::find(uint64_t key) const {
  const auto it = std::lower_bound(keys.begin(), keys.end(), key);
  return it != keys.end() && *it == key ? static_cast<size_t>(it - keys.begin()) : keys.size();
}

CellRows sort_into_cells(std::span<const Vec2> points, double cell_m, Task& task) {
  CellRows out;
  Vec2 low = points.front(), high = points.front();
  for (const Vec2& p : points) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  out.corner = low;
  out.cell_m = std::max(cell_m, std::max(high.u - low.u, high.v - low.v) / kMaxCells);
  if (!(out.cell_m > 0)) out.cell_m = 1;
  const uint64_t last = out.key_of(high), columns = (last & 0xffffffffu), rows = last >> 32;
  if (rows * columns <= kDenseCells * points.size() + kDenseFloor)
    count_into_cells(points, columns, rows, out, task);
  else compare_into_cells(points, out, task);
  out.first.push_back(static_cast<uint32_t>(points.size()));
  return out;
}

std::vector<uint8_t> eroded(const CellRows& rows, std::span<const uint8_t> marked) {
  const auto& keys = rows.keys;
  const size_t n = keys.size();
  std::vector<uint8_t> out(n, 0);
  const auto three = [&](size_t at, uint64_t key) {  // cells key, key + 1, key + 2 from position at
    return at + 2 < n && keys[at] == key && keys[at + 1] == key + 1 && keys[at + 2] == key + 2 &&
           marked[at] != 0 && marked[at + 1] != 0 && marked[at + 2] != 0;
  };
  // The neighbours' keys grow with the cell's key, so two cursors walk the rows below and above.
  size_t below = 0, above = 0;
  for (size_t i = 0; i < n; ++i) {
    const uint64_t key = keys[i];
    while (below < n && keys[below] < key - kRow - 1) ++below;
    while (above < n && keys[above] < key + kRow - 1) ++above;
    out[i] = i > 0 && three(i - 1, key - 1) && three(below, key - kRow - 1) &&
                     three(above, key + kRow - 1)
                 ? 1
                 : 0;
  }
  return out;
}

}  // namespace jalon
