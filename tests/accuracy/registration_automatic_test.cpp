// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Scans in frames of their own, laid on each other by "automatic" without a start.
#include <doctest/doctest.h>

#include <span>
#include <string>

#include "accuracy/pair_kinds.h"
#include "accuracy/recipe.h"
#include "registration/automatic.h"

namespace jalon::registration_automatic_test {

using namespace jalon::test;

namespace {

constexpr double kRight_m = 0.05;

struct Tally {
  int pairs = 0, right = 0, accepted = 0, wrong_accepted = 0;
};

void count(const PairKind& kind, uint64_t first_seed, uint64_t seeds, Tally& all) {
  Tally out;
  for (uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    const ScannedPair pair(kind, seed, ScanSettings{}.noise_m);
    Task task;
    const Registration found =
        register_automatic(pair.reference.cloud, pair.moving.cloud, {}, {}, task);
    const bool is_right = greatest_miss_m(found.pose, pair.truth, *pair.moving.cloud) < kRight_m;
    const bool is_accepted = found.judgement.verdict == Verdict::kAccepted;
    ++out.pairs;
    out.right += is_right;
    out.accepted += is_right && is_accepted;
    out.wrong_accepted += !is_right && is_accepted;
  }
  MESSAGE("FIGURE automatic, " << std::string(kind.name) << ": right " << out.right << " of "
                               << out.pairs << ", accepted of them " << out.accepted
                               << ", wrong ones accepted " << out.wrong_accepted);
  all.pairs += out.pairs;
  all.accepted += out.accepted;
  all.wrong_accepted += out.wrong_accepted;
}

// Of wrong poses fewer than 3 in 100 may be accepted (registration_verdict_test.cpp holds more of them), and of pairs
// that overlap by half or more most are found.
void check_kinds(std::span<const PairKind> kinds, uint64_t first_seed) {
  Tally all;
  for (const PairKind& kind : kinds) count(kind, first_seed, is_full() ? 20 : 1, all);
  MESSAGE("FIGURE automatic: right and accepted "
          << all.accepted << " of " << all.pairs << ", wrong ones accepted " << all.wrong_accepted);
  CHECK(all.accepted >= 0.75 * all.pairs);
  CHECK(all.wrong_accepted <= 0.03 * all.pairs);
}

}  // namespace

TEST_CASE("registration_automatic__finds_kinds_developed_with_from_anywhere") {
  check_kinds(kDevelopedKinds, 1);
}
TEST_CASE("registration_automatic__finds_kinds_it_never_saw_from_anywhere") {
  check_kinds(kReportedKinds, 401);
}

}  // namespace jalon::registration_automatic_test
