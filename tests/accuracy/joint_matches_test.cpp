// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

#include "accuracy/joint_drives.h"

// Matches by rays against perfect ones: a closed street with roofs, ground, and things 5 m high before the houses
// that the model lacks, 5 mm of noise; one setting, the default, for all five scenarios. Developed with seeds from
// 9001 on; the long run has 9101 to 9150; JALON_JOINT_SEEDS=first-last: others. Reported once, unseen, all five
// scenarios (28 Nov 2026): 9824 to 9873 all groups at most 1.20, 9949 to 9998 1.04, 1.01, 1.00, 1.01 and 1.22
// (strips), 10074 to 10123 1.02, 1.01, 1.00, 1.00 and 1.23 (strips). A street each, 9874 to 9898: 1.13 of scenario 2,
// 1.09, of scenario 5 1.21; 9999 to 10023, unseen: blocks of scenario 2 1.67 (along their street, within 3.5 of their
// sigmas: fewer side walls are met than by perfect matches; all else 1.03); 10124 to 10148, unseen: of scenarios 2 to 4
// 1.27 (blocks of 2), all else 1.01. Strips adjusted of those that perfect ones adjust: 99, 99, 93, 92 and 94 in 100.
// Before:
// 9724 to 9773 10.2 by a facade before another on its wall, 9674 to 9723 11.0; a street each, 9724 to 9760: strips of
// scenario 4 5.0, by one on the wall of a strip that had been found on a larger one (strip_search.cpp doubts it now);
// 9874 to 9898: blocks of scenario 2 3.1, driven along their street by strips half on a neighbour's front (weighed in
// the first pass now).

namespace jalon::joint_matches_test {

using namespace jalon::test;

namespace {

SeedRange seeds(SeedRange few = {9001, 9001}, SeedRange many = {9101, 9150}) {
  const bool full = std::getenv("JALON_FULL") != nullptr;
  return seeds_asked_for("JALON_JOINT_SEEDS").value_or(full ? many : few);
}

// Shares of the kerbs that make 10 and 30 in 100 of the points whose rays are cast.
constexpr double kTenth = 0.22, kThird = 0.62;

struct Matched {
  Left rays, perfect, literal;
  double clutter = 0, wrong = 0, wrong_facades = 0, draws = 0, good = 0, converged = 0;

  void draw(const DriveKind& kind, bool with_literal) {
    Task task;
    const DriveScenario made = driven(kind, task);
    JointSettings by_rays = settings_of(kind.sigmas), by_ids = by_rays, plain = by_rays;
    by_ids.matches = JointSettings::Matches::kIds;
    plain.kernel = JointSettings::Kernel::kNone, plain.least_points = 1, plain.sigma_point_m = 0;
    const auto adjusted = [&](const JointSettings& by) {
      return adjust_jointly(made.model, made.cloud, made.trajectory, by, task);
    };
    const JointAdjustment a = adjusted(by_rays);
    const Left one = left_of(a, made), one_perfect = left_of(adjusted(by_ids), made);
    rays.add(one), perfect.add(one_perfect);
    if (with_literal) literal.add(left_of(adjusted(plain), made));
    bool is_good = true;
    for (size_t g = 0; g < kLeftGroups; ++g) is_good &= one.rms(g) <= 1.5 * one_perfect.rms(g);
    draws += 1, good += is_good ? 1 : 0, converged += a.converged ? 1 : 0;
    clutter += clutter_of(a), wrong += a.wrong_share, wrong_facades += a.wrong_facade_share;
  }
  double ratio(size_t g) const { return rays.rms(g) / perfect.rms(g); }

  void tell(const std::string& what, bool with_literal) const {
    std::string text;
    for (size_t g = 0; g < kLeftGroups; ++g) {
      text += std::string(g > 0 ? ", " : "") + kLeftNames[g] + " " + std::to_string(ratio(g)) +
              " of " + std::to_string(perfect.rms(g)) + " m";
      if (with_literal)
        text += " (literal " + std::to_string(literal.rms(g) / perfect.rms(g)) + ")";
    }
    MESSAGE("FIGURE joint matches, ", what, ", ", draws,
            " draws: RMS over that of perfect matches: ", text, "; clutter ", clutter / draws,
            ", wrong strips ", wrong / draws, ", wrong facades ", wrong_facades / draws,
            ", converged ", converged, ", all groups within 1.5 in ", good);
  }
};

Matched over_draws(size_t scenario, double covered, bool with_literal, bool own_street = false) {
  Matched made;
  // 9878: strips half on a neighbour's front drove a block 60 m along its street.
  const SeedRange drawn = own_street ? seeds({9878, 9878}, {9874, 9898}) : seeds();
  for (uint64_t seed = drawn.first; seed <= drawn.last; ++seed) {
    DriveKind kind;
    kind.sigmas = kScenarioSigmas[scenario], kind.seed = seed, kind.covered = covered;
    kind.own_street = own_street;
    made.draw(kind, with_literal);
  }
  return made;
}

}  // namespace

TEST_CASE("joint_matches__by_rays__come_near_to_perfect_ones_in_five_scenarios") {
  for (size_t scenario = 0; scenario < kScenarioSigmas.size(); ++scenario) {
    CAPTURE(scenario + 1);
    const Matched made = over_draws(scenario, kTenth, true);
    made.tell("scenario " + std::to_string(scenario + 1), true);
    CHECK(made.clutter >= 0.1 * made.draws);
    for (size_t g = 0; g < kLeftGroups; ++g) CHECK(made.ratio(g) <= 1.5);
  }
}

// Houses of other widths, set-backs, turns and heights for each draw; what is left against perfect matches is printed.
TEST_CASE("joint_matches__in_a_street_of_their_own__leave_model_and_drive_as_near") {
  for (const size_t scenario : {1u, 2u, 3u}) {
    CAPTURE(scenario + 1);
    const Matched made = over_draws(scenario, kTenth, false, true);
    made.tell("a street each, scenario " + std::to_string(scenario + 1), false);
    for (const size_t g : {kOfTrajectory, kOfBlocks}) CHECK(made.ratio(g) <= 1.5);
  }
}

// What is left against perfect matches is printed; a single draw may have twice of it.
TEST_CASE("joint_matches__with_30_percent_clutter__still_bring_facades_nearer") {
  const Matched made = over_draws(4, kThird, false);
  made.tell("30 % clutter, scenario 5", false);
  CHECK(made.clutter >= 0.3 * made.draws);
  CHECK(made.rays.rms(kOfFacades) < 2 * made.perfect.rms(kOfFacades));
}

}  // namespace jalon::joint_matches_test
