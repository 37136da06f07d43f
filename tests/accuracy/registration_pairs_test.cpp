// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Scans of ten kinds of scenes from two standpoints each, in frames of their own: poses against the truth.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "accuracy/pair_kinds.h"
#include "accuracy/recipe.h"
#include "registration/icp/icp.h"

namespace jalon::registration_pairs_test {

using namespace jalon::test;

namespace {

/// The greatest miss of a point, m, of each seed.
std::vector<double> misses_of(const PairKind& kind, uint64_t seeds, double noise_m) {
  std::vector<double> out;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    const ScannedPair pair(kind, seed, noise_m);
    Task task;
    const Registration found =
        register_icp(pair.reference.cloud, pair.moving.cloud,
                     start_near(pair.truth, pair.reference, pair.scene, seed, 0.15), {}, task);
    CAPTURE(std::string(kind.name));
    CAPTURE(seed);
    CHECK(found.converged);
    out.push_back(greatest_miss_m(found.pose, pair.truth, *pair.moving.cloud));
  }
  std::sort(out.begin(), out.end());
  return out;
}

// 20 000 points of 4 mm fix a pose to some tenths of a millimetre; a point far out misses by more.
void check_kind(const PairKind& kind, uint64_t seeds, double noise_m) {
  const std::vector<double> misses = misses_of(kind, seeds, noise_m);
  MESSAGE("FIGURE icp, " << std::string(kind.name) << ", " << seeds
                         << " seeds: greatest miss of a point, median "
                         << 1e3 * misses[misses.size() / 2] << " mm, worst " << 1e3 * misses.back()
                         << " mm");
  CHECK(misses.back() <= noise_m);
}

}  // namespace

TEST_CASE("registration_pairs__kinds_developed_with_are_laid_on_each_other_within_the_noise") {
  for (const PairKind& kind : kDevelopedKinds) check_kind(kind, is_full() ? 20 : 1, 0.004);
}

TEST_CASE("registration_pairs__kinds_kept_for_the_report_are_too") {
  for (const PairKind& kind : kReportedKinds) check_kind(kind, is_full() ? 20 : 1, 0.004);
}

}  // namespace jalon::registration_pairs_test
