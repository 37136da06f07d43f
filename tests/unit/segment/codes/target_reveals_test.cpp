// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/segment/codes/target_house.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("target_reveals__go_to_the_wall_of_their_window_and_what_is_before_it_does_not") {
  TargetHouse house;
  for (double y = 0.07; y < 0.19; y += 0.02)  // behind the points that are the wall's anyway
    for (const double left : {4.0, 7.0}) {
      for (double z = 1.01; z < 2; z += 0.02)
        house.add({left, y, z}, 1), house.add({left + 2, y, z}, 1);
      for (double x = left + 0.01; x < left + 2; x += 0.02)
        house.add({x, y, 0.93 + 0.35 * y}, 1), house.add({x, y, 2}, 1);  // the sill is inclined
    }
  const size_t reveals = house.of(1) - TargetHouse().of(1);
  for (double x = 4.1; x < 5.9; x += 0.05) house.add({x, 0.1, 1.5}, 0);   // in the window's middle
  for (double x = 4.1; x < 5.9; x += 0.05) house.add({x, -0.2, 1.0}, 0);  // before the wall
  TargetCodeSettings settings;
  settings.input.codes = house.targets;
  Task task;
  const CloudPtr cloud = cloud_of(house.points);
  const size_t without = house.confused(segment_by_target_codes(cloud, settings, task), 1, 0);
  settings.input.form = CodeForm::kImproved;
  const Segmentation improved = segment_by_target_codes(cloud, settings, task);
  CHECK(without > reveals);  // and what is over the door
  CHECK(house.confused(improved, 1, 0) < 60);
  CHECK(house.confused(improved, 0, 1) == 0);
}
