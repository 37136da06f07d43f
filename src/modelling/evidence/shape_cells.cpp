// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/shape_cells.h"

#include <vector>

namespace jalon {

namespace {

constexpr double kBesideCells = 2;  // the wall begins this near to a border
constexpr double kStepCells = 0.5;  // along it and away from it
constexpr double kChordCells = 0.2;

// What lies beside a place of the border: wall, the outside, or neither.
enum class Beside { kWall, kRelief, kOutside, kOther };

Beside beside(const WallCells& cells, const Vec2& p, const Vec2& outward) {
  Beside found = Beside::kOther;
  for (double out = 0; out <= kBesideCells; out += kStepCells) {
    const Vec2 q = p + outward * out;
    if (!(q.u >= 0 && q.v >= 0 && q.u < cells.columns && q.v < cells.rows)) return Beside::kOutside;
    const WallState state = cells.at(static_cast<uint32_t>(q.u), static_cast<uint32_t>(q.v));
    if (state == WallState::kOn) return Beside::kWall;
    if (state == WallState::kRelief) return Beside::kRelief;
    if (state == WallState::kOutside) found = Beside::kOutside;
  }
  return found;
}

// f(what lies beside) for places along the sides.
template <class F>
void walk(const WallCells& cells, const OpeningShape& shape, Sides sides, F&& f) {
  const std::vector<Vec2> ring = flattened(shape.ring(), kChordCells);
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], d = ring[(i + 1) % ring.size()] - a;
    const double length = norm(d);
    if (!(length > 0) || (sides == Sides::kSloping && (d.u == 0 || d.v == 0))) continue;
    const Vec2 outward{d.v / length, -d.u / length};
    const auto count = std::max<size_t>(1, static_cast<size_t>(length / kStepCells));
    for (size_t k = 0; k < count; ++k)
      f(beside(cells, a + d * ((static_cast<double>(k) + 0.5) / static_cast<double>(count)),
               outward));
  }
}

}  // namespace

double bordered_share(const WallCells& cells, const OpeningShape& shape, Sides sides) {
  size_t steps = 0, wall = 0;
  walk(cells, shape, sides, [&](Beside there) {
    wall += there == Beside::kWall || there == Beside::kRelief;
    steps += there != Beside::kOutside;
  });
  return steps > 0 ? static_cast<double>(wall) / static_cast<double>(steps) : 1;
}

double relief_share(const WallCells& cells, const OpeningShape& shape) {
  size_t steps = 0, relief = 0;
  walk(cells, shape, Sides::kAll, [&](Beside there) {
    relief += there == Beside::kRelief;
    ++steps;
  });
  return steps > 0 ? static_cast<double>(relief) / static_cast<double>(steps) : 0;
}

}  // namespace jalon
