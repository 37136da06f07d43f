// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/intensity_pattern.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "geometry/adjustment.h"
#include "registration/targets/pattern_covariance.h"

namespace jalon {

namespace {

constexpr int kStepsAcross = 16;    // of the search, a pattern's size
constexpr int kAngles = 9;          // in a quarter turn: 10 degrees apart
constexpr int kRadii = 9;           // between half a disc's radius and one and a half
constexpr size_t kSearched = 1500;  // points that the search looks at
constexpr size_t kLeastPoints = 24;
constexpr double kCheckerShare =
    0.45;  // radius within a checker, of its edge: what its quadrants surely fill
constexpr double kDiscShare =
    0.8;  // radius around a disc, of its diameter: so much of the ground shows its edge
constexpr double kGapShare = 0.01;  // of the points may lie in a gap: those that noise put there
constexpr int kRefits = 3;          // the window moves with the centre
constexpr int kMostSteps = 60;
constexpr double kSettled = 1e-6;  // of what an edge notices: a step below it ends the fit

std::vector<BrightPoint> window(std::span<const BrightPoint> points, const Vec2& centre,
                                double radius_m) {
  std::vector<BrightPoint> out;
  for (const BrightPoint& p : points)
    if (norm(Vec2{p.u - centre.u, p.v - centre.v}) <= radius_m) out.push_back(p);
  return out;
}

std::vector<BrightPoint> sample_of(std::span<const BrightPoint> points) {
  std::vector<BrightPoint> out;
  for (size_t i = 0; i < points.size(); i += points.size() / kSearched + 1)
    out.push_back(points[i]);
  return out;
}

// Correlation of a pattern of plus and minus one with the brightness.
struct Correlation {
  double n = 0, h = 0, v = 0, hh = 0, vv = 0, hv = 0;
  void add(double sign, double value) {
    ++n, h += sign, v += value, hh += 1, vv += value * value, hv += sign * value;
  }
  double squared() const {
    const double covariance = hv - h * v / n, of_h = hh - h * h / n, of_v = vv - v * v / n;
    return n >= kLeastPoints && of_h > 0 && of_v > 0 ? covariance * covariance / (of_h * of_v) : 0;
  }
  /// Level and contrast of value = level + contrast sign.
  void set(double& level, double& contrast) const {
    contrast = (hv - h * v / n) / (hh - h * h / n);
    level = (v - contrast * h) / n;
  }
};

template <class F>
void for_each_centre(double size_m, double reach_m, Task& task, F&& f) {
  const double step = size_m / kStepsAcross;
  const int cells = static_cast<int>(reach_m / step);
  for (int i = -cells; i <= cells; ++i) {
    task.checkpoint(0);
    for (int k = -cells; k <= cells; ++k)
      if (i * i + k * k <= cells * cells) f(Vec2{i * step, k * step});
  }
}

// Step 1: the centre and turn, or radius, whose pattern of plus and minus one goes best with the
// brightness.
std::optional<CheckerModel> search_checker(std::span<const BrightPoint> points, double size_m,
                                           double reach_m, Task& task) {
  CheckerModel out;
  double best = 0;
  for_each_centre(size_m, reach_m, task, [&](const Vec2& centre) {
    const auto near = window(points, centre, kCheckerShare * size_m);
    for (int a = 0; a < kAngles; ++a) {
      const double angle = a * std::numbers::pi / 2 / kAngles, c = std::cos(angle),
                   s = std::sin(angle);
      Correlation correlation;
      for (const BrightPoint& p : near) {
        const double du = p.u - centre.u, dv = p.v - centre.v;
        correlation.add((c * du + s * dv > 0) == (c * dv - s * du > 0) ? 1 : -1, p.value);
      }
      if (!(correlation.squared() > best)) continue;
      best = correlation.squared();
      out.centre = centre;
      out.angle[0] = angle, out.angle[1] = angle + std::numbers::pi / 2;
      correlation.set(out.level, out.contrast);
    }
  });
  if (!(best > 0)) return std::nullopt;
  return out;
}

std::optional<DiscModel> search_disc(std::span<const BrightPoint> points, double size_m,
                                     double reach_m, Task& task) {
  DiscModel out;
  double best = 0;
  for_each_centre(size_m, reach_m, task, [&](const Vec2& centre) {
    const auto near = window(points, centre, kDiscShare * size_m);
    for (int a = 0; a < kRadii; ++a) {
      const double radius = size_m / 2 * (0.5 + a / static_cast<double>(kRadii - 1));
      Correlation correlation;
      for (const BrightPoint& p : near)
        correlation.add(norm(Vec2{p.u - centre.u, p.v - centre.v}) < radius ? 1 : -1, p.value);
      if (!(correlation.squared() > best)) continue;
      best = correlation.squared();
      out.centre = centre, out.radius_m = radius;
      correlation.set(out.level, out.contrast);
    }
  });
  if (!(best > 0)) return std::nullopt;
  return out;
}

// Below it a step of each unknown is nothing: lengths, angles and brightness have units of their
// own.
template <class Model>
Coefficients<Model::kUnknowns> small_step(const Model& model, double radius_m) {
  auto small = model.units(radius_m);
  for (double& s : small) s = kSettled * std::fabs(s);
  return small;
}

template <class Model>
struct Refined {
  PatternCentre pattern;
  Model model;
  Square<Model::kUnknowns> covariance;
};

// Step 2: least squares in a window that follows the centre; the edges are as wide as the points
// are apart, since nothing finer can be seen of them.
template <class Model>
std::optional<Refined<Model>> refine(std::span<const BrightPoint> points, double radius_m,
                                     double size_m, Model model, Task& task) {
  Refined<Model> refined;
  PatternCentre& out = refined.pattern;
  constexpr adjustment::Weighting kAll{INFINITY, INFINITY};
  for (int fit = 0; fit < kRefits; ++fit) {
    const auto near = window(points, model.centre, radius_m);
    if (near.size() < kLeastPoints) return std::nullopt;
    model.width_m =
        std::sqrt(std::numbers::pi * radius_m * radius_m / static_cast<double>(near.size()));
    const std::span<const BrightPoint> list(near);
    const bool settled =
        adjustment::descend(list, kAll, kMostSteps, small_step(model, radius_m), task, model);
    if (!settled && fit == kRefits - 1) return std::nullopt;
    const bool is_finite = std::isfinite(model.centre.u + model.centre.v);
    if (!is_finite || !model.sound(size_m)) return std::nullopt;
    if (fit < kRefits - 1) continue;
    const auto sums = adjustment::sums_of(list, model, kAll, true, task);
    const auto estimated = PatternCovariance<Model>::estimate(list, model, radius_m);
    if (!estimated) return std::nullopt;
    const auto& covariance = refined.covariance = *estimated;
    double mean = 0, squares = 0;
    for (const BrightPoint& p : near) mean += p.value / static_cast<double>(near.size());
    for (const BrightPoint& p : near) squares += (p.value - mean) * (p.value - mean);
    out.explained = squares > 0 ? 1 - sums.psi2 / squares : 0;
    out.points = near.size();
    out.centre = model.centre;
    constexpr size_t kK = Model::kUnknowns;
    out.covariance = {covariance[0], covariance[1], covariance[kK], covariance[kK + 1]};
  }
  refined.model = model;
  return refined;
}

// Between the points on either side of a line through the centre: where scan lines run along it, it may lie anywhere
// between two of them, which no covariance of the fit tells.
double gap_at(const std::vector<BrightPoint>& points, const Vec2& centre, const Vec2& normal) {
  std::vector<double> sides[2];
  for (const BrightPoint& p : points) {
    const double d = (p.u - centre.u) * normal.u + (p.v - centre.v) * normal.v;
    sides[d > 0].push_back(std::fabs(d));
  }
  double gap = 0;
  for (std::vector<double>& side : sides) {
    const auto few = static_cast<std::ptrdiff_t>(kGapShare * static_cast<double>(side.size()));
    if (side.empty()) continue;
    std::nth_element(side.begin(), side.begin() + few, side.end());
    gap += side[static_cast<size_t>(few)];
  }
  return gap;
}

}  // namespace

std::optional<PatternCentre> find_checker(std::span<const BrightPoint> points, double size_m,
                                          double reach_m, Task& task) {
  const auto model = search_checker(sample_of(points), size_m, reach_m, task);
  if (!model) return std::nullopt;
  const auto refined = refine(points, kCheckerShare * size_m, size_m, *model, task);
  if (!refined) return std::nullopt;
  PatternCentre out = refined->pattern;
  for (const double angle : refined->model.angle) {
    const Vec2 n{std::cos(angle), std::sin(angle)};
    const double gap = gap_at(window(points, out.centre, kCheckerShare * size_m), out.centre, n);
    const double variance = gap * gap / 12;  // of a place anywhere in the gap
    out.covariance[0] += variance * n.u * n.u;
    out.covariance[1] += variance * n.u * n.v;
    out.covariance[2] += variance * n.u * n.v;
    out.covariance[3] += variance * n.v * n.v;
  }
  return out;
}

std::optional<PatternCentre> find_disc(std::span<const BrightPoint> points, double size_m,
                                       double reach_m, Task& task) {
  const auto model = search_disc(sample_of(points), size_m, reach_m, task);
  if (!model) return std::nullopt;
  const auto refined = refine(points, kDiscShare * size_m, size_m, *model, task);
  if (!refined) return std::nullopt;
  PatternCentre out = refined->pattern;
  out.radius_m = refined->model.radius_m;
  out.radius_sigma_m = std::sqrt(refined->covariance[12]);
  return out;
}

}  // namespace jalon
