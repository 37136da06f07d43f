// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "split_merge": its parameters and the facade of the comparison of 2006.
#include <doctest/doctest.h>

#include "unit/segment/plane_methods.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("split_merge__finds_front_windows_and_upright_sides") {
  const Scene scene = spec_facade(0.03, 51);
  const Segmentation s = segment_by("split_merge", cloud_of(scene.points));
  CHECK(s.segments.size() == 11);
  for (int face = 1; face <= 11; ++face) CHECK(best_match(scene, s, face).share > 0.9);
}

TEST_CASE("split_merge__cells_wider_than_a_detail_lose_it") {
  Scene scene;
  RandomStream random(13, 0);
  scene.rectangle(1, {0, 0, 0}, {8, 0, 0}, {0, 0, 8}, 20000, 0.003, random);
  scene.rectangle(2, {3, -0.5, 3}, {0.6, 0, 0}, {0, 0.5, 0}, 400, 0.003, random);
  const auto found = [&](const char* json) {
    return best_match(scene, segment_by("split_merge", cloud_of(scene.points), json), 2).share;
  };
  CHECK(found("{}") > 0.8);
  CHECK(found("{\"least_cell_m\": 4}") < 0.2);
}
