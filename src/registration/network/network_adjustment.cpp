// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/network_adjustment.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "base/parallel.h"
#include "registration/network/approximate.h"
#include "registration/network/network_system.h"
#include "registration/targets/snooping.h"

namespace jalon {

namespace {

using Index = Eigen::Index;

constexpr size_t kGrain = 16;              // solutions a chunk: a millisecond of large networks
constexpr double kLeastRedundancy = 1e-9;  // below it no other observation controls this one
constexpr double kFurthest_m = 1e7;        // a step beyond the Earth's radius: it diverges

/// The last equations of an adjustment and their factors.
struct Solution {
  NetworkLinearised equations;
  NetworkSystem system;
  Eigen::VectorXd x;

  Solution(const NetworkProblem& problem, Eigen::VectorXd at)
      : equations(problem, at), system(problem, equations), x(std::move(at)) {}
};

double squares_of(const NetworkLinearised& equations) {
  double sum = 0;
  for (const auto& g : equations.groups) sum += g.residual.dot(g.weight * g.residual);
  return sum;
}

double greatest_move_m(const NetworkProblem& problem, const Eigen::VectorXd& dx) {
  double most = 0;
  for (const auto& point : problem.unknowns.points)
    for (const int u : point)
      if (u != kNoUnknown) most = std::max(most, std::abs(dx[u]));
  return most;
}

// Step 2.
std::unique_ptr<Solution> settle(const NetworkProblem& problem, NetworkAdjustment& made,
                                 Task& task) {
  made.steps_m.clear();
  made.is_converged = false;
  auto at = std::make_unique<Solution>(problem, problem.start());
  for (int i = 0; i < problem.settings.most_iterations && !made.is_converged; ++i) {
    task.checkpoint(0);
    const Eigen::VectorXd dx = at->system.step();
    const double move_m = greatest_move_m(problem, dx);
    if (!(move_m < kFurthest_m))
      fail(Status::kDegenerate, "the network's adjustment diverges: sights contradict each other");
    made.steps_m.push_back(move_m);
    made.is_converged = move_m <= problem.settings.tolerance_m;
    at = std::make_unique<Solution>(problem, at->x + dx);
  }
  return at;
}

// Steps 3 and 4 of one group: Q_v = C - A Q A^T, tested by P v and P Q_v P.
void test_group(const NetworkLinearised::Group& group, const Solution& at, const Snooping& snooping,
                std::vector<AdjustedObservation>& out) {
  const auto n = static_cast<Index>(group.members.size());
  Eigen::MatrixXd cofactor = group.covariance;
  for (Index j = 0; j < n; ++j) {
    const SparseRow& row = at.equations.rows[group.members[static_cast<size_t>(j)]];
    const Eigen::VectorXd q = at.system.solve(row.dense(at.x.size()));
    for (Index i = 0; i < n; ++i)
      cofactor(i, j) -= at.equations.rows[group.members[static_cast<size_t>(i)]].times(q);
  }
  const Eigen::MatrixXd shown = cofactor.lazyProduct(group.weight),
                        control = group.weight.lazyProduct(shown);
  const Eigen::VectorXd weighted = group.weight * group.residual;
  for (Index i = 0; i < n; ++i) {
    AdjustedObservation& o = out[group.members[static_cast<size_t>(i)]];
    o.sigma = std::sqrt(group.covariance(i, i));
    o.redundancy = std::clamp(shown(i, i), 0.0, 1.0);
    if (!(control(i, i) > kLeastRedundancy * group.weight(i, i))) continue;
    const double w = -weighted[i] / std::sqrt(control(i, i));
    if (snooping.sigma0() > 0) o.normalised = w / snooping.sigma0();
    o.p_value = snooping.p_value(w * w, 1);
    o.is_outlier = o.p_value < snooping.significance();
    o.detectable = snooping.sigma0() * std::sqrt(snooping.needed(1) / control(i, i));
  }
}

// One that takes no part: how far off the others foretell it.
void test_rejected(const NetworkProblem& problem, uint32_t number, const Solution& at,
                   const Snooping& snooping, AdjustedObservation& o) {
  const Eigen::MatrixXd own = problem.covariance({{number}}, at.x);
  const SparseRow& row = at.equations.rows[number];
  const double variance = own(0, 0) + row.times(at.system.solve(row.dense(at.x.size())));
  o.sigma = std::sqrt(own(0, 0));
  o.redundancy = 1;
  if (snooping.sigma0() > 0) o.normalised = o.residual / std::sqrt(variance) / snooping.sigma0();
  o.p_value = snooping.prediction_p_value(o.residual * o.residual / variance, 1);
  o.is_outlier = true;
  o.detectable = snooping.sigma0() * std::sqrt(snooping.needed(1) * variance);
}

double measured_of(const NetworkProblem& problem, const NetworkObservation& o) {
  const SurveySight& s = problem.survey.sightings[o.sighting];
  switch (o.kind) {
    case ObservationKind::kDirection:
      return s.direction_rad;
    case ObservationKind::kZenith:
      return s.zenith_rad;
    case ObservationKind::kDistance:
      return s.distance_m;
    case ObservationKind::kCentring:
    case ObservationKind::kHeight:
      return 0;
    default:
      return problem.survey.points[o.subject].position[o.axis];
  }
}

void fill_observations(const NetworkProblem& problem, const Solution& at, const Snooping& snooping,
                       NetworkAdjustment& made, Task& task) {
  made.observations.assign(problem.observations.size(), {});
  for (uint32_t i = 0; i < problem.observations.size(); ++i) {
    made.observations[i].measured = measured_of(problem, problem.observations[i]);
    made.observations[i].residual = -at.equations.residual[static_cast<Index>(i)];
    if (!problem.observations[i].is_used)
      test_rejected(problem, i, at, snooping, made.observations[i]);
  }
  parallel_for(task, at.equations.groups.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t g = begin; g < end; ++g)
      test_group(at.equations.groups[g], at, snooping, made.observations);
  });
}

