// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The kinds of scenes that pairs of scans are drawn from: those that constants were chosen with, and those to report.

#include "accuracy/pair_scenes.h"
#include "accuracy/pair_scenes_reported.h"
#include "accuracy/registration_pairs.h"

namespace jalon::test {

struct PairKind {
  const char* name;
  PairScene (*make)(uint64_t seed, uint64_t contents);  ///< other contents are another floor
};
template <PairScene (*Make)(uint64_t)>
PairScene without_contents(uint64_t seed, uint64_t) {
  return Make(seed);
}

inline constexpr PairKind kDevelopedKinds[] = {
    {"crossing", without_contents<crossing>}, {"room", furnished},
    {"boulders", without_contents<boulders>}, {"front", front},
    {"corridor", corridor_with_doors},        {"thing", without_contents<thing>}};
inline constexpr PairKind kReportedKinds[] = {{"plant", without_contents<plant>},
                                              {"columns", columns},
                                              {"wood", without_contents<wood>},
                                              {"machine", without_contents<machine>},
                                              {"stairs", without_contents<stairs>}};

/// Two scans of one scene, each in a frame of its own, and how they lie.
struct ScannedPair {
  PairScene scene;
  StandScan reference, moving;
  Transform truth;  ///< T_reference_moving

  ScannedPair(const PairKind& kind, uint64_t seed, double noise_m) : scene(kind.make(seed, seed)) {
    ScanSettings scanner;
    scanner.noise_m = noise_m;
    reference = scan_from(scene, 0, scanner, 10 * seed + 1);
    moving = scan_from(scene, 1 + seed % 2, scanner, 10 * seed + 2);
    truth = inverse(reference.T_world_scan) * moving.T_world_scan;
  }
};

/// Two degrees turned and `shift_m` away from a pose, in each direction as the seed draws it; then by `more`.
inline Transform start_near(const Transform& T_reference_moving, const StandScan& reference,
                            const PairScene& scene, uint64_t seed, double shift_m,
                            const Vec3& more_turn_rad = {}, const Vec3& more_shift_m = {}) {
  constexpr double kTurn_rad = 0.02;
  RandomStream random(seed, 7);
  const Vec3 turn{random.normal(), random.normal(), random.normal()};
  const Vec3 shift{random.normal(), random.normal(), random.normal()};
  const Vec3 centre = inverse(reference.T_world_scan).point(scene.standpoints[0]);
  return motion_about(centre, turn * kTurn_rad + more_turn_rad, shift * shift_m + more_shift_m) *
         T_reference_moving;
}

/// The farthest that a pose puts any point of an even sample from where the truth does.
inline double greatest_miss_m(const Transform& pose, const Transform& truth, const Cloud& moving) {
  double most = 0;
  for (size_t i = 0; i < moving.size(); i += moving.size() / 100 + 1)
    most = std::max(most, norm(pose.point(moving.point(i)) - truth.point(moving.point(i))));
  return most;
}

}  // namespace jalon::test
