// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "hough": both ways to vote, coarse steps, and the facade of the comparison of 2006.
#include <doctest/doctest.h>

#include <string>

#include "unit/segment/plane_methods.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("hough__finds_front_windows_and_upright_sides_however_the_points_vote") {
  const Scene scene = spec_facade(0.03, 61);
  for (const char* json : {"{}", "{\"votes\": \"all\", \"voters\": 5000}",
                           "{\"angle_step_rad\": 0.1, \"distance_step_m\": 0.1}"}) {
    CAPTURE(std::string(json));
    const Segmentation s = segment_by("hough", cloud_of(scene.points), json);
    CHECK(s.segments.size() == 11);
    for (int face = 1; face <= 11; ++face) CHECK(best_match(scene, s, face).share > 0.9);
  }
}
