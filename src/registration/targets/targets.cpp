// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/targets.h"

#include "base/setting_rows.h"
#include "base/table_columns.h"
#include "registration/registration_tables.h"
#include "registration/targets/pairing.h"
#include "registration/targets/snooping_rows.h"
#include "registration/targets/solution.h"
#include "registration/targets/tables.h"

namespace jalon {

namespace {

constexpr auto kTargetsRows = setting_rows(
    choice_row<&TargetSettings::transform>("transform", "rigid|similarity", "",
                                           "similarity: with a scale of its own."),
    number_row<&TargetSettings::sigma_m>(
        "sigma_m", 1e-9, 1e3, "m", "",
        "Standard deviation of each coordinate of targets that come without a covariance."),
    nested_rows<&TargetSettings::snooping, kSnoopingRows>(),
    bool_row<&TargetSettings::remove_outliers>(
        "remove_outliers", "",
        "Takes the worst outlier away and adjusts again until none is left; never below 3 "
        "pairs."),
    number_row<&TargetSettings::match_tolerance_m>(
        "match_tolerance_m", 0, 1e3, "m", "",
        "Distances of unnamed targets that differ by no more are the same; 0: 4 standard "
        "deviations."));

PoseJudgement judgement_of_targets(const Registration& found) {
  PoseJudgement out = judgement_of_search(found.stopped);
  if (out.verdict != Verdict::kNone) return out;
  if (found.unobservable > 0) out.add_reason("directions of the pose are not fixed");
  if (found.summary.require("global_accepted").values<uint8_t>()[0] == 0)
    out.add_reason("the residuals do not agree with the covariances of the targets");
  out.verdict = out.reasons.empty() ? Verdict::kAccepted : Verdict::kDoubtful;
  return out;
}

}  // namespace

std::span<const ParamRow> targets_rows() { return kTargetsRows; }

Registration register_targets(std::span<const Target> reference, std::span<const Target> moving,
                              const TargetSettings& settings, Task& task) {
  require_distinct(reference, "reference");
  require_distinct(moving, "moving");
  const TargetSets sets{reference, moving, origin_of(reference), origin_of(moving)};
  const Pairing pairing = pair_targets(sets, settings, task);
  const TargetSolution solution = solve_targets(sets, pairing.pairs, settings, task);
  Registration out;
  out.converged = solution.adjustment.converged && pairing.solutions == 1;
  out.stopped = pairing.solutions > 1 ? StopReason::kAmbiguous
                : out.converged       ? StopReason::kConverged
                                      : StopReason::kIterationLimit;
  describe_targets(sets, solution, settings, out);
  add_value<uint64_t>(out.summary, "solutions", "",
                      "poses that pair the targets about as well: 1 is unique", pairing.solutions);
  fill_judgement(out, judgement_of_targets(out));
  return out;
}

}  // namespace jalon
