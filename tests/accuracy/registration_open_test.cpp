// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Directions of a pose that the data leave open: what the result says of them, held against what starts far apart
// come to. Coarse noise, since it hides small things from the normals. Scenes to report; developed with were the
// others of pair_kinds.h, seeds 1 to 5.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "accuracy/pair_kinds.h"
#include "accuracy/recipe.h"
#include "registration/icp/icp.h"

namespace jalon::registration_open_test {

using namespace jalon::test;

namespace {

constexpr double kNoise_m = 0.010;

Registration laid_from(const ScannedPair& pair, double shift_m, uint64_t seed) {
  Task task;
  return register_icp(pair.reference.cloud, pair.moving.cloud,
                      start_near(pair.truth, pair.reference, pair.scene, seed, shift_m), {}, task);
}

}  // namespace

TEST_CASE("registration_open__no_direction_is_open_in_which_starts_far_apart_come_to_one_pose") {
  int agreeing = 0, open = 0;
  for (const PairKind& kind : kReportedKinds) {
    for (uint64_t seed = 201; seed < 201 + (is_full() ? 20u : 1u); ++seed) {
      const ScannedPair pair(kind, seed, kNoise_m);
      const Registration one = laid_from(pair, 0.05, seed),
                         other = laid_from(pair, 0.25, seed + 1000);
      if (greatest_miss_m(one.pose, other.pose, *pair.moving.cloud) > kNoise_m) continue;
      ++agreeing;
      open += one.unobservable > 0 || other.unobservable > 0;
      CHECK(one.unobservable == other.unobservable);
    }
  }
  MESSAGE("FIGURE icp, noise 10 mm: of " << agreeing << " pairs that two starts agree on, " << open
                                         << " said to be open");
  CHECK(agreeing >= (is_full() ? 80 : 4));
  // Else fewer than 97 % of the right poses could be accepted; of few draws up to three deviations more by chance.
  CHECK(open <= 0.03 * agreeing + 3 * std::sqrt(0.03 * 0.97 * agreeing));
}

}  // namespace jalon::registration_open_test
