// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "profiles" on the facade of the comparison of 2006, and its parameters.
#include <doctest/doctest.h>

#include "unit/segment/plane_methods.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("profiles__find_front_windows_and_upright_sides_by_heights_alone") {
  const Scene scene = spec_facade(0.02, 41);
  for (const char* json : {"{\"axes\": \"z\", \"step_m\": 0.25, \"line_tolerance_m\": 0.01}",
                           "{\"axes\": \"direction\"}", "{}"}) {
    CAPTURE(std::string(json));
    const Segmentation s = segment_by("profiles", cloud_of(scene.points), json);
    for (int face = 1; face <= 11; ++face) {
      CAPTURE(face);
      const BestMatch match = best_match(scene, s, face);
      CHECK(match.share > 0.9);
      if (match.label == 0 || face > 7) continue;
      CHECK(largest_miss_m(scene, face, s.segments[match.label - 1], face == 1 ? 0 : 0.2) < 0.01);
    }
  }
}

TEST_CASE("profiles__heights_alone_miss_what_is_level") {
  Scene scene;
  RandomStream random(12, 0);
  scene.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 0, 3}, 12000, 0.003, random);
  scene.rectangle(2, {0, -3, 0}, {4, 0, 0}, {0, 3, 0}, 12000, 0.003, random);
  const auto found = [&](const char* json, int face) {
    return best_match(scene, segment_by("profiles", cloud_of(scene.points), json), face).share;
  };
  CHECK(found("{\"axes\": \"z\"}", 1) > 0.95);
  CHECK(found("{\"axes\": \"z\"}", 2) < 0.1);
  CHECK(found("{}", 2) > 0.95);
}

TEST_CASE("profiles__refuse_a_direction_that_is_none") {
  const auto cloud = cloud_of(spec_facade(0.2, 34).points);
  CHECK_THROWS_AS(
      segment_by("profiles", cloud, "{\"axes\": \"direction\", \"direction\": [0, 0, 0]}"), Error);
}
