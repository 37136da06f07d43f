// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/shape_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "modelling/evidence/joined_lights.h"
#include "modelling/evidence/piers.h"
#include "modelling/evidence/shape_cells.h"

namespace jalon {

namespace {

constexpr double kCostOfSize = 1.5;  // of log n
// What naming a circle costs beside a rectangle, which has a size more: of the few cells of a small window that size
// alone would decide. log of 90, as many openings are rectangles for each round one, thrice, as kCostOfSize is thrice
// the half of log n of minimum description length.
constexpr double kCostOfCircle = 13.5;
constexpr double kSeenHead = 0.65;  // of the length of sloping sides
// Of the box's sides, about it: an arch may rise from it; the largest box in a triangle is half as wide and as high.
constexpr double kRoomShare = 0.6, kTriangleRoomShare = 1;
constexpr uint32_t kRoomCells = 6;
constexpr double kTaken = -3;
// A wall that runs through a shape, broader than mullions are and this far within it: as much as ends a box.
constexpr double kCrossingWall = -60, kWithin = 1.5;  // cells
constexpr ShapeKind kOtherKinds[] = {ShapeKind::kTrapezium, ShapeKind::kTriangle, ShapeKind::kGable,
                                     ShapeKind::kArch, ShapeKind::kCircle};
// Steps of the sizes, halved from the first one on: cells; of a triangle as large a part of a box of many cells, for
// its slopes move with the sides of its box.
constexpr double kFirstStep = 8, kLastStep = 0.25, kFirstStepShare = 0.25;

// Weights of the cells about a box, summed along the rows.
class Window {
 public:
  Window(const WallCells& cells, std::span<const uint8_t> taken, const CellBox& box,
         const ShapeWeights& weights) {
    const auto about = [&](double share) {
      const uint32_t by_c = kRoomCells + static_cast<uint32_t>(share * box.width()),
                     by_r = kRoomCells + static_cast<uint32_t>(share * box.height());
      return CellBox{box.c0 > by_c ? box.c0 - by_c : 0, box.r0 > by_r ? box.r0 - by_r : 0,
                     std::min(cells.columns, box.c1 + by_c), std::min(cells.rows, box.r1 + by_r)};
    };
    near_ = about(kRoomShare);
    low_ = about(kTriangleRoomShare);
    stride_ = size_t{low_.width()} + 1;
    sums_.assign(stride_ * low_.height(), 0);
    for (uint32_t r = 0; r < low_.height(); ++r)
      for (uint32_t c = 0; c < low_.width(); ++c) {
        const size_t k = static_cast<size_t>(r + low_.r0) * cells.columns + c + low_.c0;
        const double w = !taken.empty() && taken[k] != 0 ? kTaken : weights.of(cells.states[k]);
        sums_[r * stride_ + c + 1] = sums_[r * stride_ + c] + static_cast<float>(w);
      }
    cost_ =
        kCostOfSize * std::log(std::max(2.0, static_cast<double>(near_.width()) * near_.height()));
  }

  double score(const OpeningShape& shape) const {
    if (!shape.is_valid()) return -INFINITY;
    const RingBox box = shape.box();
    const double from = std::max(box.low.v, static_cast<double>(low_.r0)),
                 to = std::min(box.high.v, static_cast<double>(low_.r1));
    double sum = 0;
    for (double row = std::floor(from); row < to; ++row) {
      const double bottom = std::max(row, from), top = std::min(row + 1, to);
      const Vec2 span = shape.span_at((bottom + top) / 2);
      sum += (top - bottom) * (up_to(row, span.v) - up_to(row, span.u));
    }
    return sum - cost_ * static_cast<double>(shape.size_count()) -
           (shape.kind == ShapeKind::kCircle ? kCostOfCircle : 0);
  }
  bool holds(const OpeningShape& shape) const {
    const CellBox& room = shape.kind == ShapeKind::kTriangle ? low_ : near_;
    const RingBox box = shape.box();
    return box.low.u >= room.c0 && box.low.v >= room.r0 && box.high.u <= room.c1 &&
           box.high.v <= room.r1;
  }

 private:
  // Sum of a row's weights left of u.
  double up_to(double row, double u) const {
    const auto r = static_cast<size_t>(row) - low_.r0;
    const double at = std::clamp(u - low_.c0, 0.0, static_cast<double>(low_.width()));
    const auto c = std::min(static_cast<size_t>(at), static_cast<size_t>(low_.width()) - 1);
    const float *line = &sums_[r * stride_], rest = static_cast<float>(at - static_cast<double>(c));
    return line[c] + rest * (line[c + 1] - line[c]);
  }

