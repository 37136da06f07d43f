// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/piers.h"

#include <cmath>

#include "modelling/evidence/joined_lights.h"

namespace jalon {

namespace {

// Of a pier's cells, in two columns together: as many as keep_squares of cell_classes.cpp asks of a pier.
constexpr double kPierColumn = 0.8;

bool is_pier_cell(WallState state) { return state == WallState::kOn || state == WallState::kStrip; }

}  // namespace

std::vector<uint32_t> pier_columns(const WallCells& cells, const CellBox& box) {
  std::vector<uint32_t> out;
  const auto light = static_cast<uint32_t>(std::ceil(kMostLight_m / cells.cell_m));
  if (box.width() < 2 * light + 2) return out;
  for (uint32_t c = box.c0 + light; c + 1 + light < box.c1; ++c) {
    uint32_t wall = 0;
    for (uint32_t r = box.r0; r < box.r1; ++r)
      wall += is_pier_cell(cells.at(c, r)) || is_pier_cell(cells.at(c + 1, r));
    if (wall >= kPierColumn * box.height()) out.push_back(c);
  }
  return out;
}

CellBox beside_pier(const WallCells& cells, const CellBox& box) {
  const std::vector<uint32_t> piers = pier_columns(cells, box);
  if (piers.empty()) return box;
  CellBox left = box, right = box;
  left.c1 = piers.front();
  right.c0 = piers.front() + 2;
  return left.width() >= right.width() ? left : right;
}

}  // namespace jalon
