// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/adjustment_view.h"

#include <doctest/doctest.h>

#include <cmath>

#include "scan/mobile/drive_scenario.h"

using namespace jalon;

TEST_CASE(
    "adjustment_view__points_stand_where_their_times_put_them_and_strips_where_they_are_now") {
  DriveScenarioSettings from;
  from.leg_m = 40, from.revolutions_per_s = 10, from.pulses = 120;
  Task task;
  const DriveScenario drive = drive_scenario(from, task);
  const JointAdjustment a = adjust_jointly(drive.model, drive.cloud, drive.trajectory, {}, task);
  const ViewScene scene = adjustment_scene(a, {drive.model, drive.trajectory, nullptr});
  REQUIRE(scene.clouds.size() == 2);
  REQUIRE(scene.clouds[0].cloud->size() == a.points.size());
  const ViewChannel& distance = scene.clouds[0].channels.at(0);
  double worst = 0;
  size_t matched = 0;
  for (size_t i = 0; i < a.points.size(); ++i) {
    const Vec3 by = scene.clouds[0].cloud->point(i) - scene.clouds[1].cloud->point(i);
    const Vec2 wanted = a.trajectory.at(a.points.places[i]);
    worst = std::max(worst, std::hypot(by.x - wanted.u, by.y - wanted.v) + std::fabs(by.z));
    if (std::isfinite(distance.value(i))) ++matched;
  }
  CHECK(worst < 1e-6);
  CHECK(matched > 100);
  CHECK(distance.high > 0);
  CHECK(scene.clouds[1].is_hidden);
  size_t strips = 0;
  for (const ViewPart& part : scene.parts) strips += part.text.starts_with("strip ") ? 1 : 0;
  CHECK(strips > 0);
  CHECK(scene.parts.back().text == "the drive adjusted");
}
