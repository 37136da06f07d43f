// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/result.h"

#include <cmath>

#include "base/numbers.h"
#include "base/serial.h"
#include "base/table_columns.h"
#include "registration/icp/covariance.h"

namespace jalon {

namespace {

FieldTable log_table(const std::vector<IcpIteration>& log) {
  FieldTable t;
  add_column<int32_t>(t, log, "level", "", "0: the fewest points",
                      [](const auto& r) { return r.level; });
  add_column<uint64_t>(t, log, "pairs", "", "with a weight, both ways",
                       [](const auto& r) { return r.pairs; });
  add_column<double>(t, log, "kept", "1", "share of the level's moving points that have a pair",
                     [](const auto& r) { return r.kept; });
  add_column<double>(t, log, "rms", "m", "weighted root mean square residual before the step",
                     [](const auto& r) { return r.rms_m; });
  add_column<double>(t, log, "sigma", "m", "1.4826 x median absolute residual",
                     [](const auto& r) { return r.sigma_m; });
  add_column<double>(t, log, "distance", "m", "greatest residual of a pair",
                     [](const auto& r) { return r.distance_m; });
  add_column<double>(t, log, "turn", "rad", "of the step",
                     [](const auto& r) { return r.turn_rad; });
  add_column<double>(t, log, "shift", "m", "of the step, at the centre",
                     [](const auto& r) { return r.shift_m; });
  add_column<uint8_t>(t, log, "observable", "", "directions that the pairs fixed",
                      [](const auto& r) { return r.observable; });
  return t;
}

constexpr size_t kResidualsPerLook = size_t{1} << 16;

struct Residual {
  uint32_t moving, reference;
  float residual_m, weight;
};

FieldTable residual_table(const IcpProblem& problem, const IcpState& state, Task& task) {
  std::vector<Residual> rows;
  const auto of_reference = problem.clouds.reference.tree->order();
  const auto of_moving = problem.clouds.moving.tree->order();
  const Buffer<uint32_t>& near = state.last.neighbours.of_moving;
  const IcpLevel all;
  const IcpPairing at = state.pairing(problem, all);
  IcpPair pair;
  const bool has_all = state.has_all(problem);  // else the iterations ended on few points
  serial_for(task, has_all ? near.size() : 0, kResidualsPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const uint32_t m = static_cast<uint32_t>(i), r = near[i];
      if (r == kNoPoint || !pair_of(at, m, r, PairWay::kForth, pair)) continue;
      rows.push_back({problem.thinned_moving.raw(of_moving[m]),
                      problem.thinned_reference.raw(of_reference[r]),
                      static_cast<float>(pair.residual_m),
                      static_cast<float>(state.last.kernel.weight(pair.residual_m))});
    }
  });
  FieldTable t;
  add_column<uint32_t>(t, rows, "moving", "", "index of the point",
                       [](const Residual& r) { return r.moving; });
  task.checkpoint(0);
  add_column<uint32_t>(t, rows, "reference", "", "index of its partner",
                       [](const Residual& r) { return r.reference; });
  task.checkpoint(0);
  add_column<float>(t, rows, "residual", "m", "moved point above the partner's plane",
                    [](const Residual& r) { return r.residual_m; });
  task.checkpoint(0);
  add_column<float>(t, rows, "weight", "1", "of the kernel",
                    [](const Residual& r) { return r.weight; });
  return t;
}

void set_unknown(Registration& out) {
  out.covariance.fill(kNaN);
  std::array<PoseDirection, 6> directions;
  for (size_t k = 0; k < 6; ++k) {
    directions[k].unit[k] = 1;
    directions[k].sigma_m = kNaN;
    directions[k].observable = false;
  }
  fill_tables(out, directions);
}

}  // namespace

Registration icp_result(const IcpProblem& problem, const IcpState& state, Task& task) {
  Registration out;
  out.pose = problem.clouds.to_world(state.T_reference_moving);
  out.converged = state.stopped == StopReason::kConverged;
  out.stopped = state.stopped;
  const Vec3 world_reference = problem.clouds.reference.tree->cube().origin;
  out.centre = world_reference + problem.frame(state.T_reference_moving).centre;
  out.extent_m = problem.extent_m;
  out.pairs = state.last.sums.pairs;
  out.iterations = state.log.size();
  out.rms_m = state.log.empty() ? 0 : state.log.back().rms_m;
  out.iteration_log = log_table(state.log);
  out.residuals = residual_table(problem, state, task);
  add_value<double>(out.summary, "kept", "1", "share of the moving points that have a pair",
                    state.log.empty() ? 0 : state.log.back().kept);
  add_value<double>(out.summary, "sigma", "m", "of the residuals, robust", state.sigma_m);
  if (!state.has_all(problem) || state.stopped == StopReason::kTooFewPairs) {
    set_unknown(out);
    return out;
  }
  const IcpCovariance found = icp_covariance(problem, state, task);
  add_value<double>(out.summary, "sigma0", "1",
                    "a posteriori: residuals over what the planes' scatter foretells",
                    found.sigma0);
  add_value<uint64_t>(out.summary, "patches", "",
                      "of both clouds that the pose settled on; 0: it rests on pairs",
                      state.patches.patches);
  add_value<double>(out.summary, "redundancy", "", "pairs less unknowns", found.redundancy);
  out.covariance = found.covariance;
  fill_tables(out, found.directions);
  return out;
}

}  // namespace jalon
