// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Targets found in a whole scan by their brightness, with the code of their kind and size, or none.

#include "registration/targets/recognition.h"

#include <doctest/doctest.h>

#include "unit/registration/target_walls.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr const char* kCatalogue = R"({"targets": [
  {"code": "1", "name": "wall", "kind": "checker", "size_m": 0.15},
  {"code": 2, "name": "door", "kind": "checker", "size_m": 0.1},
  {"code": "3", "name": "window", "kind": "disc", "size_m": 0.1}]})";

std::vector<RecognisedTarget> recognised(const Cloud& cloud, const char* catalogue) {
  Task task;
  return recognised_targets(cloud, target_catalogue_from_json(catalogue), MeasuringSettings{},
                            task);
}

TargetWall plain_wall() {
  TargetWall wall;
  wall.width_m = 3, wall.height_m = 2;
  wall.sheets = {checker_sheet(0.7, 1, 0.2, 0.15), checker_sheet(1.5, 1.2, 0.5, 0.1, 0.01),
                 disc_sheet(2.3, 0.8, 0.1)};
  return wall;
}

}  // namespace

TEST_CASE("recognition__finds_kind_size_and_code_of_targets_on_a_wall") {
  const TargetWall wall = plain_wall();
  const auto found = recognised(scan_of(wall, 1), kCatalogue);
  for (const auto& f : found)
    MESSAGE(f.centre().x << " " << f.centre().y << " " << f.centre().z << " kind "
                         << int(f.measured.kind) << " size " << f.size_m << " +- " << f.size_sigma_m
                         << " misfit " << f.misfit << " cnr " << f.contrast_to_noise << " conf "
                         << f.confidence << " verdict " << int(f.verdict) << " entry " << f.entry);
  REQUIRE(found.size() == 3);
  for (size_t i = 0; i < 3; ++i) {
    CHECK(found[i].verdict == TargetVerdict::kKnown);
    CHECK(found[i].entry == static_cast<int32_t>(i));
    CHECK(norm(found[i].centre() - place_of(wall, wall.sheets[i])) < 0.001);
  }
}
