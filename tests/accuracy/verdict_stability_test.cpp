// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The verdict of the same two scans when their points are jittered, rounded, shuffled, halved, turned or moved to a
// national grid: a right pair and a wrong one of each kind to report. Each change meets every third kind, there
// the right pair or the wrong one; all kinds and both in the long run.
#include <doctest/doctest.h>

#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "accuracy/beam_scans.h"
#include "accuracy/pair_kinds.h"
#include "accuracy/recipe.h"
#include "cloud/select.h"
#include "registration/icp/icp.h"

namespace jalon::verdict_stability_test {

using namespace jalon::test;

namespace {

constexpr uint64_t kSeed = 301;
constexpr double kNoise_m = 0.004;

CloudPtr changed(const Cloud& cloud, const std::function<Vec3(const Vec3&)>& change) {
  Buffer<double> xyz(3 * cloud.size());
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = change(cloud.point(i));
    for (int axis = 0; axis < 3; ++axis) xyz[3 * i + static_cast<size_t>(axis)] = p[axis];
  }
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

CloudPtr picked(const Cloud& cloud, const std::vector<uint64_t>& indices) {
  Task task;
  return std::make_shared<const Cloud>(select(cloud, indices, task));
}

CloudPtr jittered(const Cloud& cloud, double by_m) {
  RandomStream random(kSeed, 9);
  return changed(cloud, [&](const Vec3& p) {
    const Vec3 by{random.normal(), random.normal(), random.normal()};
    return p + by * by_m;
  });
}

CloudPtr rounded(const Cloud& cloud) {
  return changed(cloud, [](const Vec3& p) {
    const auto to_mm = [](double v) { return std::round(1000 * v) / 1000; };
    return Vec3{to_mm(p.x), to_mm(p.y), to_mm(p.z)};
  });
}

CloudPtr shuffled(const Cloud& cloud) {
  RandomStream random(kSeed, 10);
  std::vector<uint64_t> order(cloud.size());
  for (uint64_t i = 0; i < order.size(); ++i) {
    const uint64_t k = random.below(i + 1);
    order[i] = order[k];
    order[k] = i;
  }
  return picked(cloud, order);
}

CloudPtr halved(const Cloud& cloud) {
  std::vector<uint64_t> even;
  for (uint64_t i = 0; i < cloud.size(); i += 2) even.push_back(i);
  return picked(cloud, even);
}

struct Pair {
  CloudPtr reference, moving;
  Transform start, truth;
  double noise_m = kNoise_m;

  Registration registered() const {
    Task task;
    return register_icp(reference, moving, start, {}, task);
  }
  Verdict verdict() const { return registered().judgement.verdict; }
  Pair with(const std::function<CloudPtr(const Cloud&)>& change) const {
    return {change(*reference), change(*moving), start, truth, noise_m};
  }
  /// Both clouds moved alike.
  Pair moved(const Transform& by) const {
    const auto move = [&](const Cloud& c) {
      return changed(c, [&](const Vec3& p) { return by.point(p); });
    };
    return {move(*reference), move(*moving), by * start * inverse(by), by * truth * inverse(by),
            noise_m};
  }
};

Pair pair_of(const PairKind& kind, uint64_t contents) {
  ScanSettings scanner;
  scanner.noise_m = kNoise_m;
  const PairScene scene = kind.make(kSeed, kSeed);
  const StandScan reference = scan_from(scene, 0, scanner, 1);
  const StandScan moving = scan_from(kind.make(contents, contents), 1, scanner, 2);
  const Transform truth = inverse(reference.T_world_scan) * moving.T_world_scan;
  return {reference.cloud, moving.cloud, start_near(truth, reference, scene, kSeed, 0.05), truth};
}

/// Single turns of a head.
Pair pair_of_turns(const PairKind& kind, const BeamHead& head) {
  const PairScene scene = kind.make(kSeed, kSeed);
  const StandScan reference = turn_of(head, scene, 0, 1), moving = turn_of(head, scene, 1, 2);
  const Transform truth = inverse(reference.T_world_scan) * moving.T_world_scan;
  return {reference.cloud, moving.cloud, start_near(truth, reference, scene, kSeed, 0.15), truth,
          head.noise_m};
}

struct Change {
  const char* name;
  Pair (*make)(const Pair&);
};
constexpr Change kChanges[] = {
    {"jittered by a tenth of the noise",
     [](const Pair& p) {
       return p.with([&](const Cloud& c) { return jittered(c, 0.1 * p.noise_m); });
     }},
    {"rounded to millimetres", [](const Pair& p) { return p.with(rounded); }},
    {"shuffled", [](const Pair& p) { return p.with(shuffled); }},
    {"halved", [](const Pair& p) { return p.with(halved); }},
    {"turned",
     [](const Pair& p) {
       return p.moved(motion_about({}, {0, 0, 0.7}, {}));
     }},
    {"on a national grid", [](const Pair& p) {
       return p.moved(motion_about({}, {}, {652000, 6862000, 120}));
     }}};

}  // namespace

TEST_CASE(
    "verdict__stays_when_points_are_jittered_rounded_shuffled_halved_turned_or_far_from_the_"
    "origin") {
  constexpr size_t kTurns = 3;
  int checked = 0;
  size_t turn = 0;
  for (const PairKind& kind : kReportedKinds) {
    const Pair right = pair_of(kind, kSeed), wrong = pair_of(kind, kSeed + 1);
    CAPTURE(std::string(kind.name));
    CHECK(right.verdict() == Verdict::kAccepted);
    CHECK(wrong.verdict() != Verdict::kAccepted);
    ++turn;
    for (size_t c = 0; c < std::size(kChanges); ++c) {
      if (!is_full() && c % kTurns != turn % kTurns) continue;
      const Change& change = kChanges[c];
      CAPTURE(std::string(change.name));
      const bool is_rights_turn = (c / kTurns + turn) % 2 == 0;
      if (is_full() || is_rights_turn)
        CHECK(change.make(right).verdict() == Verdict::kAccepted), ++checked;
      if (is_full() || !is_rights_turn)
        CHECK(change.make(wrong).verdict() != Verdict::kAccepted), ++checked;
    }
  }
  MESSAGE("FIGURE verdict, changes of the points looked at: " << checked);
}

// Halved, heads lose every other of their beams: the order of points is that of the pulses.
TEST_CASE("verdict__and_pose_stay_when_the_points_of_spinning_heads_are_changed") {
  constexpr double kFound_m = 0.1;  // as in registration_beams_test.cpp
  const PairKind& columns = kReportedKinds[1];
  const std::span<const BeamHead> heads(kReportedHeads);
  int found = 0, same = 0, runs = 0;
  for (const BeamHead& head : is_full() ? heads : heads.subspan(1, 1)) {
    const Pair pair = pair_of_turns(columns, head);
    const Verdict as_it_is = pair.verdict();
    for (const Change& change : kChanges) {
      const Pair changed = change.make(pair);
      const Registration r = changed.registered();
      const double miss_m = greatest_miss_m(r.pose, changed.truth, *changed.moving);
      MESSAGE("FIGURE verdict, turns of " << std::string(head.name) << ", "
                                          << std::string(change.name) << ": " << 1e3 * miss_m
                                          << " mm, confidence " << r.judgement.confidence);
      found += miss_m < kFound_m, same += r.judgement.verdict == as_it_is, ++runs;
    }
  }
  CHECK(found == runs);
  CHECK(same == runs);
}

}  // namespace jalon::verdict_stability_test
