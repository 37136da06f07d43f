// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/detection/sights.h"
#include "compare/detection/surface_cores.h"

namespace jalon {

/// What the reference says of a core of the compared cloud.
enum class CoreState : uint8_t {
  kUnchanged,
  kMoved,  ///< on a surface that both epochs saw, farther from it than its level of detection
  kNew,  ///< where the reference's beams went through; without stations: where it has nothing near
  kUntold,  ///< where the reference saw nothing; without stations: beyond the border of its surface
};

struct CoreTest {
  CoreState state = CoreState::kUnchanged;
  bool has_surface = false;  ///< of the reference, facing the same way, about the core's foot
  uint32_t surface = 0;      ///< that one of the reference's cores
  double distance_m = 0;  ///< from it, bends allowed for; without a surface from its nearest point
  double sigma_m = 0;     ///< of that distance
};

struct DetectionRates {
  double false_discovery = 0.01;  ///< share of the cores called moved that need not have
  double alignment_m = 0;         ///< standard deviation of the clouds' alignment
};

struct CoreTests {
  std::vector<CoreTest> cores;
  double noise_m = 0;
  /// Standard deviation by which most surfaces differ beside their own: in sigma_m of all.
  double misalignment_m = 0;
  /// Spread of the deviates of all cores over what noise predicts, at least 1 (the empirical null of Efron 2004):
  /// misalignment and roughness that most of the scene shares are no change.
  double null_scale = 1;
  double limit_sigmas = 0;  ///< beyond which a core has moved, in null_scale * sigma_m
  size_t tested = 0;        ///< cores with a surface of the reference
};

/// 1. The distance of each core from the reference's surface at its foot, with its sigma by noise, by the lever of the
/// plane and by what does not average out (roughness, edges); 2. how badly the epochs are registered: the motion that
/// all of the scene shares, whose size at each core is added to its sigma, and beside it the variance that most
/// surfaces share, which is added to theirs as in a random-effects model (Paule & Mandel 1982, by quantiles of cores
/// and of parts of surfaces in place of the mean square): a few millimetres between scans are a matter of their
/// alignment, not of each surface's points; then what is left of the empirical null; 3. which are significant, at this
/// rate of false discoveries; 4. cores without such a surface: explained by the spacing of the points, seen through, or
/// not to be told.
/// nearest_m: distance of each compared point from the reference's nearest. sights: of the reference; null: unknown.
CoreTests test_cores(const SurfaceCores& reference, const SurfaceCores& compared,
                     std::span<const double> nearest_m, const Sights* sights, const Vec3& origin,
                     const DetectionRates& rates, Task& task);

}  // namespace jalon
