// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/iterations.h"

#include <algorithm>
#include <cmath>

#include "geometry/rigid_motion.h"
#include "spatial/quantile.h"

namespace jalon {

namespace {

constexpr double kShrink = 0.8,
                 kNoises = 3;           // of the greatest residual (Girardeau-Montaut 2006, 2.1)
constexpr double kSteps = 3;            // ... which stays above so many times the last step
constexpr double kMadToSigma = 1.4826;  // median of |x| of the standard normal, inverted
constexpr double kLeastSigma_m = 1e-9;  // keeps noise-free points from having no weight
// A step is small when it is below so many standard deviations of the pose: what it leaves adds nothing to its
// variance.
constexpr double kSmallLast = 0.1, kSmallBefore = 0.3;
// Steps on the same neighbours; those that a step has moved by less than so many noises would be found again.
constexpr int kStepsOnPairs = 3;
constexpr double kStillNear = 0.1;
constexpr size_t kRestless = 15;    // steps of a level
constexpr size_t kMostBefore = 40;  // steps of a level that is not the last
// Weights pull less than their slope would: near the end a step that goes by the weights falls short by this ratio.
constexpr double kMostLengthening = 1.5;
constexpr double kRounding = 1e-13;   // of the extent: a step that rounding makes
constexpr uint64_t kLeastPairs = 12;  // two for each unknown

PairRule rule_of(const IcpSettings& settings, const IcpLevel& level, double most_m) {
  return {settings.metric, most_m, level.reference.reach_m, settings.least_cosine(),
          static_cast<double>(settings.k)};
}

/// What a sample of the residuals says.
struct Scale {
  size_t residuals = 0;  ///< looked at
  double most_m = 0;     ///< greatest that is a pair: the distance, or what trimming leaves of it
};

// Sets the scale of the residuals, where there are any.
Scale measure_scale(const IcpProblem& problem, const IcpLevel& level, IcpState& state) {
  const IcpSettings& settings = problem.settings;
  const PairRule rule = rule_of(settings, level, state.distance_m);
  std::vector<float> residuals = icp_residual_sample(
      {problem.clouds, level, state.last.neighbours, rule, state.T_reference_moving});
  if (residuals.empty()) return {};
  for (float& v : residuals) v = std::fabs(v);
  state.sigma_m = std::max(kLeastSigma_m, kMadToSigma * quantile_of(residuals, 0.5));
  if (!(settings.trim() > 0)) return {residuals.size(), rule.most_m};
  return {residuals.size(), std::min(rule.most_m, quantile_of(residuals, 1 - settings.trim()))};
}

// The normal equations of one step; false when too few points meet.
bool sum_up(const IcpProblem& problem, const IcpLevel& level, IcpState& state, IcpIteration& row,
            Task& task) {
  const Scale scale = measure_scale(problem, level, state);
  if (scale.residuals < kLeastPairs) return false;
  IcpLastStep& step = state.last;
  step.rule = rule_of(problem.settings, level, scale.most_m);
  // While the distance shrinks it is the cut: a scale of its own would hold on to the first surface that fits.
  const double wide = state.distance_m / RobustKernel::kTukeyCut;
  step.kernel = {problem.settings.kernel, std::max(state.sigma_m, wide)};
  step.sums = icp_sums(state.pairing(problem, level), step.kernel,
                       problem.frame(state.T_reference_moving), task);
  row.pairs = step.sums.pairs;
  row.kept = static_cast<double>(step.sums.of_moving) /
             static_cast<double>(step.neighbours.of_moving.size());
  row.rms_m = std::sqrt(step.sums.squares / std::max(step.sums.weights, 1e-300));
  row.sigma_m = state.sigma_m;
  row.distance_m = state.distance_m;
  return step.sums.pairs >= kLeastPairs && row.kept >= problem.settings.least_overlap();
}

// Moves; how many standard deviations of the pose the step was.
double move(const IcpProblem& problem, IcpState& state, IcpIteration& row) {
  const IcpSums& sums = state.last.sums;
  state.last.directions = icp_directions(sums, state.over_noise);
  Coefficients<6> step = icp_step(sums, state.last.directions);
  const double lengthening = sums.weights / std::max(sums.slopes, sums.weights / kMostLengthening);
  for (double& s : step) s *= std::max(1.0, lengthening);
  const IcpFrame frame = problem.frame(state.T_reference_moving);
  const Vec3 turn = Vec3{step[0], step[1], step[2]} / frame.extent_m;
  const Vec3 shift{step[3], step[4], step[5]};
  state.T_reference_moving = motion_about(frame.centre, turn, shift) * state.T_reference_moving;
  row.turn_rad = norm(turn);
  row.shift_m = norm(shift);
  for (const bool observable : state.last.directions.observable) row.observable += observable;
  double squared = 0;
  for (size_t i = 0; i < 6; ++i) squared += step[i] * sums.right[i];
  return std::sqrt(std::max(0.0, squared)) / state.sigma_m;
}

}  // namespace

bool icp_iterate(const IcpProblem& problem, const IcpLevel& level, IcpState& state, Task& task) {
  const IcpSettings& settings = problem.settings;
  const SurfacePlanes &reference = problem.clouds.reference, &moving = problem.clouds.moving;
  const IcpSearch search(problem.clouds, level, settings.search_cosine(), task);
  const double noise_m = std::hypot(reference.noise_m, moving.noise_m);
  const double sideways_m =
      level.reference.reach_m + 4 * std::max(reference.radius_m, moving.radius_m);
  const double small = level.last ? kSmallLast : kSmallBefore;
  const size_t before = state.log.size();
  state.stopped = StopReason::kIterationLimit;
  const auto floor_m = [&] {
    return std::max(
        {kNoises * noise_m, RobustKernel::kTukeyCut * state.sigma_m, settings.min_distance_m});
  };
  for (bool first = true;; first = false) {
    state.last.neighbours =
        search.find(state.T_reference_moving, state.distance_m + sideways_m, task);
    // What converged on fewer points is where it should be, within the noise of these.
    if (first && level.number > 0 && measure_scale(problem, level, state).residuals > 0)
      state.distance_m = std::min(state.distance_m, floor_m());
    double moved_m = 0;
    for (int k = 0; k < kStepsOnPairs; ++k) {
      // Few points need not settle: hard cuts keep some of them coming and going.
      if (!level.last && state.log.size() - before >= kMostBefore) return true;
      if (static_cast<int>(state.log.size()) >= settings.max_iterations) return false;
      IcpIteration row;
      row.level = level.number;
      const bool enough = sum_up(problem, level, state, row, task);
      const double step = enough ? move(problem, state, row) : 0;
      state.log.push_back(row);
      task.checkpoint(static_cast<double>(state.log.size()) / settings.max_iterations);
      if (!enough) {
        state.stopped = StopReason::kTooFewPairs;
        return false;
      }
      const double length_m = row.shift_m + row.turn_rad * problem.extent_m;
      moved_m += length_m;
      const bool shrunk = state.distance_m <= floor_m() / kShrink;
      state.distance_m = std::max({kShrink * state.distance_m, floor_m(), kSteps * length_m});
      if (!shrunk || moved_m > kStillNear * noise_m) break;  // other neighbours
      // Pairs that keep coming and going leave steps well below what the noise leaves open.
      const bool restless = state.log.size() - before >= kRestless && step < kSmallBefore;
      if (step >= small && !restless) continue;
      state.stopped = StopReason::kConverged;
      return true;
    }
    // Noise-free clouds, or neighbours that swap for ever: the pairs do not say it better.
    const IcpIteration& row = state.log.back();
    if (row.shift_m + row.turn_rad * problem.extent_m <= kRounding * problem.extent_m) {
      state.stopped = StopReason::kConverged;
      return true;
    }
  }
}

}  // namespace jalon
