// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/joint_adjustment.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

#include "base/error.h"
#include "model/part_classes.h"
#include "registration/joint/adjusted.h"
#include "scan/mobile/drive_scenario.h"

using namespace jalon;

namespace {

JointSettings settings_of(const DriveScenarioSettings& from) {
  const ScenarioSigmas sigmas = sigmas_of(from);
  JointSettings made;
  made.sigma_block_x_m = made.sigma_block_y_m = sigmas.block_m;
  made.sigma_facade_m = sigmas.facade_m, made.sigma_strip_m = sigmas.strip_m;
  return made;
}

// Squares of errors, summed over draws: what is left of trajectory, blocks, facades, and the strips that were adjusted.
struct Left {
  double sum = 0, n = 0;
  void add(double e) { sum += e * e, n += 1; }
  void add(const Vec2& e) { add(e.u), add(e.v); }
  double rms() const { return std::sqrt(sum / n); }
};
struct Errors {
  Left group[4];
  void add(const JointAdjustment& a, const DriveScenario& s) {
    for (size_t c = 0; c < a.trajectory.by_m.size(); ++c)
      group[0].add(s.trajectory_errors.by_m[c] + a.trajectory.by_m[c]);
    for (size_t b = 0; b < a.model.blocks.size(); ++b)
      group[1].add(s.offsets.blocks[b] + a.model.blocks[b]);
    for (size_t f = 0; f < a.model.facades.size(); ++f)
      group[2].add(s.offsets.facades[f] + a.model.facades[f]);
    for (size_t i = 0; i < a.model.strips.size(); ++i)
      if (a.strip_points[i] > 0) group[3].add(s.offsets.strips[i] + a.model.strips[i]);
  }
};

DriveScenarioSettings small_drive() {
  DriveScenarioSettings from;
  from.leg_m = 60;
  from.revolutions_per_s = 10, from.pulses = 400;
  return from;
}

// Of those that points hold, the one that is moved most.
size_t farthest_strip(const DriveScenario& made, const JointSettings& settings, Task& task) {
  const JointAdjustment a = adjust_jointly(made.model, made.cloud, made.trajectory, settings, task);
  size_t farthest = 0;
  for (size_t s = 0; s < a.model.strips.size(); ++s)
    if (a.strip_points[s] > 0 && std::fabs(a.model.strips[s]) > std::fabs(a.model.strips[farthest]))
      farthest = s;
  return farthest;
}

void refuses(const DriveScenario& drive, const Cloud& cloud, const Trajectory& trajectory,
             const char* words) {
  Task task;
  try {
    adjust_jointly(drive.model, cloud, trajectory, {}, task);
    FAIL("not refused");
  } catch (const Error& e) {
    CHECK(std::string(e.what()).find(words) != std::string::npos);
  }
}

}  // namespace

// Roofs, ground, vans and kiosks that the model lacks, 5 mm of noise; one setting for all five scenarios.
TEST_CASE("adjust_jointly__by_rays__comes_near_to_perfect_matches") {
  const uint64_t draws = std::getenv("JALON_FULL") != nullptr ? 50 : 1;
  for (int64_t scenario = 1; scenario <= 5; ++scenario) {
    DriveScenarioSettings from;
    from.scenario = scenario;
    from.closed = true;
    from.noise_range_m = 0.005;
    Errors real, perfect;
    Left wrong, wrong_facades;
    uint64_t converged = 0, good = 0;
    for (uint64_t draw = 0; draw < draws; ++draw) {
      from.seed = 9001 + draw;
      Task task;
      const DriveScenario made = drive_scenario(from, task);
      JointSettings by_rays = settings_of(from), by_ids = by_rays;
      by_ids.matches = JointSettings::Matches::kIds;
      const JointAdjustment rays =
          adjust_jointly(made.model, made.cloud, made.trajectory, by_rays, task);
      const JointAdjustment ids =
          adjust_jointly(made.model, made.cloud, made.trajectory, by_ids, task);
      Errors one, one_perfect;
      one.add(rays, made), one_perfect.add(ids, made);
      bool is_good = true;
      for (int g = 0; g < 4; ++g) is_good &= one.group[g].rms() <= 1.5 * one_perfect.group[g].rms();
      good += is_good ? 1 : 0;
      real.add(rays, made), perfect.add(ids, made);
      wrong.add(rays.wrong_share), wrong_facades.add(rays.wrong_facade_share);
      converged += rays.converged ? 1 : 0;
    }
    const auto ratio = [&](int g) { return real.group[g].rms() / perfect.group[g].rms(); };
    MESSAGE("FIGURE joint by rays, scenario ", scenario, ", ", draws,
            " draws: RMS against perfect matches: trajectory ", ratio(0), ", blocks ", ratio(1),
            ", facades ", ratio(2), ", strips ", ratio(3), "; wrong strips ", wrong.rms(),
            ", wrong facades ", wrong_facades.rms(), " (RMS over draws); converged ", converged,
            ", all four within 1.5 in ", good, " draws; perfect ", perfect.group[0].rms(), " ",
            perfect.group[1].rms(), " ", perfect.group[2].rms(), " ", perfect.group[3].rms(), " m");
    CHECK(ratio(0) <= 1.5);
    CHECK(ratio(2) <= 1.5);
    CHECK(ratio(1) <= 1.5);
    CHECK(2 * good >= draws);
  }
}

