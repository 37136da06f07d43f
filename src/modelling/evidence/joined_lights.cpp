// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/joined_lights.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace jalon {

namespace {

constexpr double kBorderCells =
    0.9;  // both borders together: shapes end where a cell has a point of the wall
constexpr double kMullionShare = 0.3;                // of the narrower light
constexpr double kSameCells = 2, kSameShare = 0.08;  // feet and heads: of the lights' height

// Sizes of a rectangle: along = 0 for lights side by side (left, right), 2 for one over the other (foot, head).
std::optional<OpeningShape> joined(const OpeningShape& a, const OpeningShape& b, size_t along,
                                   double cell_m) {
  const size_t across = 2 - along;
  const double gap = b.sizes[along] - a.sizes[along + 1];
  const double least =
      std::min(a.sizes[along + 1] - a.sizes[along], b.sizes[along + 1] - b.sizes[along]);
  const double tall =
      std::max(a.sizes[across + 1] - a.sizes[across], b.sizes[across + 1] - b.sizes[across]);
  const double same = std::max(kSameCells, kSameShare * tall);
  const double bar = gap - kBorderCells;
  if (gap < -kSameCells || least * cell_m > kMostLight_m || bar * cell_m > kMullion_m ||
      bar > kMullionShare * (least + kBorderCells) ||
      std::fabs(a.sizes[across] - b.sizes[across]) > same ||
      std::fabs(a.sizes[across + 1] - b.sizes[across + 1]) > same)
    return {};
  OpeningShape out = a;
  out.sizes[along + 1] = b.sizes[along + 1];
  out.sizes[across] = std::min(a.sizes[across], b.sizes[across]);
  out.sizes[across + 1] = std::max(a.sizes[across + 1], b.sizes[across + 1]);
  return out;
}

bool join_one(std::vector<OpeningShape>& shapes, double cell_m) {
  for (size_t a = 0; a < shapes.size(); ++a)
    for (size_t b = 0; b < shapes.size(); ++b) {
      if (a == b || shapes[a].kind != ShapeKind::kRectangle ||
          shapes[b].kind != ShapeKind::kRectangle)
        continue;
      for (const size_t along : {size_t{0}, size_t{2}})
        if (const auto both = joined(shapes[a], shapes[b], along, cell_m)) {
          shapes[a] = *both;
          shapes.erase(shapes.begin() + static_cast<ptrdiff_t>(b));
          return true;
        }
    }
  return false;
}

}  // namespace

std::vector<OpeningShape> joined_lights(std::vector<OpeningShape> shapes, double cell_m) {
  while (join_one(shapes, cell_m)) {
  }
  return shapes;
}

}  // namespace jalon
