// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/point_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "modelling/evidence/shape_fit.h"

namespace jalon {

namespace {

constexpr double kFineSpacings = 0.5;
constexpr double kMostFineCells = 3e5;  // openings of many spacings are told by coarser cells
// About a shape: the room that a fit looks at, an arch over a box that ends at its springing line.
constexpr double kWindowShare = 0.6, kWindowCells = 3;
constexpr double kStray = 0.01;  // of the points of a wall, as many in an opening: mixed pixels
// What coarse cells without a point of the wall say, in parts of what was seen through: as ShapeWeights has them.
constexpr double kHiddenSays = 0.05, kProudSays = -1, kStripSays = -1.5, kOutsideSays = -0.25;

// Weights of a cell with this many points of a wall expected in it, in nats.
ShapeWeights weights_for(double expected) {
  ShapeWeights out;
  out.on = out.relief = std::log(kStray * expected / -std::expm1(-expected));
  out.through = out.deep = out.empty = expected * (1 - kStray);
  out.hidden = kHiddenSays * out.through;
  out.proud = kProudSays * out.through;
  out.strip = kStripSays * out.through;
  out.outside = kOutsideSays * out.through;
  out.clearly = 1;  // likelihoods and the cost of sizes say it all
  return out;
}

// What coarse cells say of places without a point of the wall. Where they have such points these say where it is: in
// strips too, of the wall between a window and the panel below it; other strips are of frames and leaves.
class CoarseStates {
 public:
  CoarseStates(const WallCells& cells, std::span<const Vec2> solid) : cells_(cells) {
    for (const Vec2& p : solid)
      if (const auto k = index_of(p); k && cells.states[*k] == WallState::kStrip)
        own_strips_.push_back(*k);
    std::sort(own_strips_.begin(), own_strips_.end());
  }
  WallState at(const Vec2& p) const {
    const auto k = index_of(p);
    if (!k) return WallState::kOutside;
    const WallState state = cells_.states[*k];
    const bool is_own =
        is_wall(state) || (state == WallState::kStrip &&
                           std::binary_search(own_strips_.begin(), own_strips_.end(), *k));
    return is_own ? WallState::kThrough : state;
  }

 private:
  std::optional<size_t> index_of(const Vec2& p) const {
    const double c = (p.u - cells_.origin.u) / cells_.cell_m,
                 r = (p.v - cells_.origin.v) / cells_.cell_m;
    if (!(c >= 0 && r >= 0 && c < cells_.columns && r < cells_.rows)) return {};
    return static_cast<size_t>(r) * cells_.columns + static_cast<size_t>(c);
  }

  const WallCells& cells_;
  std::vector<size_t> own_strips_;
};

// The window in cells of about half a spacing.
WallCells fine_cells(const RingBox& window, const WallCells& cells, std::span<const Vec2> solid) {
  WallCells out;
  out.origin = window.low;
  out.spacing_m = cells.spacing_m;
  out.cell_m = std::max(kFineSpacings * cells.spacing_m,
                        std::sqrt(window.width() * window.height() / kMostFineCells));
  out.columns = static_cast<uint32_t>(std::ceil(window.width() / out.cell_m));
  out.rows = static_cast<uint32_t>(std::ceil(window.height() / out.cell_m));
  const CoarseStates coarse(cells, solid);
  out.states.reserve(size_t{out.columns} * out.rows);
  for (uint32_t r = 0; r < out.rows; ++r)
    for (uint32_t c = 0; c < out.columns; ++c)
      out.states.push_back(coarse.at(out.origin + Vec2{c + 0.5, r + 0.5} * out.cell_m));
  for (const Vec2& p : solid) {
    const double c = (p.u - out.origin.u) / out.cell_m, r = (p.v - out.origin.v) / out.cell_m;
    if (c >= 0 && r >= 0 && c < out.columns && r < out.rows)
      out.states[static_cast<size_t>(r) * out.columns + static_cast<size_t>(c)] = WallState::kOn;
  }
  return out;
}

CellBox box_in(const RingBox& box, const WallCells& fine) {
  const auto line = [&](double at, double origin, uint32_t most) {
    return static_cast<uint32_t>(
        std::clamp(std::round((at - origin) / fine.cell_m), 0.0, static_cast<double>(most)));
  };
  CellBox out{line(box.low.u, fine.origin.u, fine.columns - 1),
              line(box.low.v, fine.origin.v, fine.rows - 1), 0, 0};
  out.c1 = std::max(out.c0 + 1, line(box.high.u, fine.origin.u, fine.columns));
  out.r1 = std::max(out.r0 + 1, line(box.high.v, fine.origin.v, fine.rows));
  return out;
}

}  // namespace

RingBox fitting_window(const OpeningShape& shape, const WallCells& cells) {
  RingBox out = shape.box();
  const double room = kWindowCells * cells.cell_m;
  const Vec2 by{kWindowShare * out.width() + room, kWindowShare * out.height() + room};
  out.low = out.low - by;
  out.high = out.high + by;
  return out;
}

OpeningShape fitted_to_points(const OpeningShape& shape, const WallCells& cells,
                              std::span<const Vec2> solid) {
  const WallCells fine = fine_cells(fitting_window(shape, cells), cells, solid);
  const double spacings = fine.cell_m / fine.spacing_m;
  const auto is_head_seen = [&](const OpeningShape& fitted) {
    const OpeningShape coarse = fitted.placed(fine.cell_m, fine.origin - cells.origin);
    return has_seen_head(cells, coarse.placed(1 / cells.cell_m, {}));
  };
  const FittedShape fitted = fitted_shape(fine, {}, box_in(shape.box(), fine),
                                          weights_for(spacings * spacings), is_head_seen);
  return fitted.shape.placed(fine.cell_m, fine.origin);
}

}  // namespace jalon