TEST_CASE("adjust_jointly__of_a_straight_street__names_the_direction_along_it") {
  DriveScenarioSettings from = small_drive();
  Task task;
  const auto adjusted = [&](bool corner) {
    from.corner = corner;
    const DriveScenario made = drive_scenario(from, task);
    return adjust_jointly(made.model, made.cloud, made.trajectory, settings_of(from), task);
  };
  const JointAdjustment straight = adjusted(false), bent = adjusted(true);
  CHECK(straight.weak_share < kHeldShare);
  CHECK(std::fabs(straight.weak_direction.u) > 0.99);  // it runs east
  CHECK(bent.weak_share > 10 * kHeldShare);
  // Along it the trajectory keeps most of its prior sigma.
  CHECK(straight.trajectory_sigmas[3].u > 0.5 * straight.trajectory_priors[3].u);
  CHECK(straight.trajectory_sigmas[3].v < 0.5 * straight.trajectory_priors[3].v);
}

TEST_CASE("adjust_jointly__with_any_number_of_threads__gives_the_same_bits") {
  Task one(Task::Hooks{.threads = 1}), two(Task::Hooks{.threads = 2}),
      seven(Task::Hooks{.threads = 7});
  const DriveScenarioSettings from = small_drive();
  const DriveScenario made = drive_scenario(from, one);
  const auto run = [&](Task& task) {
    return adjust_jointly(made.model, made.cloud, made.trajectory, settings_of(from), task);
  };
  const JointAdjustment a = run(one);
  for (const JointAdjustment& b : {run(two), run(seven)}) {
    CHECK(a.model.strips == b.model.strips);
    CHECK(a.strip_sigmas == b.strip_sigmas);
    CHECK(a.trajectory.by_m == b.trajectory.by_m);
    CHECK(a.weights == b.weights);
    CHECK(a.chi_square == b.chi_square);
  }
}

// Ids are right: a strip that stands far off does so, however rare that is.
TEST_CASE("adjust_jointly__by_ids__leaves_a_strip_where_its_points_are") {
  DriveScenarioSettings from = small_drive();
  from.scenario = 4;
  Task task;
  const DriveScenario made = drive_scenario(from, task);
  JointSettings settings = settings_of(from);
  settings.matches = JointSettings::Matches::kIds;
  const size_t farthest = farthest_strip(made, settings, task);
  const double off = made.offsets.strips[farthest];
  settings.sigma_strip_m = std::fabs(off) / 5;  // of its standard deviations
  const JointAdjustment a = adjust_jointly(made.model, made.cloud, made.trajectory, settings, task);
  CHECK(std::fabs(off) > 3);
  CHECK(std::fabs(off + a.model.strips[farthest]) < 0.1);
}

// By rays it may as well be on the wall of another: it is not adjusted, instead of held between the two.
TEST_CASE("adjust_jointly__by_rays__leaves_strips_that_are_rarely_so_far_off_and_says_which") {
  DriveScenarioSettings from = small_drive();
  from.scenario = 4;
  Task task;
  const DriveScenario made = drive_scenario(from, task);
  JointSettings settings = settings_of(from);
  settings.matches = JointSettings::Matches::kIds;
  const size_t farthest = farthest_strip(made, settings, task);
  settings.sigma_strip_m = std::fabs(made.offsets.strips[farthest]) / 4.5;
  settings.matches = JointSettings::Matches::kRays;
  const JointAdjustment a = adjust_jointly(made.model, made.cloud, made.trajectory, settings, task);
  CHECK(a.converged);
  CHECK(a.strip_is_doubtful[farthest]);
  CHECK(a.strip_points[farthest] == 0);
  CHECK(a.model.strips[farthest] == 0);
  for (size_t s = 0; s < a.model.strips.size(); ++s)
    if (a.strip_points[s] > 0) CHECK(std::fabs(made.offsets.strips[s] + a.model.strips[s]) < 0.15);
}

