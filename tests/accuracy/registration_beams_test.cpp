// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Single turns of spinning heads, from two standpoints each: poses against the truth, and what the verdict says. The
// constants of thinning and of steady planes were chosen on two heads, six kinds and seeds 1 to 3.
#include <doctest/doctest.h>

#include <string>

#include "accuracy/beam_scans.h"
#include "accuracy/pair_kinds.h"
#include "accuracy/recipe.h"
#include "registration/icp/icp.h"

namespace jalon::registration_beams_test {

using namespace jalon::test;

namespace {

constexpr size_t kLeastPoints = 5000;  // of a turn; with fewer the scene is a thing far off
// Drift within a turn and beams out of line leave some centimetres at the farthest point; wrong poses are metres off.
constexpr double kFound_m = 0.1;

struct Tally {
  int begun_near = 0, found = 0;
  int open = 0;  ///< begun near and not found: the result names directions that are not fixed
  int right = 0, accepted = 0;  ///< poses, wherever they were begun
  int wrong = 0, wrong_accepted = 0;

  Tally& operator+=(const Tally& b) {
    begun_near += b.begun_near, found += b.found, open += b.open;
    right += b.right, accepted += b.accepted;
    wrong += b.wrong, wrong_accepted += b.wrong_accepted;
    return *this;
  }
};

/// One kind, one head, one seed: begun near the truth, a quarter of a turn off, and with a scene of another seed.
Tally trial(const PairKind& kind, const BeamHead& head, uint64_t seed) {
  Tally out;
  const bool has_empty = seed % 2 == 0;
  const PairScene scene = kind.make(seed, seed), other = kind.make(seed + 700, seed + 700);
  const StandScan reference = turn_of(head, scene, 0, 10 * seed + 1, has_empty);
  const auto lay = [&](const PairScene& of, size_t standpoint, double turn_rad) {
    const StandScan moving = turn_of(head, of, standpoint, 10 * seed + 2 + standpoint, has_empty);
    if (std::min(reference.cloud->size(), moving.cloud->size()) < kLeastPoints) return;
    const Transform truth = inverse(reference.T_world_scan) * moving.T_world_scan;
    Task task;
    const Registration r =
        register_icp(reference.cloud, moving.cloud,
                     start_near(truth, reference, scene, seed, 0.15, {0, 0, turn_rad}), {}, task);
    const bool is_right = &of == &scene && greatest_miss_m(r.pose, truth, *moving.cloud) < kFound_m;
    const bool is_accepted = r.judgement.verdict == Verdict::kAccepted;
    const bool is_near = &of == &scene && turn_rad == 0;
    out.begun_near += is_near;
    out.found += is_near && is_right;
    out.open += is_near && !is_right && r.unobservable > 0;
    (is_right ? out.right : out.wrong) += 1;
    (is_right ? out.accepted : out.wrong_accepted) += is_accepted;
  };
  lay(scene, 1 + seed % 2, 0);
  lay(scene, 1 + seed % 2, std::numbers::pi / 2);
  lay(other, 1, 0);
  return out;
}

void tell(const char* what, const std::string& of, const Tally& t) {
  MESSAGE("FIGURE beams, " << std::string(what) << ", " << of << ": found " << t.found << " of "
                           << t.begun_near << " begun near, left open " << t.open << "; accepted "
                           << t.accepted << " of " << t.right << " right poses, "
                           << t.wrong_accepted << " of " << t.wrong << " wrong ones");
}

Tally tally_of(std::span<const PairKind> kinds, std::span<const BeamHead> heads,
               uint64_t first_seed, uint64_t seeds, const char* what) {
  Tally all;
  for (const BeamHead& head : heads)
    for (const PairKind& kind : kinds) {
      Tally of_kind;
      for (uint64_t seed = first_seed; seed < first_seed + seeds; ++seed)
        of_kind += trial(kind, head, seed);
      tell(what, std::string(head.name) + ", " + kind.name, of_kind);
      all += of_kind;
    }
  tell(what, "all", all);
  return all;
}

void check(const Tally& all) {
  // Where a head sees the walls alone the height stays open.
  CHECK(all.found >= 0.9 * (all.begun_near - all.open));
  CHECK(all.wrong_accepted <= 0.01 * all.wrong + 3 * std::sqrt(0.01 * all.wrong));
  // The cautious verdict accepts what is plain: a share, that a few draws cannot show.
  if (is_full()) CHECK(all.accepted >= 0.5 * all.right);
}

}  // namespace

TEST_CASE("beams__single_turns_of_heads_and_kinds_developed_with_are_laid_on_each_other") {
  const std::span<const PairKind> kinds = kDevelopedKinds;
  check(is_full()
            ? tally_of(kinds, kDevelopedHeads, 1, 6, "developed")
            : tally_of(kinds.first(1), std::span(kDevelopedHeads).first(1), 1, 2, "developed"));
}

TEST_CASE("beams__single_turns_of_heads_and_kinds_kept_for_the_report_are_too") {
  const std::span<const PairKind> kinds = kReportedKinds;
  check(is_full()
            ? tally_of(kinds, kReportedHeads, 101, 4, "reported")
            : tally_of(kinds.first(2), std::span(kReportedHeads).first(1), 101, 1, "reported"));
}

}  // namespace jalon::registration_beams_test
