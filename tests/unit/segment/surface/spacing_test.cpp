// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/spacing.h"

#include <doctest/doctest.h>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("median_spacing__is_that_of_a_grid_and_repeated_points_count_once") {
  std::vector<Vec3> points;
  for (int i = 0; i < 64; ++i)
    for (int k = 0; k < 64; ++k) points.push_back({0.05 * i, 0.05 * k, 0});
  for (const size_t repeats : {0, 20000}) {
    for (size_t i = 0; i < repeats; ++i) points.push_back({1.5, 1.5, 0});
    MadeScene made(points);
    CHECK(median_spacing_m(made.scene) == doctest::Approx(0.05).epsilon(0.15).scale(0));
    for (auto& owner : made.scene.owner) owner = 1;
    CHECK(median_spacing_m(made.scene) == 0);
  }
}

TEST_CASE("spacing_sample__follows_which_points_are_free") {
  std::vector<Vec3> points;  // a dense half beside a sparse one
  for (int i = 0; i < 64; ++i)
    for (int k = 0; k < 64; ++k) points.push_back({0.05 * i, 0.05 * k, 0});
  for (int i = 0; i < 24; ++i)
    for (int k = 0; k < 24; ++k) points.push_back({10 + 0.2 * i, 0.2 * k, 0});
  MadeScene made(points);
  const SpacingSample sample(made.scene);
  CHECK(sample.median_m(made.scene) == median_spacing_m(made.scene));
  for (size_t p = 0; p < made.scene.size(); ++p)
    if (made.scene.local(p).x - made.scene.local(0).x < 5) made.scene.owner[p] = 1;
  CHECK(sample.median_m(made.scene) == median_spacing_m(made.scene));
  CHECK(sample.median_m(made.scene) == doctest::Approx(0.2).epsilon(0.3).scale(0));
}
