// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/tables.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/table_columns.h"
#include "registration/registration_tables.h"

namespace jalon {

namespace {

void fill(double* out, const Vec3& v) { out[0] = v.x, out[1] = v.y, out[2] = v.z; }
void fill(double* out, const std::array<double, 3>& v) { std::copy(v.begin(), v.end(), out); }

FieldTable residual_table(const TargetSolution& solution) {
  FieldTable table;
  const auto& rows = solution.pairs;
  using Row = const TestedPair&;
  const double sigma0 = solution.sigma0;
  add_column<uint64_t>(table, rows, "reference", "", "index of the reference target",
                       [](Row r) { return r.pair.reference; });
  add_column<uint64_t>(table, rows, "moving", "", "index of the moving target",
                       [](Row r) { return r.pair.moving; });
  add_columns<double, 3>(table, rows, "residual", "m", "moved minus reference",
                         [](Row r, double* out) { fill(out, r.residual_m); });
  add_columns<double, 3>(table, rows, "sigma", "m", "standard deviation of the residual",
                         [&](Row r, double* out) {
                           for (size_t i = 0; i < 3; ++i)
                             out[i] = sigma0 * std::sqrt(std::max(0.0, r.cofactor[4 * i]));
                         });
  add_columns<double, 3>(table, rows, "redundancy", "1",
                         "share of an error that shows in the residual",
                         [](Row r, double* out) { fill(out, r.test.redundancy); });
  add_columns<double, 3>(table, rows, "normalised", "1",
                         "residual over its standard deviation (Baarda's w)",
                         [](Row r, double* out) { fill(out, r.test.normalised); });
  add_columns<double, 3>(table, rows, "detectable", "m",
                         "smallest error along an axis that the test finds",
                         [](Row r, double* out) { fill(out, r.test.detectable_m); });
  add_column<double>(table, rows, "p_value", "1",
                     "chance of a target as far off as this by noise alone",
                     [](Row r) { return r.test.p_value; });
  add_column<uint8_t>(table, rows, "outlier", "", "1: the test rejects the target",
                      [](Row r) { return r.test.outlier; });
  add_column<uint8_t>(table, rows, "removed", "", "1: it took no part in the pose",
                      [](Row r) { return r.removed; });
  return table;
}

FieldTable step_table(const TargetAdjustment& adjustment) {
  FieldTable table;
  const auto& steps = adjustment.steps;
  add_column<double>(table, steps, "weighted_squares", "1",
                     "sum of the weighted squared residuals before the step",
                     [](const AdjustmentStep& s) { return s.weighted_squares; });
  add_column<double>(table, steps, "step", "1",
                     "length of the step in standard deviations of the pose",
                     [](const AdjustmentStep& s) { return s.step; });
  return table;
}

// Root mean square distance of the targets from their centre in the reference's frame.
double gyration_m(const TargetSolution& solution) {
  double sum = 0;
  for (const TargetPair& pair : solution.used)
    sum += squared_norm(solution.adjustment.T_reference_moving.point(pair.moving) -
                        solution.adjustment.centre);
  return std::sqrt(sum / static_cast<double>(solution.used.size()));
}

FieldTable global_columns(const TargetSets& sets, const TargetSolution& solution,
                          const TargetSettings& setting) {
  const TargetAdjustment& a = solution.adjustment;
  FieldTable table;
  const uint64_t pairs = solution.pairs.size();
  add_value<uint64_t>(table, "removed", "", "outliers that were taken away", solution.removed);
  add_value<uint64_t>(table, "unpaired_reference", "", "reference targets without a partner",
                      sets.reference.size() - pairs);
  add_value<uint64_t>(table, "unpaired_moving", "", "moving targets without a partner",
                      sets.moving.size() - pairs);
  add_value<uint64_t>(table, "redundancy", "", "observations more than unknowns",
                      static_cast<uint64_t>(a.redundancy));
  const double factor = a.redundancy > 0 ? std::sqrt(a.weighted_squares / a.redundancy) : kNaN;
  add_value<double>(table, "sigma0", "1",
                    "of unit weight, by the residuals: 1 where covariances are right", factor);
  add_value<uint8_t>(table, "sigma0_estimated", "", "1: the covariance is scaled by it",
                     setting.snooping.estimated());
  const double p = variance_factor_p_value(a.weighted_squares, a.redundancy);
  add_value<double>(table, "global_p_value", "1", "of the test of sigma0 against 1, two-sided", p);
  add_value<uint8_t>(table, "global_accepted", "", "1: residuals and covariances agree",
                     p >= setting.snooping.significance);
  add_value<double>(table, "scale_sigma", "1",
                    "standard deviation of the scale; 0 for a rigid motion",
                    a.scale * solution.sigma0 * std::sqrt(std::max(0.0, a.cofactor[48])));
  return table;
}

}  // namespace

void describe_targets(const TargetSets& sets, const TargetSolution& solution,
                      const TargetSettings& setting, Registration& out) {
  const TargetAdjustment& a = solution.adjustment;
  out.pose = placed(a.T_reference_moving, sets);
  out.scale = a.scale;
  out.centre = a.centre + sets.reference_origin;
  const double factor = solution.sigma0 * solution.sigma0;
  for (size_t r = 0; r < 6; ++r)
    for (size_t c = 0; c < 6; ++c) out.covariance[6 * r + c] = factor * a.cofactor[7 * r + c];
  out.pairs = solution.used.size();
  out.iterations = a.steps.size();
  double squares = 0;
  for (const PairResidual& pair : a.pairs) squares += squared_norm(pair.residual_m);
  out.rms_m = std::sqrt(squares / static_cast<double>(a.pairs.size()));
  out.extent_m = gyration_m(solution);
  out.residuals = residual_table(solution);
  for (const TestedPair& row : solution.pairs) {
    const Target& target = sets.moving[row.pair.moving];
    out.pair_names.push_back(target.name.empty() ? sets.reference[row.pair.reference].name
                                                 : target.name);
  }
  out.iteration_log = step_table(a);
  out.summary = global_columns(sets, solution, setting);
  fill_tables(out, pose_directions(out.covariance, out.extent_m));
}

}  // namespace jalon
