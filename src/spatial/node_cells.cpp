// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/node_cells.h"

#include <bit>
#include <cmath>
#include <numeric>

#include "base/serial.h"
#include "spatial/radix_sort.h"

namespace jalon {

namespace {

// Places so far away share a cell: doubles tell no neighbours apart there, and whole numbers have an end.
constexpr double kFarthestCell = 0x1p60;
constexpr size_t kMostInCache = 1 << 16;  // cells that are sorted by their digits: 1.5 MiB

int64_t cell_number(double place_m, double cell_m) {
  return static_cast<int64_t>(
      std::clamp(std::floor(place_m / cell_m), -kFarthestCell, kFarthestCell));
}

// Columns and rows of cells, both included.
struct CellBox {
  NodeCell low{0, 0}, high{-1, -1};
  explicit CellBox(std::span<const NodeCell> cells) {
    if (cells.empty()) return;
    low = high = cells[0];
    for (const NodeCell& cell : cells) {
      low = {std::min(low.column, cell.column), std::min(low.row, cell.row)};
      high = {std::max(high.column, cell.column), std::max(high.row, cell.row)};
    }
  }
  uint64_t columns() const { return static_cast<uint64_t>(high.column - low.column) + 1; }
  uint64_t rows() const { return static_cast<uint64_t>(high.row - low.row) + 1; }
};

}  // namespace

NodeCell cell_at(const Vec2& p, double cell_m) {
  return {cell_number(p.u, cell_m), cell_number(p.v, cell_m)};
}

namespace {

// By column, then by row, each counted from the box's first.
std::vector<uint32_t> order_of_few(std::span<const NodeCell> cells, const CellBox& box,
                                   int row_bits) {
  const size_t n = cells.size();
  std::vector<uint64_t> keys(2 * n);
  std::vector<uint32_t> order(2 * n);
  for (size_t i = 0; i < n; ++i) {
    const auto column = static_cast<uint64_t>(cells[i].column - box.low.column);
    keys[i] = column << row_bits | static_cast<uint64_t>(cells[i].row - box.low.row);
    order[i] = static_cast<uint32_t>(i);
  }
  sort_pairs({keys.data(), order.data()}, {keys.data() + n, order.data() + n}, n);
  order.resize(n);
  return order;
}

}  // namespace

// Few by their digits; where all fits, cell and index are sorted as one number.
std::vector<uint32_t> order_of_cells(std::span<const NodeCell> cells, Task& task) {
  const CellBox box(cells);
  const auto row_bits = static_cast<int>(std::bit_width(box.rows())),
             cell_bits = static_cast<int>(std::bit_width(box.columns())) + row_bits,
             index_bits = static_cast<int>(std::bit_width(cells.size()));
  if (cells.size() <= kMostInCache && cell_bits <= 64) return order_of_few(cells, box, row_bits);
  std::vector<uint32_t> order(cells.size());
  if (cell_bits + index_bits <= 64) {
    std::vector<uint64_t> keys(cells.size());
    for (size_t i = 0; i < cells.size(); ++i) {
      const auto column = static_cast<uint64_t>(cells[i].column - box.low.column);
      const auto row = static_cast<uint64_t>(cells[i].row - box.low.row);
      keys[i] = (column << row_bits | row) << index_bits | i;
    }
    serial_sort(task, keys.begin(), keys.end());
    const uint64_t index = (uint64_t{1} << index_bits) - 1;
    for (size_t k = 0; k < keys.size(); ++k) order[k] = static_cast<uint32_t>(keys[k] & index);
    return order;
  }
  std::iota(order.begin(), order.end(), 0u);
  serial_sort(task, order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return cells[a] != cells[b] ? cells[a] < cells[b] : a < b;
  });
  return order;
}

NodeTable::NodeTable(std::span<const NodeCell> cells)
    : cells_(cells), slots_(std::bit_ceil(2 * cells.size() + 1), kNoNode) {
  for (uint32_t node = 0; node < cells.size(); ++node) {
    size_t slot = slot_of(cells[node]);
    while (slots_[slot] != kNoNode) slot = next(slot);
    slots_[slot] = node;
  }
}

NodeBits::NodeBits(std::span<const NodeCell> cells, int64_t margin) {
  const CellBox box(cells);
  const uint64_t most = kMostCellsPerNode * cells.size();
  if (margin > kMostMargin || box.columns() > most || box.rows() > most) return;
  const auto border = 2 * static_cast<uint64_t>(margin);
  if (box.columns() + border > most / (box.rows() + border)) return;
  low_ = {box.low.column - margin, box.low.row - margin};
  rows_ = box.rows() + border;
  words_.assign((box.columns() + border) * rows_ / 64 + 2, 0);
  for (const NodeCell& cell : cells) set(cell);
}

}  // namespace jalon