void fill_points(const NetworkProblem& problem, const Solution& at, double sigma0,
                 NetworkAdjustment& made, Task& task) {
  made.points.assign(problem.survey.points.size(), {});
  parallel_for(task, made.points.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) {
      const auto& unknowns = problem.unknowns.points[p];
      made.points[p].position = problem.place(static_cast<uint32_t>(p), at.x);
      for (size_t j = 0; j < 3; ++j) {
        if (unknowns[j] == kNoUnknown) continue;
        const Eigen::VectorXd q = at.system.solve(Eigen::VectorXd::Unit(at.x.size(), unknowns[j]));
        for (size_t i = 0; i < 3; ++i)
          if (unknowns[i] != kNoUnknown)
            made.points[p].covariance_m2[3 * i + j] = sigma0 * sigma0 * q[unknowns[i]];
      }
    }
  });
}

// The worst outlier among what was measured or given; centrings are expectations, not measurements.
std::optional<size_t> worst_of(const NetworkProblem& problem, const NetworkAdjustment& made) {
  std::optional<size_t> worst;
  for (size_t i = 0; i < made.observations.size(); ++i) {
    const NetworkObservation& kind = problem.observations[i];
    const AdjustedObservation& o = made.observations[i];
    if (!kind.is_used || !o.is_outlier || kind.kind >= ObservationKind::kCentring) continue;
    if (!worst || std::abs(o.normalised) > std::abs(made.observations[*worst].normalised))
      worst = i;
  }
  return worst;
}

void adjust_once(const NetworkProblem& problem, NetworkAdjustment& made, Task& task) {
  const std::unique_ptr<Solution> at = settle(problem, made, task);
  made.unknowns = problem.unknowns.count;
  made.defect = at->system.defect();
  const auto used = std::count_if(problem.observations.begin(), problem.observations.end(),
                                  [](const NetworkObservation& o) { return o.is_used; });
  made.redundancy = static_cast<int>(used) - made.unknowns + made.defect;
  if (problem.settings.snooping.estimated() && made.redundancy < 1)
    fail(Status::kInsufficientData,
         "sigma0=estimated needs more observations than unknowns: there are none to spare");
  made.weighted_squares = squares_of(at->equations);
  const Snooping snooping(problem.settings.snooping, made.weighted_squares, made.redundancy);
  made.sigma0 = snooping.sigma0();
  made.p_value = variance_factor_p_value(made.weighted_squares, made.redundancy);
  fill_observations(problem, *at, snooping, made, task);
  fill_points(problem, *at, made.sigma0, made, task);
}

}  // namespace

NetworkAdjustment adjust_network(Survey survey, const NetworkSettings& settings, Task& task) {
  if (survey.sightings.empty())
    fail(Status::kInsufficientData, "the list of observations has none");
  place_points(survey, settings);
  NetworkProblem problem(survey, settings);
  NetworkAdjustment made;
  for (;;) {
    adjust_once(problem, made, task);
    const auto worst = settings.reject ? worst_of(problem, made) : std::nullopt;
    if (!worst) break;
    problem.observations[*worst].is_used = false;
    ++made.rejected;
  }
  made.kinds = problem.observations;
  made.survey = std::move(survey);
  return made;
}

}  // namespace jalon
