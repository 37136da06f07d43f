// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/covariance.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/parallel.h"
#include "registration/icp/influence.h"
#include "registration/icp/settle.h"

namespace jalon {

namespace {

constexpr size_t kCovarianceGrain = 1 << 13;
constexpr double kCut = 3;
constexpr double kCutVariance =
    0.973337;  // of the standard normal within 3: 1 - 6 phi(3) / (2 Phi(3) - 1)

/// Squares of the residuals and the variances foretold for them.
struct Scatter {
  double squares = 0, foretold = 0;
  Scatter& operator+=(const Scatter& b) {
    squares += b.squares;
    foretold += b.foretold;
    return *this;
  }
  // Sums are divided, not each by each: a scatter of a dozen points is no divisor.
  void add(double residual_m, double variance_m2, double cut_m) {
    if (std::abs(residual_m) > cut_m) return;
    squares += residual_m * residual_m;
    foretold += variance_m2;
  }
};

double sigma0_of(const IcpPairing& at, double sigma_m, Task& task) {
  const auto both = [&](const Buffer<uint32_t>& near, PairWay way) {
    return parallel_reduce(task, near.size(), kCovarianceGrain, Scatter{},
                           [&](size_t begin, size_t end) {
                             Scatter part;
                             IcpPair pair;
                             for (size_t i = begin; i < end; ++i) {
                               if (near[i] == kNoPoint) continue;
                               uint32_t m = static_cast<uint32_t>(i), r = near[i];
                               if (way == PairWay::kBack) std::swap(m, r);
                               if (pair_of(at, m, r, way, pair))
                                 part.add(pair.residual_m, pair.variance_m2, kCut * sigma_m);
                             }
                             return part;
                           });
  };
  Scatter sum = both(at.neighbours.of_moving, PairWay::kForth);
  sum += both(at.neighbours.of_reference, PairWay::kBack);
  return sum.foretold > 0 ? std::sqrt(sum.squares / sum.foretold / kCutVariance) : 1;
}

// The inverse of the information in the observable directions.
Square<6> inverse_of(const IcpDirections& directions) {
  Square<6> out{};
  for (size_t k = 0; k < 6; ++k) {
    if (!directions.observable[k]) continue;
    for (size_t r = 0; r < 6; ++r)
      for (size_t c = 0; c < 6; ++c)
        out[6 * r + c] += directions.unit[k][r] * directions.unit[k][c] / directions.information[k];
  }
  return out;
}

// The open directions first, as the information has them; then those of the covariance, the weakest first.
void set_directions(const Square<6>& scaled, const IcpDirections& found, IcpCovariance& out) {
  const std::array<PoseDirection, 6> of_covariance = pose_directions(scaled, 1);
  size_t next = 0;
  for (size_t k = 0; k < 6; ++k)
    if (!found.observable[k]) out.directions[next++] = {found.unit[k], kNaN, false};
  for (size_t k = 0; next < 6; ++k) out.directions[next++] = of_covariance[k];
}

// What the noise of the points puts into the right-hand side of pairs.
Square<6> pair_scatter(const IcpPairing& at, const IcpFrame& frame, const RobustKernel& kernel,
                       const IcpSums& sums, uint32_t k, Task& task) {
  if (at.rule.metric != IcpMetric::kPointToPlane) return icp_scores(at, frame);
  Square<6> out = icp_influence(at, frame, k, task);
  // What robust weights cost is noise of each pair alone: 5 % of what it would be by itself, while points that stand in
  // many pairs are most of the sum.
  const double variance_m2 = sums.squares / std::max(sums.weights, 1.0);
  if (kernel.kind != KernelKind::kNone)
    for (size_t i = 0; i < 36; ++i)
      out[i] += (1 / RobustKernel::kEfficiency - 1) * variance_m2 * sums.normal[i];
  return out;
}

}  // namespace

IcpCovariance icp_covariance(const IcpProblem& problem, const IcpState& state, Task& task) {
  IcpCovariance out;
  const RobustKernel& kernel = state.last.kernel;
  const IcpFrame frame = problem.frame(state.T_reference_moving);
  // 1. The pairs with a say, each with the weight 1; pair_scatter adds what robust weights cost.
  PairRule heard = state.last.rule;
  if (kernel.kind == KernelKind::kTukey)
    heard.most_m = std::min(heard.most_m, RobustKernel::kTukeyCut * kernel.sigma_m);
  const IcpLevel all;
  const IcpPairing at{problem.clouds, all, state.last.neighbours, heard, state.T_reference_moving};
  const IcpSums sums = icp_sums(at, {KernelKind::kNone, kernel.sigma_m}, frame, task);
  const IcpDirections directions = icp_directions(sums, state.over_noise);
  const bool by_planes =
      heard.metric == IcpMetric::kPointToPlane;  // else the sigma of each pair is in the scores
  if (by_planes) out.sigma0 = sigma0_of(at, kernel.sigma_m, task);
  out.redundancy = static_cast<double>(sums.pairs) - 6;
  // 2. The covariance in lengths: of patches, or N^-1 scatter N^-1 of pairs.
  Square<6> scaled;
  if (state.patches.patches > 0) {
    scaled = patch_covariance(state.patches, directions);
  } else {
    const Square<6> scatter = pair_scatter(at, frame, kernel, sums, problem.settings.k, task);
    scaled = sandwich<6>(inverse_of(directions), scatter);
    for (double& c : scaled) c *= out.sigma0 * out.sigma0;
  }
  // 3. Its directions, and turns as angles again.
  set_directions(scaled, directions, out);
  const auto& observable = directions.observable;
  const bool open = !std::all_of(observable.begin(), observable.end(), [](bool b) { return b; });
  const auto length = [&](size_t i) { return i < 3 ? frame.extent_m : 1; };
  for (size_t r = 0; r < 6; ++r)
    for (size_t c = 0; c < 6; ++c)
      out.covariance[6 * r + c] = open ? kNaN : scaled[6 * r + c] / (length(r) * length(c));
  return out;
}

}  // namespace jalon
