// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/fast_marching_cells.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kFastMarchingCellsGrain = 1 << 12;
constexpr double kFastMarchingCellsMostCells = 0x1p30;  // on an axis

using Number = std::array<int32_t, 3>;

bool before(const Number& a, const Number& b) {
  return a[2] != b[2] ? a[2] < b[2] : a[1] != b[1] ? a[1] < b[1] : a[0] < b[0];
}

std::vector<Number> numbers_of(const VoxelGrid& grid, std::span<const double> xyz, double cell_m,
                               Task& task) {
  std::vector<Number> out(grid.size());
  parallel_for(task, out.size(), kFastMarchingCellsGrain, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v)
      for (size_t c = 0; c < 3; ++c) {
        const double number = std::floor(xyz[3 * size_t{grid.order[grid.first[v]]} + c] / cell_m);
        if (!(std::fabs(number) < kFastMarchingCellsMostCells))
          fail(Status::kLimit, "the cells are too small for the extent of the points");
        out[v][c] = static_cast<int32_t>(number);
      }
  });
  return out;
}

/// One chunk's part of the lists.
struct Part {
  std::vector<uint32_t> counts, around;
};

/// The neighbours of ascending cells in one row of cells ascend too: nine fingers walk the list once.
Part neighbours_of(const std::vector<Number>& cells, size_t begin, size_t end) {
  Part part;
  size_t fingers[9];
  const auto row_start = [&](size_t i, int row) {
    return Number{cells[i][0] - 1, cells[i][1] + row % 3 - 1, cells[i][2] + row / 3 - 1};
  };
  for (int row = 0; row < 9; ++row)
    fingers[row] = static_cast<size_t>(
        std::lower_bound(cells.begin(), cells.end(), row_start(begin, row), before) -
        cells.begin());
  for (size_t i = begin; i < end; ++i) {
    const size_t already = part.around.size();
    for (int row = 0; row < 9; ++row) {
      const Number wanted = row_start(i, row);
      size_t& f = fingers[row];
      while (f < cells.size() && before(cells[f], wanted)) ++f;
      for (size_t j = f; j < cells.size() && cells[j][2] == wanted[2] && cells[j][1] == wanted[1] &&
                         cells[j][0] <= wanted[0] + 2;
           ++j)
        if (j != i) part.around.push_back(static_cast<uint32_t>(j));
    }
    part.counts.push_back(static_cast<uint32_t>(part.around.size() - already));
  }
  return part;
}

}  // namespace

SurfaceCells surface_cells(std::span<const double> xyz, double cell_m, Task& task) {
  SurfaceCells out;
  out.cell_m = cell_m;
  {
    ProgressSpan span(task, 0, 0.6);
    out.grid = voxel_grid(xyz, {0, 0, 0}, cell_m, task);
    out.numbers = numbers_of(out.grid, xyz, cell_m, task);
  }
  ProgressSpan span(task, 0.6, 1);
  std::vector<Part> parts((out.size() + kFastMarchingCellsGrain - 1) / kFastMarchingCellsGrain);
  parallel_for(task, out.size(), kFastMarchingCellsGrain, [&](size_t begin, size_t end) {
    parts[begin / kFastMarchingCellsGrain] = neighbours_of(out.numbers, begin, end);
  });
  out.first.assign(1, 0);
  for (Part& part : parts) {
    for (const uint32_t count : part.counts) out.first.push_back(out.first.back() + count);
    out.around.insert(out.around.end(), part.around.begin(), part.around.end());
    part = {};
  }
  return out;
}

}  // namespace jalon
