// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/settle.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "geometry/rigid_motion.h"
#include "registration/icp/patches.h"

namespace jalon {

namespace {

constexpr int kMostSteps = 4;
// Points of a patch are chosen by their distance from it already, within four or five noises. So wide a biweight has
// 99 % of the efficiency of least squares, the usual one 95.
constexpr double kWider = 1.4;
// Steps in standard deviations of the pose: the last one, and one that is not worth taking.
constexpr double kSmall = 0.1, kSettleNone = 0.02;
// A point has a pair either way, and two points at most say half of what one and a true surface would.
constexpr double kOfPairs = 0.25, kSettleLeastShare = 0.5;

using Matrix = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Basis = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;

Basis observable(const IcpDirections& directions) {
  Basis out(6, std::count(directions.observable.begin(), directions.observable.end(), true));
  Eigen::Index next = 0;
  for (size_t k = 0; k < 6; ++k) {
    if (!directions.observable[k]) continue;
    for (size_t i = 0; i < 6; ++i) out(static_cast<Eigen::Index>(i), next) = directions.unit[k][i];
    ++next;
  }
  return out;
}

Matrix inverse_on(const Basis& basis, const Square<6>& normal) {
  const Matrix all = Eigen::Map<const Matrix>(normal.data());
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6> reduced =
      basis.transpose() * all * basis;
  return basis * reduced.ldlt().solve(Basis(basis).transpose());
}

bool says_enough(const PatchSums& sums, const IcpDirections& directions) {
  const Eigen::Map<const Matrix> normal(sums.normal.data());
  for (size_t k = 0; k < 6; ++k) {
    if (!directions.observable[k]) continue;
    const Eigen::Map<const Eigen::Matrix<double, 6, 1>> unit(directions.unit[k].data());
    if (!(unit.dot(normal * unit) >= kSettleLeastShare * kOfPairs * directions.information[k]))
      return false;
  }
  return sums.patches > 0;
}

}  // namespace

void icp_settle(const IcpProblem& problem, IcpState& state, Task& task) {
  const IcpSettings& settings = problem.settings;
  if (settings.metric != IcpMetric::kPointToPlane || settings.kernel == KernelKind::kNone) return;
  if (settings.trim() > 0 || state.stopped != StopReason::kConverged || !state.has_all(problem))
    return;
  const IcpDirections& directions = state.last.directions;
  const Basis basis = observable(directions);
  if (basis.cols() == 0) return;
  const IcpPatches patches(problem.clouds, state.last.neighbours, task);
  const RobustKernel kernel{settings.kernel, kWider * state.sigma_m};
  const Transform T_by_pairs = state.T_reference_moving;
  double moved_m = 0;
  for (int k = 0; k < kMostSteps; ++k) {
    // 1. The patches at this pose, and what they say.
    const IcpFrame frame = problem.frame(state.T_reference_moving);
    const PatchSums sums = patches.sums(state.T_reference_moving, kernel, frame, task);
    task.checkpoint(1);
    if (!says_enough(sums, directions)) break;
    // 2. One step in the directions that the pairs fixed.
    const Eigen::Map<const Eigen::Matrix<double, 6, 1>> right(sums.right.data());
    const Eigen::Matrix<double, 6, 1> step = inverse_on(basis, sums.normal) * right;
    const Vec3 turn = Vec3{step[0], step[1], step[2]} / frame.extent_m;
    const Vec3 shift{step[3], step[4], step[5]};
    const double deviations =
        std::sqrt(std::max(0.0, step.dot(right)) * sums.weights / sums.squares);
    if (deviations > kSettleNone)
      state.T_reference_moving = motion_about(frame.centre, turn, shift) * state.T_reference_moving;
    IcpIteration row = state.log.back();
    row.level += k == 0 ? 1 : 0;
    row.pairs = sums.points;
    row.kept =
        static_cast<double>(sums.of_moving) / static_cast<double>(problem.clouds.moving.size());
    row.rms_m = std::sqrt(sums.squares / sums.weights);
    row.turn_rad = deviations > kSettleNone ? norm(turn) : 0;
    row.shift_m = deviations > kSettleNone ? norm(shift) : 0;
    state.log.push_back(row);
    moved_m += row.shift_m + row.turn_rad * problem.extent_m;
    // 3. Until the steps are small. What went farther than the residuals scatter left the minimum
    // of the pairs.
    if (deviations > kSmall) continue;
    if (moved_m > state.sigma_m) break;
    state.patches = sums;
    return;
  }
  state.T_reference_moving = T_by_pairs;
}

Square<6> patch_covariance(const PatchSums& sums, const IcpDirections& directions) {
  Square<6> out{};
  const Basis basis = observable(directions);
  if (basis.cols() == 0) return out;
  const Matrix inverse = inverse_on(basis, sums.normal);
  Eigen::Map<Matrix>(out.data()) =
      inverse * Eigen::Map<const Matrix>(sums.scatter.data()) * inverse.transpose();
  return out;
}

}  // namespace jalon
