// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/block_search.h"

#include <doctest/doctest.h>

#include "scan/mobile/drive_scenario.h"

using namespace jalon;

namespace {

struct Drive {
  DriveScenario made;
  JointSettings settings;
  StripScene scene;
  JointPoints points;

  explicit Drive(int64_t scenario) {
    DriveScenarioSettings from;
    from.scenario = scenario;
    from.closed = true;
    from.leg_m = 60;
    from.revolutions_per_s = 10, from.pulses = 250;
    from.seed = 9001;
    Task task;
    made = drive_scenario(from, task);
    const ScenarioSigmas sigmas = sigmas_of(from);
    settings.sigma_block_x_m = settings.sigma_block_y_m = sigmas.block_m;
    settings.sigma_facade_m = sigmas.facade_m, settings.sigma_strip_m = sigmas.strip_m;
    scene = strip_scene(made.model, true);
    points = joint_points(made.cloud, made.trajectory, control_times(made.trajectory, 1), settings,
                          task);
  }
  std::vector<Vec2> found(unsigned threads = 1) const {
    Task task(Task::Hooks{.threads = threads});
    return find_blocks(points, scene, settings, task);
  }
};

}  // namespace

TEST_CASE("find_blocks__that_are_off_by_metres__finds_where_they_stand") {
  const Drive drive(2);
  REQUIRE(is_block_search_wanted(drive.points, drive.settings));
  const std::vector<Vec2> found = drive.found();
  REQUIRE(found.size() == drive.made.offsets.blocks.size());
  double most_before = 0;
  for (size_t b = 0; b < found.size(); ++b) {
    CAPTURE(b);
    const Vec2& off = drive.made.offsets.blocks[b];
    most_before = std::max(most_before, norm(off));
    // Along a front that nothing but some degrees hold, decimetres are what is there to be found.
    CHECK(norm(off + found[b]) < 0.6);
  }
  CHECK(most_before > 3);
}

TEST_CASE("find_blocks__with_two_threads__gives_the_same_bits") {
  const Drive drive(2);
  const std::vector<Vec2> one = drive.found(1), two = drive.found(2);
  CHECK(one == two);
}

TEST_CASE("find_blocks__that_are_as_sure_as_the_rest__leaves_them") {
  const Drive drive(5);
  CHECK(!is_block_search_wanted(drive.points, drive.settings));
  for (const Vec2& by : drive.found()) CHECK(norm(by) == 0);
}
