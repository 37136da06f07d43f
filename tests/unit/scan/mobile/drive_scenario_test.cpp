// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/drive_scenario.h"

#include <doctest/doctest.h>

#include "model/buildings/part_numbers.h"

using namespace jalon;

namespace {

DriveScenarioSettings small_street(bool closed) {
  DriveScenarioSettings made;
  made.leg_m = 60;
  made.closed = closed;
  made.revolutions_per_s = 5, made.pulses = 200;
  return made;
}

}  // namespace

// A point of a strip stands off the wrong strip by what the errors of both sides make of it.
TEST_CASE("drive_scenario__moves_points_and_strips_by_the_errors_it_tells") {
  Task task;
  for (const bool closed : {false, true}) {
    const DriveScenario made = drive_scenario(small_street(closed), task);
    const auto strips = made.cloud.fields.require("strip").values<uint32_t>();
    const auto times = made.cloud.fields.require("time").values<double>();
    const auto truth = made.cloud.fields.require("true_xyz").values<double>();
    const std::vector<PartNumbers> numbers = part_numbers(made.model);
    size_t on_strips = 0;
    for (size_t i = 0; i < made.cloud.size(); i += 7) {
      const TimePlace at = time_place(made.trajectory_errors.times_s, times[i], i);
      const Vec2 by = made.trajectory_errors.at(at);
      const Vec3 p = made.cloud.point(i);
      CHECK(p.x - truth[3 * i] == doctest::Approx(by.u).epsilon(1e-6));
      CHECK(p.y - truth[3 * i + 1] == doctest::Approx(by.v).epsilon(1e-6));
      if (strips[i] == UINT32_MAX) continue;
      ++on_strips;
      const Face& face = made.model.faces[strips[i]];
      const PartNumbers& n = numbers[face.part];
      REQUIRE(n.strip == strips[i]);
      const Vec3& normal = face.plane.normal;
      const double off = normal.x * (by.u - made.offsets.blocks[n.block].u) +
                         normal.y * (by.v - made.offsets.blocks[n.block].v) -
                         made.offsets.facades[n.facade] - made.offsets.strips[n.strip];
      CHECK(std::fabs(face.plane.distance(p) - off) < 1e-5);
    }
    CHECK(on_strips > 300);
    const bool all_on_strips = 7 * on_strips >= made.cloud.size() - 7;
    CHECK(all_on_strips != closed);  // ground, roofs and vans are of no strip
  }
}

TEST_CASE("drive_scenario__of_another_seed__is_the_same_street_with_other_errors") {
  Task task;
  DriveScenarioSettings settings = small_street(false);
  const DriveScenario a = drive_scenario(settings, task);
  settings.seed = 2;
  const DriveScenario b = drive_scenario(settings, task);
  CHECK(a.true_model.vertices == b.true_model.vertices);
  CHECK(a.offsets.strips != b.offsets.strips);
  CHECK(a.trajectory.positions != b.trajectory.positions);
  CHECK(a.true_trajectory.positions == b.true_trajectory.positions);
}
