// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/hough/peaks.h"

#include <doctest/doctest.h>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("peaks__give_the_planes_of_a_box_and_mark_their_points") {
  Scene scene;
  RandomStream random(3, 0);
  scene.rectangle(1, {0, 0, 0}, {6, 0, 0}, {0, 0, 4}, 20000, 0.003, random);
  scene.rectangle(2, {0, 0, 0}, {0, 4, 0}, {0, 0, 4}, 12000, 0.003, random);
  scene.rectangle(3, {0, 0, 0}, {6, 0, 0}, {0, 4, 0}, 8000, 0.003, random);
  for (const HoughVotes way : {HoughVotes::kNormals, HoughVotes::kAll}) {
    MadeScene made(scene.points);
    HoughSettings settings;
    settings.votes = way;
    settings.voters = 4000;
    const auto surfaces = surfaces_of_peaks(made.scene, settings, made.task);
    REQUIRE(surfaces.size() == 3);
    for (size_t s = 0; s < 3; ++s) {
      CHECK(surfaces[s].sigma_m < 0.004);
      for (const uint32_t position : surfaces[s].positions)
        REQUIRE(made.scene.owner[position] == s + 1);
    }
  }
}