TEST_CASE("adjust_jointly__with_wrong_priors__fails_its_test_of_the_model") {
  DriveScenarioSettings from = small_drive();
  Task task;
  const DriveScenario made = drive_scenario(from, task);
  JointSettings right = settings_of(from), wrong = right;
  wrong.sigma_strip_m = right.sigma_strip_m / 3;
  const auto p = [&](const JointSettings& s) {
    return adjust_jointly(made.model, made.cloud, made.trajectory, s, task).p_value;
  };
  CHECK(p(right) > 0.001);
  CHECK(p(wrong) < 1e-6);
}

// A drive that is 0.4 m too high over its whole length, above a model with ground.
TEST_CASE("adjust_jointly__with_ground__brings_drive_and_cloud_to_its_height") {
  DriveScenarioSettings from = small_drive();
  from.closed = true;
  Task task;
  const DriveScenario made = drive_scenario(from, task);
  Trajectory high = made.trajectory;
  for (Vec3& p : high.positions) p.z += 0.4;
  Buffer<double> xyz(3 * made.cloud.size());
  for (size_t i = 0; i < xyz.size(); ++i) xyz[i] = made.cloud.xyz()[i] + (i % 3 == 2 ? 0.4 : 0);
  Cloud cloud = make_cloud(std::move(xyz));
  cloud.fields = made.cloud.fields;
  JointSettings settings = settings_of(from);
  const JointAdjustment free = adjust_jointly(made.model, cloud, high, settings, task);
  CHECK(free.ground.empty());
  CHECK(free.heights_m[3] == 0);
  CHECK(adjusted_trajectory(free, high).positions[7].z == high.positions[7].z);
  settings.sigma_ground_m = 0.05;
  const JointAdjustment held = adjust_jointly(made.model, cloud, high, settings, task);
  CHECK(held.ground.size() + 3 > held.heights_m.size());
  CHECK(held.trajectory.by_m == free.trajectory.by_m);  // walls know nothing of heights
  const Trajectory drive = adjusted_trajectory(held, high);
  const Cloud moved = adjusted_cloud(held, high, cloud, task);
  const auto truth = made.cloud.fields.require("true_xyz").values<double>();
  for (size_t i = 0; i < drive.size(); i += 37) {
    CHECK(std::fabs(drive.positions[i].z - made.trajectory.positions[i].z) < 0.05);
    CHECK(drive.position_sigmas_m[i].z < 0.06);
    CHECK(drive.position_sigmas_m[i].z < high.position_sigmas_m[i].z);
  }
  for (uint32_t i = 0; i < moved.size(); i += 997)
    CHECK(std::fabs(moved.point(i).z - truth[3 * size_t{i} + 2]) < 0.05);
  DriveScenario bare = made;
  std::erase_if(bare.model.faces, [&](const Face& face) {
    return bare.model.parts[face.part].part_class == part_class::kGround;
  });
  try {
    adjust_jointly(bare.model, cloud, high, settings, task);
    FAIL("not refused");
  } catch (const Error& e) {
    CHECK(std::string(e.what()).find("the model has no ground") != std::string::npos);
  }
}

TEST_CASE("adjust_jointly__of_impossible_input__names_what_is_wrong") {
  Task task;
  const DriveScenario made = drive_scenario(small_drive(), task);
  Cloud bare = made.cloud;
  bare.fields.remove("time");
  refuses(made, bare, made.trajectory, "no field \"time\"");
  Trajectory later = made.trajectory;
  for (double& t : later.times_s) t += 1000;
  refuses(made, made.cloud, later, "no point of the cloud is within the trajectory's time");
  for (double& t : later.times_s) t += 2 * 86400 - 1000;
  refuses(made, made.cloud, later, "later by -172800 s (time_shift_s of its file)");
  Trajectory early = made.trajectory;
  for (double& t : early.times_s) t -= 8;  // 40 m of driving
  refuses(made, made.cloud, early, "are both of one drive and by one clock?");
  Trajectory bold = made.trajectory;
  bold.position_sigmas_m.clear();
  refuses(made, made.cloud, bold, "no sigmas of position");
  DriveScenario plain = made;
  plain.model = Model();
  refuses(plain, made.cloud, made.trajectory, "no strips");
  DriveScenario elsewhere = made;
  for (Vec3& v : elsewhere.model.vertices) v += Vec3{652000, 6861000, 0};
  refuses(elsewhere, made.cloud, made.trajectory, "are both in one coordinate system?");
}
