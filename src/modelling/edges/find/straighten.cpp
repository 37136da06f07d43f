// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/straighten.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polygon2.h"
#include "modelling/edges/find/edge_line.h"

namespace jalon {

namespace {

// A corner cut by long edges is a run of at most max_edge between two walls; a little more for noise.
constexpr double kChamfer = 1.3;
// Neighbouring lines flatter than this to each other have no useful intersection.
constexpr double kMinCornerSine = 0.35;
// Area may move by this much of perimeter x tolerance before the lines are taken to have gone wrong.
constexpr double kMaxAreaShift = 1.0;

struct Run {
  size_t first = 0, count = 0;  ///< chain points, cyclic
  EdgeLine line;
};

struct Runs {
  std::span<const Vec2> chain;
  const StraightenSetting& setting;
  std::vector<Run> runs;

  Vec2 start(const Run& r) const { return chain[r.first % chain.size()]; }
  Vec2 end(const Run& r) const { return chain[(r.first + r.count - 1) % chain.size()]; }
  double length(const Run& r) const { return norm(end(r) - start(r)); }
  void fit(Run& r) const {
    std::vector<Vec2> points(r.count);
    for (size_t i = 0; i < r.count; ++i) points[i] = chain[(r.first + i) % chain.size()];
    r.line = fit_edge_line(points, setting);
  }
};

// 1. Runs between the Douglas-Peucker corners; neighbours share the corner. The walk starts at a corner.
Runs cut_runs(std::span<const Vec2> chain, const StraightenSetting& setting) {
  Runs out{chain, setting, {}};
  const auto kept = simplified(chain, setting.tolerance_m, true);
  for (size_t k = 0; k < kept.size(); ++k) {
    const size_t from = kept[k], to = k + 1 < kept.size() ? kept[k + 1] : kept[0] + chain.size();
    Run run{from, to - from + 1, {}};
    out.fit(run);
    out.runs.push_back(run);
  }
  return out;
}

// 2. Neighbouring runs on one line become one run.
void merge_collinear(Runs& all) {
  auto& runs = all.runs;
  for (size_t i = 0; i < runs.size() && runs.size() > 3;) {
    Run& a = runs[i];
    const Run& b = runs[(i + 1) % runs.size()];
    const Vec2 joint = all.end(a);
    const bool one_line =
        are_aligned(a.line, b.line) &&
        std::fabs(a.line.distance(joint) - b.line.distance(joint)) <= all.setting.tolerance_m &&
        std::fabs(a.line.distance(all.end(b))) <= 2 * all.setting.tolerance_m;
    if (!one_line) {
      ++i;
      continue;
    }
    a.count += b.count - 1;
    runs.erase(runs.begin() + static_cast<ptrdiff_t>((i + 1) % runs.size()));
    if (i >= runs.size()) i = runs.size() - 1;
    all.fit(runs[i]);
  }
}

// 3. A short run between two longer ones that would meet beside it is a cut corner: the triangulation bridges corners
// by up to an edge.
void drop_chamfers(Runs& all) {
  auto& runs = all.runs;
  const double reach = kChamfer * all.setting.max_edge_m;
  for (size_t i = 0; i < runs.size() && runs.size() > 3;) {
    const Run& a = runs[(i + runs.size() - 1) % runs.size()];
    const Run& b = runs[i];
    const Run& c = runs[(i + 1) % runs.size()];
    const auto corner = intersect(a.line, c.line, kMinCornerSine);
    const double length = all.length(b);
    const bool is_cut = length <= reach && all.length(a) > length && all.length(c) > length &&
                        corner && norm(*corner - all.start(b)) <= reach &&
                        norm(*corner - all.end(b)) <= reach;
    if (is_cut) runs.erase(runs.begin() + static_cast<ptrdiff_t>(i));
    else ++i;
  }
}

// 4. Corners: intersections of neighbours, or a step where two lines run side by side.
Polygon corners_of(const Runs& all) {
  const auto& runs = all.runs;
  const double reach = std::max(3 * all.setting.tolerance_m, kChamfer * all.setting.max_edge_m);
  Polygon out;
  for (size_t i = 0; i < runs.size(); ++i) {
    const Run& a = runs[i];
    const Run& b = runs[(i + 1) % runs.size()];
    const Vec2 from = all.end(a), to = all.start(b);
    const auto corner = intersect(a.line, b.line, kMinCornerSine);
    if (corner && std::min(norm(*corner - from), norm(*corner - to)) <= reach) {
      out.push_back(*corner);
      continue;
    }
    out.push_back(a.line.foot(from));
    out.push_back(b.line.foot(to));
  }
  return out;
}

bool is_sound(std::span<const Vec2> polygon, std::span<const Vec2> chain, double tolerance_m) {
  if (polygon.size() < 3) return false;
  const double area = signed_area(polygon), wanted = signed_area(chain);
  if ((area > 0) != (wanted > 0)) return false;
  // The thinned chain's perimeter is the one that counts: the raw chain zigzags.
  if (std::fabs(area - wanted) > kMaxAreaShift * tolerance_m * perimeter(polygon)) return false;
  return is_simple(polygon);
}

// Starts the chain at the point farthest from another: of a polygon that is always a corner, so no run spans one.
std::vector<Vec2> from_far_corner(std::span<const Vec2> chain) {
  size_t start = 0;
  for (size_t i = 1; i < chain.size(); ++i) {
    const Vec2 here = chain[i] - chain[0], best = chain[start] - chain[0];
    if (dot(here, here) > dot(best, best)) start = i;
  }
  std::vector<Vec2> out(chain.begin(), chain.end());
  std::rotate(out.begin(), out.begin() + static_cast<ptrdiff_t>(start), out.end());
  return out;
}

}  // namespace

Polygon thinned(std::span<const Vec2> chain, double tolerance_m) {
  auto turned = from_far_corner(chain);
  // A coarse polygon may cross itself where the chain runs beside itself: halve the tolerance until it does not.
  for (int attempt = 0; attempt < 4; ++attempt, tolerance_m /= 2) {
    Polygon out;
    for (const uint32_t i : simplified(turned, tolerance_m, true)) out.push_back(turned[i]);
    if (is_sound(out, turned, tolerance_m)) return out;
  }
  return turned;
}

Polygon straightened(std::span<const Vec2> chain, const StraightenSetting& setting) {
  if (chain.size() < 3) return {chain.begin(), chain.end()};
  const auto turned = from_far_corner(chain);
  Runs runs = cut_runs(turned, setting);
  if (runs.runs.size() >= 3) {
    merge_collinear(runs);
    drop_chamfers(runs);
    merge_collinear(runs);
    Polygon out = corners_of(runs);
    if (is_sound(out, turned, setting.tolerance_m + setting.set_back_m)) return out;
  }
  return thinned(chain, setting.tolerance_m);
}

Polygon fitted_rectangle(std::span<const Vec2> chain, const StraightenSetting& setting) {
  constexpr double kOnSides =
      0.92;  // share of the chain that must lie along the sides; cut corners take the rest
  constexpr double kAreaShare = 0.1;  // relative difference of area allowed
  const double near = setting.tolerance_m;
  if (chain.size() < 4) return {};
  // Sides as left, bottom, right, top; start from the box of the chain, then take each side as the median of the points
  // along it.
  std::array<double, 4> side{chain[0].u, chain[0].v, chain[0].u, chain[0].v};
  for (const Vec2& p : chain) {
    side[0] = std::min(side[0], p.u);
    side[1] = std::min(side[1], p.v);
    side[2] = std::max(side[2], p.u);
    side[3] = std::max(side[3], p.v);
  }
  size_t on_sides = 0;
  for (int round = 0; round < 3; ++round) {
    std::array<std::vector<double>, 4> along;
    on_sides = 0;
    for (const Vec2& p : chain) {
      const std::array<double, 4> coordinate{p.u, p.v, p.u, p.v};
      size_t best = 0, close = 0;
      for (size_t k = 0; k < 4; ++k) {
        if (std::fabs(coordinate[k] - side[k]) < std::fabs(coordinate[best] - side[best])) best = k;
        if (std::fabs(coordinate[k] - side[k]) <= near) ++close;
      }
      if (close == 0) continue;
      ++on_sides;
      if (close == 1)
        along[best].push_back(coordinate[best]);  // corners are cut: they say nothing of a side
    }
    for (size_t k = 0; k < 4; ++k) {
      if (along[k].size() < 2) return {};
      side[k] = trimmed_mean(along[k]);
    }
  }
  const double area = (side[2] - side[0]) * (side[3] - side[1]);
  const double wanted = -signed_area(chain);
  if (static_cast<double>(on_sides) < kOnSides * static_cast<double>(chain.size())) return {};
  if (std::fabs(area - wanted) > kAreaShare * wanted + 2 * near * near) return {};
  const double s = setting.set_back_m;
  const double left = side[0] + s, bottom = side[1] + s, right = side[2] - s, top = side[3] - s;
  if (!(left < right && bottom < top)) return {};
  return {{left, bottom}, {left, top}, {right, top}, {right, bottom}};
}

}  // namespace jalon
