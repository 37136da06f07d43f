// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/joined_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

namespace jalon {

namespace {

constexpr double kBorderCells =
    0.9;  // both borders together: shapes end where a cell has a point of the wall
constexpr double kMullionShare = 0.3;                // of the narrower light
constexpr double kSameCells = 2, kSameShare = 0.08;  // feet and heads: of the lights' height
// A pier of bricks is no narrower than half a brick, 11.5 cm and a joint: kPier_m of cell_classes.cpp.
constexpr double kHalfBrick_m = 0.12;
// Of the lines of cells between two lights that a pier crosses: as much as tell_strips of cell_classes.cpp asks of a
// pier's square. The other fifth of them may reach beyond its edges: with a stray point, or by noise.
constexpr double kPierLines = 0.8;

// Piers part windows of a wall that goes on beside them, broader than they are; posts of a timber frame are as broad as
// each other, and what lies between them are its panels.
constexpr double kBroader = 1.5;

// First and last of the wall's points in a cell along one axis, in cells; none: first > last.
struct Ends {
  float first = 1, last = 0;
  void add(float at) {
    first = first > last ? at : std::min(first, at);
    last = std::max(last, at);
  }
};

// How broad the wall is between two lights. Cells of 2.2 spacings do not tell a mullion flush with the wall from half a
// brick, for both touch two or three; the points of all lines of cells together do to a fraction of a spacing.
class Bars {
 public:
  Bars(const WallCells& cells, const WallPoints& points) : cells_(cells), points_(points) {}

  // Sizes as in joined().
  double width_m(const OpeningShape& a, const OpeningShape& b, size_t along) {
    const size_t across = 2 - along;
    const uint32_t most = along == 0 ? cells_.columns : cells_.rows,
                   most_lines = along == 0 ? cells_.rows : cells_.columns;
    const uint32_t from = line(std::floor(a.sizes[along + 1]), most),
                   to = line(std::ceil(b.sizes[along]), most);
    const uint32_t begin = line(std::round(std::max(a.sizes[across], b.sizes[across])), most_lines);
    const uint32_t end =
        line(std::round(std::min(a.sizes[across + 1], b.sizes[across + 1])), most_lines);
    if (begin >= end) return 0;
    const std::vector<Ends>& ends = ends_along(along);
    std::vector<float> firsts, lasts;
    for (uint32_t l = begin; l < end; ++l) {
      Ends bar;
      for (uint32_t at = from; at < to; ++at) {
        const size_t k =
            along == 0 ? size_t{l} * cells_.columns + at : size_t{at} * cells_.columns + l;
        if (cells_.states[k] != WallState::kOn || ends[k].first > ends[k].last) continue;
        bar.add(static_cast<float>(at) + ends[k].first);
        bar.add(static_cast<float>(at) + ends[k].last);
      }
      if (bar.first > bar.last) continue;
      firsts.push_back(bar.first);
      lasts.push_back(bar.last);
    }
    if (static_cast<double>(firsts.size()) < kPierLines * (end - begin)) return 0;
    const auto rank = static_cast<ptrdiff_t>((1 - kPierLines) * static_cast<double>(firsts.size()));
    std::nth_element(firsts.begin(), firsts.begin() + rank, firsts.end());
    std::nth_element(lasts.begin(), lasts.begin() + rank, lasts.end(), std::greater<>());
    return (lasts[static_cast<size_t>(rank)] - firsts[static_cast<size_t>(rank)]) * cells_.cell_m;
  }

 private:
  static uint32_t line(double at, uint32_t most) {
    return static_cast<uint32_t>(std::clamp(at, 0.0, static_cast<double>(most)));
  }
  const std::vector<Ends>& ends_along(size_t along) {
    std::vector<Ends>& ends = ends_[along / 2];
    if (!ends.empty()) return ends;
    ends.assign(cells_.states.size(), points_.cloud != nullptr ? Ends{} : Ends{0, 1});
    for (const uint32_t i : points_.indices) {
      const Vec3 p = points_.cloud->point(i);
      const double w = dot(p - cells_.frame.origin, cells_.frame.normal) - cells_.frame.height;
      const Vec2 at = (cells_.frame.project(p) - cells_.origin) * (1 / cells_.cell_m);
      if (std::fabs(w) > cells_.on_m || !(at.u >= 0 && at.v >= 0) || at.u >= cells_.columns ||
          at.v >= cells_.rows)
        continue;
      const double on_axis = along == 0 ? at.u : at.v;
      ends[static_cast<size_t>(at.v) * cells_.columns + static_cast<size_t>(at.u)].add(
          static_cast<float>(on_axis - std::floor(on_axis)));
    }
    return ends;
  }

