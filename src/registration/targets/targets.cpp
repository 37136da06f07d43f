// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/targets.h"

#include "base/table_columns.h"
#include "registration/targets/pairing.h"
#include "registration/targets/solution.h"
#include "registration/targets/tables.h"

namespace jalon {

namespace {

TargetSetting setting_of(const ParamSet& params) {
  TargetSetting s;
  s.with_scale = params.text("transform") == "similarity";
  s.sigma_m = params.number("sigma_m");
  s.snooping = {params.number("significance"), params.number("power"), params.text("sigma0") == "estimated"};
  s.remove_outliers = params.flag("remove_outliers");
  s.match_tolerance_m = params.number("match_tolerance_m");
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
      number_row("match_tolerance_m", 0, 0, 1e3, "m", "",
                 "Distances of unnamed targets that differ by no more are the same; 0: 4 standard deviations."),
  };
  return kRows;
}

Registration register_targets(std::span<const Target> reference, std::span<const Target> moving,
                              const ParamSet& params, Task& task) {
  require_distinct(reference, "reference");
  require_distinct(moving, "moving");
  const TargetSetting setting = setting_of(params);
  const TargetSets sets{reference, moving, origin_of(reference), origin_of(moving)};
  const Pairing pairing = pair_targets(sets, setting, task);
  const TargetSolution solution = solve_targets(sets, pairing.pairs, setting, task);
  Registration out;
  out.converged = solution.adjustment.converged && pairing.solutions == 1;
  out.stopped = pairing.solutions > 1 ? StopReason::kAmbiguous
                : out.converged       ? StopReason::kConverged
                                      : StopReason::kIterationLimit;
  describe_targets(sets, solution, setting, out);
  add_value<uint64_t>(out.summary, "solutions", "", "poses that pair the targets about as well: 1 is unique",
                      pairing.solutions);
  return out;
}

}  // namespace jalon
