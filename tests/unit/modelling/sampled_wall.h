// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/edges/join/vectorise.h"
#include "unit/modelling/walls.h"

// Walls y = 0 (u = x, v = z) of known form, sampled as scans and textbooks sample them.
namespace walls {

enum class Sampling { kGrid, kTurnedGrid, kTwoGrids, kJittered, kPoisson };
constexpr Sampling kSamplings[] = {Sampling::kGrid, Sampling::kTurnedGrid, Sampling::kTwoGrids,
                                   Sampling::kJittered, Sampling::kPoisson};
inline const char* name_of(Sampling sampling) {
  constexpr const char* kNames[] = {"grid", "turned grid", "two grids", "jittered", "poisson"};
  return kNames[static_cast<int>(sampling)];
}

struct SampledWall {
  double width = 3, height = 2.5;
  double spacing = 0.015;  ///< root of the area a point
  double noise_across = 0.003, noise_along = 0.0015;
  uint64_t seed = 1;
  Sampling sampling = Sampling::kGrid;
  std::function<bool(double, double)> solid;

  /// A grid of rows and columns of its own distances, turned, with a phase of its own.
  void add_grid(RandomStream& random, double area, double turn, double jitter,
                std::vector<Vec2>& out) const {
    // Rows as far apart as points along them in an upright grid: its errors are a share of the spacing.
    const double stretch =
        sampling == Sampling::kGrid ? 0.95 + 0.1 * random.uniform() : 0.8 + 0.5 * random.uniform();
    const double step_u = std::sqrt(area) * stretch, step_v = area / step_u;
    const double phase_u = random.uniform(), phase_v = random.uniform(), c = std::cos(turn),
                 s = std::sin(turn);
    const double reach = width + height;
    for (double a = -reach + phase_u * step_u; a < reach; a += step_u)
      for (double b = -reach + phase_v * step_v; b < reach; b += step_v) {
        const double ja = a + jitter * step_u * (random.uniform() - 0.5);
        const double jb = b + jitter * step_v * (random.uniform() - 0.5);
        const Vec2 p{c * ja - s * jb, s * ja + c * jb};
        if (p.u >= -0.1 && p.v >= -0.1 && p.u <= width + 0.1 && p.v <= height + 0.1)
          out.push_back(p);
      }
  }

  std::vector<Vec3> points() const {
    RandomStream random(seed, 17);
    std::vector<Vec2> hits;
    const double area = spacing * spacing;
    if (sampling == Sampling::kPoisson)
      for (double k = 0; k < (width + 0.2) * (height + 0.2) / area; ++k)
        hits.push_back(
            {-0.1 + (width + 0.2) * random.uniform(), -0.1 + (height + 0.2) * random.uniform()});
    else if (sampling == Sampling::kTwoGrids)
      for (int k = 0; k < 2; ++k)
        add_grid(random, 2 * area, 0.06 * (random.uniform() - 0.5), 0, hits);
    else
      add_grid(random, area, sampling == Sampling::kTurnedGrid ? 1.5 * random.uniform() : 0,
               sampling == Sampling::kJittered ? 1 : 0, hits);
    std::vector<Vec3> out;
    for (const Vec2& p : hits)
      if (solid(p.u, p.v))
        out.push_back({p.u + noise_along * random.normal(), noise_across * random.normal(),
                       p.v + noise_along * random.normal()});
    return out;
  }
};

inline VectorPlane vectorised(const Segmentation& segmentation, const char* json = "{}") {
  ParamSet params("modeller outlines", outlines_rows());
  params.from_json(json);
  Task::Hooks hooks;
  hooks.threads = 1;
  Task task(hooks);
  return vectorise(segmentation, settings_from<VectoriseSetting>(params), task).at(0);
}

/// A ring's corners and arcs' middles in wall coordinates (x, z).
inline Vec2 on_wall(const VectorPlane& plane, const Vec2& p) {
  const Vec3 at = plane.frame.lift(p);
  return {at.x, at.z};
}

/// Running figures of errors.
struct Errors {
  double n = 0, sum = 0, squares = 0, worst = 0;
  void add(double e) {
    n += 1;
    sum += e;
    squares += e * e;
    worst = std::max(worst, std::fabs(e));
  }
  double mean() const { return sum / n; }
  double rms() const { return std::sqrt(squares / n); }
};

}  // namespace walls
