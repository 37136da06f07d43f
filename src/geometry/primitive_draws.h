// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/random.h"
#include "base/task.h"
#include "geometry/adjustment.h"

namespace jalon {

/// How a primitive is fitted to a list of points.
struct PrimitiveSetting {
  double tolerance_m = 0.025;  ///< half-thickness: points further from the surface are outliers
  double min_radius_m = 0.001, max_radius_m = 1000;
  bool robust = true;  ///< random draws and biweight; else least squares on every point
  uint64_t seed = 1;

  bool allows(double radius_m) const {
    return radius_m >= min_radius_m && radius_m <= max_radius_m;
  }
  AdjustSetting adjustment() const { return {robust ? tolerance_m : INFINITY, robust}; }
};

namespace draws {

constexpr size_t kSample = 512;         // points that score a draw
constexpr double kProbability = 0.999;  // that a draw without outliers is among them
constexpr int kLeastDraws = 64, kMostDraws = 4000;
constexpr double kSafety =
    4;  // a draw without outliers may still be poor: points close together, noisy normals
constexpr int kLocalSteps =
    20;  // least-squares steps on each new best draw (Chum, Matas & Kittler 2003)

inline size_t sample_step(size_t points) { return points / kSample + 1; }

template <class Point>
std::vector<Point> even_sample(std::span<const Point> points) {
  std::vector<Point> out;
  for (size_t i = 0; i < points.size(); i += sample_step(points.size())) out.push_back(points[i]);
  return out;
}

/// Sum of min(d^2, reach^2), and the points within reach (Torr & Zisserman 2000: MSAC); agrees(model, i) tells whether
/// the normal of point i lets it lie on the model (Schnabel et al. 2007).
template <class Model, class Agrees>
double score(std::span<const typename Model::Point> sample, size_t step, const Model& model,
             double reach_m, Agrees&& agrees, size_t& inliers) {
  double sum = 0;
  inliers = 0;
  for (size_t i = 0; i < sample.size(); ++i) {
    const double d = adjustment::distance_of(model, sample[i]);
    const bool in = std::fabs(d) <= reach_m && agrees(model, i * step);
    inliers += in;
    sum += in ? d * d : reach_m * reach_m;
  }
  return sum;
}

/// Draws that a minimal set of `size` points without outliers needs (Boulaassal 2010, C.2).
inline double needed(size_t inliers, size_t all, size_t size) {
  const double share =
      std::pow(static_cast<double>(inliers) / static_cast<double>(all), static_cast<double>(size));
  if (share >= 1) return 0;
  return share > 0 ? std::log(1 - kProbability) / std::log(1 - share) : INFINITY;
}

}  // namespace draws

/// The best of adaptively many models that draw(random, model) makes of minimal sets; false when none is usable.
template <class Model, class Draw, class Agrees>
bool best_draw(std::span<const typename Model::Point> points, const PrimitiveSetting& setting,
               size_t minimal, Task& task, Draw&& draw, Agrees&& agrees, Model& best) {
  using namespace draws;
  const auto sample = even_sample(points);
  const size_t step = sample_step(points.size());
  const double reach = setting.tolerance_m;
  double best_score = INFINITY, enough = kMostDraws;
  for (int i = 0; i < kMostDraws && (i < kLeastDraws || i < enough); ++i) {
    if (i % 64 == 0) task.checkpoint(0);
    RandomStream random(setting.seed, static_cast<uint64_t>(i));
    Model model;
    if (!draw(random, model)) continue;
    size_t inliers = 0, more = 0;
    const double now = score<Model>(sample, step, model, reach, agrees, inliers);
    if (!(now < best_score)) continue;
    Model refined = model;
    adjustment::descend<Model>(sample, {reach, INFINITY}, kLocalSteps, adjustment::kSmallStep, task,
                               refined);
    const double after = score<Model>(sample, step, refined, reach, agrees, more);
    const bool better = after < now && setting.allows(refined.radius());
    best = better ? refined : model;
    best_score = better ? after : now;
    enough = std::min<double>(kMostDraws,
                              kSafety * needed(better ? more : inliers, sample.size(), minimal));
  }
  return best_score < INFINITY;
}

/// For points without normals.
struct AlwaysAgrees {
  template <class Model>
  bool operator()(const Model&, size_t) const {
    return true;
  }
};

}  // namespace jalon