  CellBox near_, low_;
  size_t stride_ = 0;
  std::vector<float> sums_;
  double cost_ = 0;
};

// Moves the sizes, one after the other, by halved steps while that gains.
// It keeps the middle of its box: it does not walk to another opening.
FittedShape climbed(const Window& window, OpeningShape start, const Vec2& middle) {
  FittedShape best{start, window.score(start)};
  const RingBox box = start.box();
  double first = kFirstStep;
  while (start.kind == ShapeKind::kTriangle &&
         first < kFirstStepShare * std::max(box.width(), box.height()))
    first *= 2;
  for (double step = first; step >= kLastStep; step /= 2)
    for (bool better = true; better;) {
      better = false;
      for (size_t i = 0; i < start.size_count(); ++i)
        for (const double by : {step, -step}) {
          OpeningShape trial = best.shape;
          trial.sizes[i] += by;
          if (!trial.is_valid() || !window.holds(trial) || !trial.box().holds(middle)) continue;
          const double score = window.score(trial);
          if (score <= best.score) continue;
          best = {trial, score};
          better = true;
        }
    }
  return best;
}

// Where other kinds start from a box that was found. The largest box in a triangle is half as wide and half as high,
// wherever its apex is: over the middle, or over an end as under a verge.
std::vector<OpeningShape> starts_of(ShapeKind kind, const RingBox& box) {
  std::vector<OpeningShape> out{shape_in(kind, box)};
  if (kind != ShapeKind::kTriangle) return out;
  for (const double apex : {0.0, 0.5, 1.0}) {
    const double left = box.low.u - apex * box.width(), right = left + 2 * box.width();
    out.push_back(
        {kind,
         {left, right, box.low.v, box.low.v + 2 * box.height(), left + apex * (right - left), 0}});
  }
  return out;
}

// Of piers too narrow to be broad that part a shape.
size_t pier_cells(const WallCells& cells, const OpeningShape& shape) {
  const RingBox box = shape.box();
  const auto line = [](double at, uint32_t most) {
    return static_cast<uint32_t>(std::clamp(at, 0.0, static_cast<double>(most)));
  };
  CellBox about{line(std::ceil(box.low.u), cells.columns), line(std::ceil(box.low.v), cells.rows),
                0, 0};
  about.c1 = std::max(about.c0, line(box.high.u, cells.columns));
  about.r1 = std::max(about.r0, line(box.high.v, cells.rows));
  if (about.height() == 0) return 0;
  return pier_columns(cells, about).size() * about.height();
}

// Climbing by the few cells of a mullion must not lead across a post into the next bay.
double crossing_wall(const WallCells& cells, const OpeningShape& shape) {
  const OpeningShape within = shape.grown(-kWithin);
  if (!within.is_valid()) return 0;
  const uint32_t side = static_cast<uint32_t>(kMullion_m / cells.cell_m) + 2;  // it touches no more
  const auto is_broad = [&](uint32_t c, uint32_t r) {
    if (c + side > cells.columns || r + side > cells.rows) return false;
    for (uint32_t k = 0; k < side * side; ++k)
      if (cells.at(c + k % side, r + k / side) != WallState::kOn) return false;
    return true;
  };
  double sum = 0;
  for_cells(cells, within, [&](uint32_t c, uint32_t r) {
    if (is_broad(c, r)) sum += kCrossingWall;
  });
  return sum + kCrossingWall * static_cast<double>(pier_cells(cells, within));
}

}  // namespace

bool has_seen_head(const WallCells& cells, const OpeningShape& shape) {
  return bordered_share(cells, shape, Sides::kSloping) >= kSeenHead;
}

FittedShape fitted_shape(const WallCells& cells, std::span<const uint8_t> taken, const CellBox& box,
                         const ShapeWeights& weights, const HeadTest& is_head_seen) {
  const Window window(cells, taken, box, weights);
  const auto number = [](uint32_t n) { return static_cast<double>(n); };
  const RingBox start{{number(box.c0), number(box.r0)}, {number(box.c1), number(box.r1)}};
  const auto climbed_from = [&](const OpeningShape& from) {
    FittedShape fitted = climbed(window, from, start.middle());
    fitted.score += crossing_wall(cells, fitted.shape);
    return fitted;
  };
  const OpeningShape first = shape_in(ShapeKind::kRectangle, start);
  FittedShape best = climbed_from(first);
  if (const FittedShape stays{first, window.score(first) + crossing_wall(cells, first)};
      stays.score > best.score)
    best = stays;
  const RingBox grown = best.shape.box();
  const double straight = best.score;
  for (const ShapeKind kind : kOtherKinds)
    for (const RingBox& box_from : {start, grown})
      for (const OpeningShape& from : starts_of(kind, box_from)) {
        const FittedShape other = climbed_from(from);
        if (other.score > best.score && other.score > weights.clearly * straight &&
            (is_head_seen ? is_head_seen(other.shape) : has_seen_head(cells, other.shape)))
          best = other;
      }
  return best;
}

}  // namespace jalon
