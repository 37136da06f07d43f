// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/adjusted_attributes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "model/buildings/part_numbers.h"
#include "model/part_classes.h"
#include "scan/mobile/drive_scenario.h"

using namespace jalon;

namespace {

std::map<std::string, double> of(const PartAttributes& attributes, size_t part) {
  std::map<std::string, double> made;
  for (const PartAttribute& a : attributes.of_part[part]) {
    CHECK(made.try_emplace(a.name, a.value).second);  // JSON takes a name once
    if (a.is_whole) CHECK(a.value == std::floor(a.value));
  }
  return made;
}

}  // namespace

TEST_CASE("adjusted_attributes__of_a_drive__say_of_each_part_what_moved_it") {
  DriveScenarioSettings from;
  from.leg_m = 60;
  from.revolutions_per_s = 10, from.pulses = 400;
  Task task;
  const DriveScenario drive = drive_scenario(from, task);
  JointSettings settings;
  settings.sigma_block_x_m = 0.9, settings.sigma_block_y_m = 1.1;
  settings.sigma_facade_m = 0.4, settings.sigma_strip_m = 0.2;
  const JointAdjustment a =
      adjust_jointly(drive.model, drive.cloud, drive.trajectory, settings, task);
  const PartAttributes made = adjusted_attributes(a, settings, drive.model);
  REQUIRE(made.of_part.size() == drive.model.parts.size());
  const std::vector<PartNumbers> numbers = part_numbers(drive.model);
  const Model moved = moved_strips(drive.model, a.model);
  std::map<uint32_t, double> of_block, of_facade;  // sums of the strips' matches
  size_t strips = 0, seen = 0;
  for (size_t f = 0; f < drive.model.faces.size(); ++f) {
    const Face &was = drive.model.faces[f], &is = moved.faces[f];
    if (drive.model.parts[was.part].part_class != part_class::kStrip) continue;
    const PartNumbers& n = numbers[was.part];
    auto strip = of(made, was.part);
    CHECK(strip.at("block") == n.block);
    CHECK(strip.at("facade") == n.facade);
    CHECK(strip.at("strip") == n.strip);
    CHECK(strip.at("strip_prior_sigma_m") == 0.2);
    CHECK(strip.at("facade_prior_sigma_m") == 0.4);
    CHECK(strip.at("strip_sigma_m") <= 0.2 * (1 + 1e-9));
    // What the attributes say is how far the wall stands from where it was.
    const uint64_t building = drive.model.parts[drive.model.parts[was.part].parent].parent;
    auto block = of(made, building);
    const double along = was.plane.normal.x * block.at("block_offset_east_m") +
                         was.plane.normal.y * block.at("block_offset_north_m") +
                         strip.at("facade_offset_m") + strip.at("strip_offset_m");
    CHECK(is.plane.offset - was.plane.offset == doctest::Approx(along).epsilon(1e-6));
    CHECK(block.at("block_prior_sigma_east_m") == 0.9);
    CHECK(block.at("block_prior_sigma_north_m") == 1.1);
    CHECK(std::isfinite(strip.at("strip_distance_before_m")) == (strip.at("strip_matches") > 0));
    of_block[n.block] += strip.at("strip_matches");
    of_facade[n.facade] += strip.at("strip_matches");
    ++strips, seen += strip.at("strip_matches") > 0 ? 1 : 0;
  }
  CHECK(strips == a.model.strips.size());
  CHECK(seen == a.strips);
  for (size_t p = 0; p < drive.model.parts.size(); ++p) {
    const std::string& part_class = drive.model.parts[p].part_class;
    if (part_class == part_class::kGround) CHECK(made.of_part[p].empty());
    if (part_class == part_class::kBlock)
      CHECK(of(made, p).at("block_matches") == of_block[numbers[p].block]);
    if (part_class == part_class::kFacade)
      CHECK(of(made, p).at("facade_matches") == of_facade[numbers[p].facade]);
  }
}
