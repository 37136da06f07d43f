// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/patterns/place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/polygon2.h"

namespace jalon {

namespace {

constexpr int kMostIterations = 60;
constexpr double kSettled_m = 1e-5;
constexpr double kFirstReach = 4;        // reaches: the first iterations pull from farther away
constexpr double kMostTurn_rad = 0.035;  // 2 degrees: builders set windows upright
constexpr double kProof = 9;             // square of 3 sigma by which a turn must better the fit
constexpr double kFacing = 0.8;          // cosine of a side's normal: within 37 degrees of an axis

/// The nearest place of a form's border.
struct Foot {
  Vec2 at, outward;   ///< unit
  double distance_m;  ///< positive outside
};

Foot foot_on(std::span<const Vec2> form, const Vec2& p) {
  Foot best{{}, {}, std::numeric_limits<double>::infinity()};
  for (size_t i = 0; i < form.size(); ++i) {
    const Vec2 &a = form[i], ab = form[(i + 1) % form.size()] - a;
    const double squared = dot(ab, ab);
    if (!(squared > 0)) continue;
    const Vec2 q = a + ab * std::clamp(dot(p - a, ab) / squared, 0.0, 1.0);
    const double d = norm(p - q);
    if (d < best.distance_m) best = {q, Vec2{ab.v, -ab.u} * (1 / std::sqrt(squared)), d};
  }
  const Vec2 off = p - best.at;
  const bool inside = contains(form, p);
  // Off a corner the way outward is that to the point itself.
  if (best.distance_m > kSettled_m) best.outward = off * ((inside ? -1 : 1) / best.distance_m);
  if (inside) best.distance_m = -best.distance_m;
  return best;
}

/// Border points and where the form says that they should lie, both in the plane of the wall.
struct Pairs {
  std::vector<Vec2> wanted, measured;
  std::vector<Foot> feet;
};

Pairs pair_up(std::span<const Vec2> form, double set_back_m, std::span<const Vec2> border,
              const Motion2& motion, double reach_m) {
  Pairs out;
  for (const Vec2& b : border) {
    const Foot foot = foot_on(form, motion.origin_of(b));
    if (std::fabs(foot.distance_m - set_back_m) > reach_m) continue;
    out.wanted.push_back(foot.at + foot.outward * set_back_m);
    out.measured.push_back(b);
    out.feet.push_back(foot);
  }
  return out;
}

Vec2 mean_of(std::span<const Vec2> points) {
  Vec2 sum;
  for (const Vec2& p : points) sum = sum + p;
  return sum * (1 / static_cast<double>(points.size()));
}

/// The rigid motion of least squares that takes wanted to measured; without turning when told so.
Motion2 procrustes(const Pairs& pairs, const Vec2& pivot, bool may_turn) {
  const Vec2 w = mean_of(pairs.wanted), m = mean_of(pairs.measured);
  double c = 0, s = 0;
  for (size_t i = 0; may_turn && i < pairs.wanted.size(); ++i) {
    c += dot(pairs.wanted[i] - w, pairs.measured[i] - m);
    s += cross(pairs.wanted[i] - w, pairs.measured[i] - m);
  }
  Motion2 out{
      pivot, {}, may_turn ? std::clamp(std::atan2(s, c), -kMostTurn_rad, kMostTurn_rad) : 0};
  out.shift = m - out.point(w);
  return out;
}

struct Fit {
  Motion2 motion;
  Pairs pairs;
  double squares = 0;
};

Fit iterate(std::span<const Vec2> form, double set_back_m, std::span<const Vec2> border,
            Motion2 motion, double reach_m, bool may_turn) {
  for (int i = 0; i < kMostIterations; ++i) {
    const double reach = reach_m * std::max(1.0, kFirstReach - i);
    const Pairs pairs = pair_up(form, set_back_m, border, motion, reach);
    if (pairs.wanted.size() < 2) break;
    const Motion2 next = procrustes(pairs, motion.pivot, may_turn);
    const double step =
        norm(next.shift - motion.shift) + std::fabs(next.turn_rad - motion.turn_rad);
    motion = next;
    if (step < kSettled_m && reach == reach_m) break;
  }
  Fit fit{motion, pair_up(form, set_back_m, border, motion, reach_m), 0};
  for (const Foot& foot : fit.pairs.feet) fit.squares += std::pow(foot.distance_m - set_back_m, 2);
  return fit;
}

}  // namespace

Vec2 Motion2::point(const Vec2& p) const {
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  const Vec2 d = p - pivot;
  return pivot + shift + Vec2{c * d.u - s * d.v, s * d.u + c * d.v};
}

Vec2 Motion2::origin_of(const Vec2& p) const {
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  const Vec2 d = p - pivot - shift;
  return pivot + Vec2{c * d.u + s * d.v, c * d.v - s * d.u};
}

VectorRing moved(const VectorRing& ring, const Motion2& motion) {
  VectorRing out = ring;
  for (Vec2& corner : out.corners) corner = motion.point(corner);
  out.contour.clear();  // those points lie where it came from
  return out;
}

Placement place_on_border(std::span<const Vec2> form, double set_back_m,
                          std::span<const Vec2> border, const Vec2& start, double reach_m,
                          bool may_turn) {
  Placement out;
  out.motion = {mean_of(form), start, 0};
  Fit fit = iterate(form, set_back_m, border, out.motion, reach_m, false);
  const Fit turned = may_turn ? iterate(form, set_back_m, border, fit.motion, reach_m, true) : fit;
  // A turn is proven when it betters the sum of squares by more than chance, of no fewer points.
  const auto n = static_cast<double>(turned.pairs.feet.size());
  const bool as_many = turned.pairs.feet.size() >= fit.pairs.feet.size();
  if (as_many && n > 3 && (fit.squares - turned.squares) * (n - 3) > kProof * turned.squares)
    fit = turned;
  out.motion = fit.motion;
  out.support = fit.pairs.feet.size();
  out.residual_m =
      out.support > 0 ? std::sqrt(fit.squares / static_cast<double>(out.support)) : reach_m;
  const auto all = static_cast<double>(border.size()), off = all - static_cast<double>(out.support);
  out.cost_m2 = all > 0 ? (fit.squares + off * reach_m * reach_m) / all : reach_m * reach_m;
  for (const Foot& foot : fit.pairs.feet) {
    const bool faces[] = {foot.outward.u<-kFacing, foot.outward.u> kFacing,
                          foot.outward.v<-kFacing, foot.outward.v> kFacing};
    for (size_t s = 0; s < 4; ++s)
      if (faces[s]) ++out.sides[s], out.offsets_m[s] += foot.distance_m - set_back_m;
  }
  for (size_t s = 0; s < 4; ++s)
    if (out.sides[s] > 0) out.offsets_m[s] /= static_cast<double>(out.sides[s]);
  return out;
}

double cost_in_place(std::span<const Vec2> form, std::span<const Vec2> border, double reach_m) {
  std::vector<double> distances;
  for (const Vec2& p : border) distances.push_back(foot_on(form, p).distance_m);
  if (distances.empty()) return reach_m * reach_m;
  const auto middle = distances.begin() + static_cast<ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  const double set_back_m = *middle;
  double sum = 0;
  for (const double d : distances) sum += std::min(std::pow(d - set_back_m, 2), reach_m * reach_m);
  return sum / static_cast<double>(distances.size());
}

double mean_distance(std::span<const Vec2> form, std::span<const Vec2> points) {
  double sum = 0;
  for (const Vec2& p : points) sum += foot_on(form, p).distance_m;
  return points.empty() ? 0 : sum / static_cast<double>(points.size());
}

CellCount count_cells(const WallMap& map, std::span<const Vec2> form, double margin_m) {
  CellCount out;
  if (map.cells.empty() || form.empty()) return out;
  Vec2 low = form[0], high = form[0];
  for (const Vec2& p : form) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  const auto index = [&](double at, double origin) {
    return std::floor((at - origin) / map.cell_m);
  };
  for (double r = index(low.v, map.origin.v); r <= index(high.v, map.origin.v); ++r)
    for (double c = index(low.u, map.origin.u); c <= index(high.u, map.origin.u); ++c) {
      const Vec2 middle = map.origin + Vec2{c + 0.5, r + 0.5} * map.cell_m;
      if (contains(form, middle) && border_distance(form, middle) >= margin_m)
        ++out.of[static_cast<size_t>(map.at(middle))];
    }
  return out;
}

}  // namespace jalon
