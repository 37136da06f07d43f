// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets.h"

#include <cmath>

#include "base/error.h"
#include "registration/target_solution.h"
#include "registration/target_tables.h"

namespace jalon {

namespace {

TargetSetting setting_of(const ParamSet& params) {
  TargetSetting s;
  s.with_scale = params.text("transform") == "similarity";
  s.sigma_m = params.number("sigma_m");
  s.snooping = {params.number("significance"), params.number("power"), params.text("sigma0") == "estimated"};
  s.remove_outliers = params.flag("remove_outliers");
  return s;
}

}  // namespace

std::span<const ParamRow> targets_rows() {
  static constexpr ParamRow kRows[] = {
      choice_row("transform", "rigid", "rigid|similarity", "", "similarity: with a scale of its own."),
      number_row("sigma_m", 0.003, 1e-9, 1e3, "m", "",
                 "Standard deviation of each coordinate of targets that come without a covariance."),
      choice_row("sigma0", "known", "known|estimated", "",
                 "Of unit weight: known, covariances are taken as they stand (Baarda's test); estimated, the residuals "
                 "scale them, so that only their proportions count (Pope's test)."),
      number_row("significance", 0.001, 1e-9, 0.5, "1", "",
                 "Chance that the test of one good target calls it an outlier (Baarda 1968)."),
      number_row("power", 0.8, 0.5, 0.999, "1", "",
                 "Chance that the test finds a blunder of the size given as detectable."),
      bool_row("remove_outliers", false, "",
               "Takes the worst outlier away and adjusts again until none is left; never below 3 pairs."),
  };
  return kRows;
}

Registration register_targets(std::span<const Target> reference, std::span<const Target> moving,
                              const ParamSet& params, Task& task) {
  require_distinct(reference, "reference");
  require_distinct(moving, "moving");
  const TargetSetting setting = setting_of(params);
  const TargetSets sets{reference, moving, origin_of(reference), origin_of(moving)};
  const std::vector<IndexPair> pairs = pairs_by_name(reference, moving);
  const TargetSolution solution = solve_targets(sets, pairs, setting, task);
  Registration out;
  out.converged = solution.adjustment.converged;
  out.stopped = out.converged ? StopReason::kConverged : StopReason::kIterationLimit;
  describe_targets(sets, solution, setting, out);
  return out;
}

}  // namespace jalon
