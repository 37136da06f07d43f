// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/registration_view.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "unit/report/viewer/viewed.h"

using namespace jalon;

TEST_CASE("registration_view__the_moving_cloud_in_its_pose_and_hidden_as_it_came") {
  Registration registration;
  registration.pose.m[3] = 12.5;
  const CloudPtr reference = viewed::random_cloud(50, 1, {0, 0, 0}, 2),
                 moving = viewed::random_cloud(40, 2, {-12.5, 0, 0}, 2);
  const ViewScene scene = registration_scene(registration, reference, moving);
  REQUIRE(scene.clouds.size() == 3);
  CHECK(scene.clouds[0].cloud == reference);
  CHECK(scene.clouds[1].pose.m[3] == 12.5);
  CHECK_FALSE(scene.clouds[1].is_hidden);
  CHECK(scene.clouds[2].pose.m[3] == 0);
  CHECK(scene.clouds[2].is_hidden);
  CHECK(scene.focus.max.x < 1.01);  // of the reference
}