  const WallCells& cells_;
  const WallPoints& points_;
  std::array<std::vector<Ends>, 2>
      ends_;  // along rows and along columns, from when they are first asked for
};

double most_apart(const OpeningShape& a, const OpeningShape& b, size_t across) {
  return std::max(std::fabs(a.sizes[across] - b.sizes[across]),
                  std::fabs(a.sizes[across + 1] - b.sizes[across + 1]));
}

double same_within(const OpeningShape& a, const OpeningShape& b, size_t across) {
  return std::max(kSameCells, kSameShare * std::max(a.sizes[across + 1] - a.sizes[across],
                                                    b.sizes[across + 1] - b.sizes[across]));
}

// Cells of the wall beyond a light's last side (its first one), one after the other: the median of its lines of cells.
uint32_t wall_beyond(const WallCells& cells, const OpeningShape& light, size_t along,
                     bool is_last) {
  const size_t across = 2 - along;
  const auto at = [&](int64_t on_axis, int64_t line) {
    const int64_t c = along == 0 ? on_axis : line, r = along == 0 ? line : on_axis;
    return c >= 0 && r >= 0 && c < cells.columns && r < cells.rows &&
           is_wall(cells.at(static_cast<uint32_t>(c), static_cast<uint32_t>(r)));
  };
  const auto side = static_cast<int64_t>(is_last ? std::floor(light.sizes[along + 1])
                                                 : std::ceil(light.sizes[along]) - 1);
  std::vector<uint32_t> runs;
  for (auto line = static_cast<int64_t>(std::round(light.sizes[across]));
       line < static_cast<int64_t>(std::round(light.sizes[across + 1])); ++line) {
    const int64_t step = is_last ? 1 : -1;
    int64_t from = at(side, line) ? side : side + step, to = from;
    while (at(to, line)) to += step;
    runs.push_back(static_cast<uint32_t>(std::abs(to - from)));
  }
  if (runs.empty()) return 0;
  const auto middle = runs.begin() + static_cast<ptrdiff_t>(runs.size() / 2);
  std::nth_element(runs.begin(), middle, runs.end());
  return *middle;
}

// Whether beyond a row of lights, whatever bars part them, the wall is broader than this bar.
bool ends_at_wall(const std::vector<OpeningShape>& shapes, const WallCells& cells,
                  const OpeningShape* light, size_t along, bool is_last, double bar_m) {
  for (size_t lights = 0; light != nullptr && lights < shapes.size(); ++lights) {
    const uint32_t wall = wall_beyond(cells, *light, along, is_last);
    if (wall * cells.cell_m >= kBroader * bar_m + cells.cell_m) return true;
    const auto gap_to = [&](const OpeningShape& next) {
      return is_last ? next.sizes[along] - light->sizes[along + 1]
                     : light->sizes[along] - next.sizes[along + 1];
    };
    const auto next = std::find_if(shapes.begin(), shapes.end(), [&](const OpeningShape& shape) {
      const size_t across = 2 - along;
      return &shape != light && shape.kind == ShapeKind::kRectangle &&
             gap_to(shape) >= -kSameCells && gap_to(shape) <= wall + kSameCells &&
             most_apart(shape, *light, across) <= same_within(shape, *light, across);
    });
    light = next != shapes.end() ? &*next : nullptr;
  }
  return false;
}

// Whether a pier of the wall stands between two lights, a before b.
bool is_pier_between(const std::vector<OpeningShape>& shapes, const OpeningShape& a,
                     const OpeningShape& b, size_t along, const WallCells& cells, Bars& bars) {
  const double bar_m = bars.width_m(a, b, along);
  return bar_m >= kHalfBrick_m && ends_at_wall(shapes, cells, &a, along, false, bar_m) &&
         ends_at_wall(shapes, cells, &b, along, true, bar_m);
}

// Sizes of a rectangle: along = 0 for lights side by side (left, right), 2 for one over the other (foot, head).
std::optional<OpeningShape> joined(const OpeningShape& a, const OpeningShape& b, size_t along,
                                   double cell_m) {
  const size_t across = 2 - along;
  const double gap = b.sizes[along] - a.sizes[along + 1];
  const double least =
      std::min(a.sizes[along + 1] - a.sizes[along], b.sizes[along + 1] - b.sizes[along]);
  const double bar = gap - kBorderCells;
  if (gap < -kSameCells || least * cell_m > kMostLight_m || bar * cell_m > kMullion_m ||
      bar > kMullionShare * (least + kBorderCells) ||
      most_apart(a, b, across) > same_within(a, b, across))
    return {};
  OpeningShape out = a;
  out.sizes[along + 1] = b.sizes[along + 1];
  out.sizes[across] = std::min(a.sizes[across], b.sizes[across]);
  out.sizes[across + 1] = std::max(a.sizes[across + 1], b.sizes[across + 1]);
  return out;
}

bool join_one(std::vector<OpeningShape>& shapes, const WallCells& cells, Bars& bars) {
  for (size_t a = 0; a < shapes.size(); ++a)
    for (size_t b = 0; b < shapes.size(); ++b) {
      if (a == b || shapes[a].kind != ShapeKind::kRectangle ||
          shapes[b].kind != ShapeKind::kRectangle)
        continue;
      for (const size_t along : {size_t{0}, size_t{2}}) {
        const auto both = joined(shapes[a], shapes[b], along, cells.cell_m);
        if (!both || is_pier_between(shapes, shapes[a], shapes[b], along, cells, bars)) continue;
        shapes[a] = *both;
        shapes.erase(shapes.begin() + static_cast<ptrdiff_t>(b));
        return true;
      }
    }
  return false;
}

}  // namespace

std::vector<OpeningShape> joined_lights(std::vector<OpeningShape> shapes, const WallCells& cells,
                                        const WallPoints& points) {
  Bars bars(cells, points);
  while (join_one(shapes, cells, bars)) {
  }
  return shapes;
}

}  // namespace jalon
