// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/shape_cells.h"

#include <vector>

namespace jalon {

namespace {

constexpr double kBesideCells = 2;  // the wall begins this near to a border
constexpr double kStepCells = 0.5;  // along it and away from it
constexpr double kChordCells = 0.2;
constexpr double kAcross = 0.7;  // sine of 45 degrees: sides that look up or down
// Of wall, one after the other, broader than what stands at a border by itself: three cells, or as many as a brick is
// long where these are more; the piers of a dormer are little broader.
constexpr double kBrick_m = 0.24;
constexpr int kFrameCells = 3, kLeastFrameCells = 2;
constexpr double kFrame_m = 0.5;  // surrounds and sills are narrower

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

// Whether the wall lies beyond a place of the border, within a surround's width.
bool is_framed(const WallCells& cells, const Vec2& p, const Vec2& outward) {
  const int broad = std::clamp(static_cast<int>(std::ceil(kBrick_m / cells.cell_m)),
                               kLeastFrameCells, kFrameCells);
  const auto reach = static_cast<int>(kBesideCells + kFrame_m / cells.cell_m) + broad;
  int on = 0;
  for (int out = 0; out < reach; ++out) {
    const Vec2 q = p + outward * (out + kStepCells);
    if (!(q.u >= 0 && q.v >= 0 && q.u < cells.columns && q.v < cells.rows)) return false;
    const bool is_on =
        cells.at(static_cast<uint32_t>(q.u), static_cast<uint32_t>(q.v)) == WallState::kOn;
    on = is_on ? on + 1 : 0;
    if (on == broad) return true;
  }
  return false;
}

// f(place, outward) for places along the sides.
template <class F>
void walk(const OpeningShape& shape, Sides sides, F&& f) {
  const std::vector<Vec2> ring = flattened(shape.ring(), kChordCells);
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], d = ring[(i + 1) % ring.size()] - a;
    const double length = norm(d);
    if (!(length > 0) || (sides == Sides::kSloping && (d.u == 0 || d.v == 0)) ||
        (sides == Sides::kSteep && std::fabs(d.u) >= std::fabs(d.v)))
      continue;
    const Vec2 outward{d.v / length, -d.u / length};
    const auto count = std::max<size_t>(1, static_cast<size_t>(length / kStepCells));
    for (size_t k = 0; k < count; ++k)
      f(a + d * ((static_cast<double>(k) + 0.5) / static_cast<double>(count)), outward);
  }
}

}  // namespace

double bordered_share(const WallCells& cells, const OpeningShape& shape, Sides sides) {
  size_t steps = 0, wall = 0;
  walk(shape, sides, [&](const Vec2& p, const Vec2& outward) {
    const Beside there = beside(cells, p, outward);
    wall += there == Beside::kWall || there == Beside::kRelief;
    steps += there != Beside::kOutside;
  });
  return steps > 0 ? static_cast<double>(wall) / static_cast<double>(steps) : 1;
}

double framed_share(const WallCells& cells, const OpeningShape& shape, Sides sides) {
  size_t steps = 0, framed = 0;
  walk(shape, sides, [&](const Vec2& p, const Vec2& outward) {
    if (outward.v < 0 && beside(cells, p, outward) == Beside::kOutside) return;  // on the ground
    framed += is_framed(cells, p, outward);
    ++steps;
  });
  return steps > 0 ? static_cast<double>(framed) / static_cast<double>(steps) : 0;
}

OpenEnds open_ends(const WallCells& cells, const OpeningShape& shape) {
  size_t steps[4] = {0, 0, 0, 0}, outside[4] = {0, 0, 0, 0};  // foot, head, left, right
  walk(shape, Sides::kAll, [&](const Vec2& p, const Vec2& outward) {
    const size_t end = std::fabs(outward.v) < kAcross ? 2 + (outward.u > 0) : outward.v > 0;
    ++steps[end];
    outside[end] += beside(cells, p, outward) == Beside::kOutside;
  });
  const auto is_open = [&](size_t end) { return 2 * outside[end] > steps[end]; };
  return {is_open(1), is_open(0), is_open(2), is_open(3)};
}

double relief_share(const WallCells& cells, const OpeningShape& shape) {
  size_t steps = 0, relief = 0;
  walk(shape, Sides::kAll, [&](const Vec2& p, const Vec2& outward) {
    relief += beside(cells, p, outward) == Beside::kRelief;
    ++steps;
  });
  return steps > 0 ? static_cast<double>(relief) / static_cast<double>(steps) : 0;
}

}  // namespace jalon
