// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/street_drive.h"

#include <doctest/doctest.h>

#include "model/buildings/building_tree.h"
#include "model/trajectory/interpolation.h"

using namespace jalon;

TEST_CASE("street_drive__of_fronts__is_14_blocks_of_four_facades_and_54_control_times") {
  const StreetDrive made = street_drive({});
  validate(made.model);
  validate(made.trajectory);
  CHECK(control_times(made.trajectory, 1).size() == 54);
  CHECK(made.trajectory.times_s.back() == 53);
  BuildingSettings settings;
  settings.touch_m = 2;  // fronts of a block are set back by up to 1.2 m from each other
  Task task;
  const BuildingTree tree = building_tree(made.model, settings, task);
  CHECK(tree.blocks == 14);
  CHECK(tree.facades.size() == 56);
  CHECK(tree.strips.size() == 304);
  // Every front looks at the street: from its middle the axis is in front of it.
  for (const BuildingFacade& f : tree.facades) {
    const Vec3 middle = f.place({(f.from_m + f.to_m) / 2, 0});
    double nearest = 1e9, ahead = 0;
    for (const Vec3& p : made.trajectory.positions)
      if (const double d = norm(Vec3{p.x - middle.x, p.y - middle.y, 0}); d < nearest)
        nearest = d, ahead = dot(f.normal, p - middle);
    CHECK(ahead > 0.9 * nearest);
    CHECK(nearest > 7.5);
    CHECK(nearest < 9.8);
  }
}

TEST_CASE("street_drive__closed__has_whole_houses_ground_and_things") {
  StreetDriveSettings settings;
  settings.closed = true;
  settings.shift_m = {652000, 6861000, 35};
  const StreetDrive made = street_drive(settings);
  validate(made.model);
  CHECK(made.trajectory.positions[0].x == 652000);
  Task task;
  BuildingSettings strips;
  strips.touch_m = 1.5;  // sides of neighbours, turned and set back against each other
  const BuildingTree tree = building_tree(made.model, strips, task);
  CHECK(tree.buildings.size() > 56);  // things stand upright too
  size_t turned = 0;
  for (const BuildingFacade& f : tree.facades) turned += f.was_turned;
  CHECK(turned == 0);
}

TEST_CASE("street_drive__straight__has_one_leg_and_its_direction") {
  StreetDriveSettings settings;
  settings.corner = false;
  const StreetDrive made = street_drive(settings);
  CHECK(made.trajectory.times_s.back() == doctest::Approx(26.5));
  for (const Vec3& a : made.trajectory.attitudes_rad) CHECK(a == Vec3{});
  CHECK(made.model.parts.size() == 28);
}

TEST_CASE("street_drive__of_seed_0__has_every_block_turned_as_much_as_the_others") {
  StreetDriveSettings settings;
  settings.seed = 0;
  BuildingSettings touching;
  touching.touch_m = 2;
  Task task;
  const BuildingTree tree = building_tree(street_drive(settings).model, touching, task);
  REQUIRE(tree.blocks == 14);
  // Angles of a block's fronts about their mean: what holds it along its street.
  std::vector<double> least(tree.blocks, 1), most(tree.blocks, -1);
  for (const BuildingFacade& f : tree.facades) {
    const double along = std::fabs(f.normal.x) < 0.5 ? f.normal.x : f.normal.y;
    least[tree.block_of(f)] = std::min(least[tree.block_of(f)], along);
    most[tree.block_of(f)] = std::max(most[tree.block_of(f)], along);
  }
  for (size_t b = 0; b < tree.blocks; ++b)
    CHECK(most[b] - least[b] == doctest::Approx(2 * std::sin(0.05)).epsilon(1e-9));
}
