// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/edge_line.h"

#include <algorithm>
#include <cmath>

#include "modelling/edges/find/straighten.h"

namespace jalon {

namespace {

constexpr double kAligned = 0.087155742747658166;  // sine of 5 degrees
constexpr double kMaxSnap_rad = 0.26;  // 15 degrees, for edges so short that noise turns them

// Points of the run that lie further than the cut corners reach from both ends; all of them when few would be left.
std::vector<Vec2> without_ends(std::span<const Vec2> points, double reach) {
  const Vec2 a = points.front(), b = points.back();
  const double length = norm(b - a);
  if (!(length > 0)) return {points.begin(), points.end()};
  const Vec2 direction = (b - a) * (1 / length);
  reach = std::min(reach, length / 4);
  std::vector<Vec2> kept;
  for (const Vec2& p : points) {
    const double along = dot(p - a, direction);
    if (along >= reach && along <= length - reach) kept.push_back(p);
  }
  if (kept.size() < 3) return {points.begin(), points.end()};
  return kept;
}

EdgeLine least_squares_line(std::span<const Vec2> points, const Vec2& toward) {
  const Vec2 reference = points.front();
  double n = 0, su = 0, sv = 0, suu = 0, suv = 0, svv = 0;
  for (const Vec2& p : points) {
    const Vec2 d = p - reference;
    n += 1;
    su += d.u;
    sv += d.v;
    suu += d.u * d.u;
    suv += d.u * d.v;
    svv += d.v * d.v;
  }
  const Vec2 mean{su / n, sv / n};
  const double cuu = suu / n - mean.u * mean.u, cuv = suv / n - mean.u * mean.v,
               cvv = svv / n - mean.v * mean.v;
  const double angle = 0.5 * std::atan2(2 * cuv, cuu - cvv);
  EdgeLine line{reference + mean, {std::cos(angle), std::sin(angle)}};
  if (dot(line.direction, toward) < 0) line.direction = line.direction * -1;
  return line;
}

void drop_outliers(std::vector<Vec2>& points, const EdgeLine& line) {
  constexpr double kTimesMedian = 3.7;  // 2.5 sigma of a Gaussian
  std::vector<double> sizes;
  for (const Vec2& p : points) sizes.push_back(std::fabs(line.distance(p)));
  const auto middle = sizes.begin() + static_cast<ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  const double limit = kTimesMedian * *middle;
  std::vector<Vec2> kept;
  for (const Vec2& p : points)
    if (std::fabs(line.distance(p)) <= limit) kept.push_back(p);
  if (kept.size() >= 3) points.swap(kept);
}

}  // namespace

double trimmed_mean(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  const size_t cut = values.size() / 6;
  double sum = 0;
  for (size_t i = cut; i < values.size() - cut; ++i) sum += values[i] - values[cut];
  return values[cut] + sum / static_cast<double>(values.size() - 2 * cut);
}

EdgeLine fit_edge_line(std::span<const Vec2> points, const StraightenSetting& setting) {
  const Vec2 chord = points.back() - points.front();
  const double length = norm(chord);
  std::vector<Vec2> used = without_ends(points, setting.max_edge_m);
  EdgeLine line = least_squares_line(used, chord);
  if (used.size() > 5) {
    drop_outliers(used, line);
    line = least_squares_line(used, chord);
  }
  // Snap: the angle that jagged points leave open grows as the edge gets shorter.
  const double open = length > 0 ? std::atan(0.5 * setting.tolerance_m / length) : 0;
  const double snap = std::min(
      std::max(setting.snap_angle_rad, setting.snap_angle_rad > 0 ? open : 0), kMaxSnap_rad);
  const double sine = std::sin(snap);
  std::vector<double> across;
  if (std::fabs(line.direction.v) <= sine) {
    line.direction = {line.direction.u < 0 ? -1.0 : 1.0, 0};
    for (const Vec2& p : used) across.push_back(p.v);
    line.point.v = trimmed_mean(across);
  } else if (std::fabs(line.direction.u) <= sine) {
    line.direction = {0, line.direction.v < 0 ? -1.0 : 1.0};
    for (const Vec2& p : used) across.push_back(p.u);
    line.point.u = trimmed_mean(across);
  }
  // The solid is on the left: outward is to the right.
  line.point = line.point + Vec2{line.direction.v, -line.direction.u} * setting.set_back_m;
  return line;
}

bool are_aligned(const EdgeLine& a, const EdgeLine& b) {
  return dot(a.direction, b.direction) > 0 &&
         std::fabs(cross(a.direction, b.direction)) <= kAligned;
}

std::optional<Vec2> intersect(const EdgeLine& a, const EdgeLine& b, double min_sine) {
  const double sine = cross(a.direction, b.direction);
  if (std::fabs(sine) < min_sine) return std::nullopt;
  Vec2 out = a.point + a.direction * (cross(b.point - a.point, b.direction) / sine);
  for (const EdgeLine* line : {&a, &b}) {  // upright edges stay upright to the last bit
    if (line->direction.u == 0) out.u = line->point.u;
    if (line->direction.v == 0) out.v = line->point.v;
  }
  return out;
}

}  // namespace jalon
