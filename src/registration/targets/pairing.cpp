// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/pairing.h"

#include <algorithm>
#include <cmath>

#include "base/distributions.h"
#include "base/error.h"
#include "registration/targets/matching.h"

namespace jalon {

namespace {

constexpr double kElsewhere =
    10;  // standard deviations of a target: poses that differ by less are one

struct SolvedWay {
  size_t way;
  TargetAdjustment adjustment;
};

bool has_unnamed(std::span<const Target> targets) {
  return std::any_of(targets.begin(), targets.end(),
                     [](const Target& t) { return t.name.empty(); });
}

std::vector<TargetPair> measured(const TargetSets& sets, std::span<const IndexPair> pairs,
                                 double sigma_m) {
  return measured_pairs(sets.reference, sets.moving, pairs, sets.reference_origin,
                        sets.moving_origin, sigma_m);
}

// Those that give a pose, the best first.
std::vector<SolvedWay> solved(const TargetSets& sets, const Matching& matching,
                              const TargetSettings& setting, Task& task) {
  std::vector<SolvedWay> out;
  std::string why, first;
  for (size_t w = 0; w < matching.ways.size(); ++w) {
    task.checkpoint(0);
    auto adjustment = solve_pairs(measured(sets, matching.ways[w], setting.sigma_m), setting, why);
    if (adjustment) out.push_back({w, std::move(*adjustment)});
    else if (first.empty()) first = why;
  }
  if (out.empty()) fail(Status::kDegenerate, "%s", first.c_str());
  std::stable_sort(out.begin(), out.end(), [](const SolvedWay& a, const SolvedWay& b) {
    return a.adjustment.weighted_squares < b.adjustment.weighted_squares;
  });
  return out;
}

bool puts_elsewhere(const SolvedWay& other, const SolvedWay& best,
                    std::span<const TargetPair> pairs) {
  for (const TargetPair& pair : pairs) {
    double variance = 0;
    for (size_t i = 0; i < 3; ++i)
      variance += pair.reference_covariance[4 * i] + pair.moving_covariance[4 * i];
    const Vec3 apart = other.adjustment.T_reference_moving.point(pair.moving) -
                       best.adjustment.T_reference_moving.point(pair.moving);
    if (norm(apart) > kElsewhere * std::sqrt(variance)) return true;
  }
  return false;
}

// A pose whose residuals the covariances explain may be the true one, however much better another fits: the squares of
// the best are only the least of many. Where they are too large for the covariances themselves, they set the measure.
uint64_t count_solutions(const std::vector<SolvedWay>& ways, std::span<const TargetPair> pairs,
                         const TargetSettings& setting, bool complete) {
  const TargetAdjustment& best = ways[0].adjustment;
  const int redundancy = std::max(1, best.redundancy);
  const double factor = std::max(1.0, best.weighted_squares / redundancy);
  const double limit =
      factor * chi_square_upper_quantile(redundancy, setting.snooping.significance);
  uint64_t out = complete ? 1 : 2;
  std::vector<const SolvedWay*> poses{&ways[0]};
  for (const SolvedWay& way : ways) {
    if (!(way.adjustment.weighted_squares <= limit)) break;
    const bool known = std::any_of(poses.begin(), poses.end(), [&](const SolvedWay* pose) {
      return !puts_elsewhere(way, *pose, pairs);
    });
    if (known) continue;
    poses.push_back(&way);
    ++out;
  }
  return out;
}

}  // namespace

Pairing pair_targets(const TargetSets& sets, const TargetSettings& setting, Task& task) {
  std::vector<IndexPair> named = pairs_by_name(sets.reference, sets.moving);
  if (!has_unnamed(sets.reference) && !has_unnamed(sets.moving)) return {std::move(named), 1};
  if (std::min(sets.reference.size(), sets.moving.size()) < 3)
    fail(Status::kInsufficientData, "%zu and %zu targets; a pose needs 3 on both sides",
         sets.reference.size(), sets.moving.size());
  Matching matching = match_by_distances(sets, named, setting, task);
  if (matching.ways.empty())
    fail(Status::kInsufficientData,
         "no three targets have the same distances on both sides; see match_tolerance_m, or name "
         "them");
  const std::vector<SolvedWay> ways = solved(sets, matching, setting, task);
  std::vector<IndexPair>& best = matching.ways[ways[0].way];
  const auto pairs = measured(sets, best, setting.sigma_m);
  return {std::move(best), count_solutions(ways, pairs, setting, matching.complete)};
}

}  // namespace jalon
