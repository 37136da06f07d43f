// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/scale_test.h"

#include <doctest/doctest.h>

#include "unit/registration/verdict/judged_rooms.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("scale_test__gives_one_for_scans_of_one_scale") {
  for (const uint64_t seed : {1, 2, 3}) {
    const PairScene room = furnished(seed, seed);
    const auto a = judged_scan(room, 0, 1), b = judged_scan(room, 1, 2);
    const ScaleTest found = scale_test(a->judged, b->judged, shift_between(*a, *b));
    CHECK(found.pairs > 500);
    CHECK(std::abs(found.scale - 1) < 4 * found.sigma);
    CHECK(found.sigma < 1e-3);
  }
}

TEST_CASE("scale_test__tells_a_scale_that_the_neighbours_still_follow") {
  const PairScene room = furnished(2, 2);
  ScanSettings scanner;
  scanner.scale = 1.001;
  const auto a = judged_scan(room, 0, 1), b = judged_scan(room, 1, 2, scanner);
  const ScaleTest found = scale_test(a->judged, b->judged, shift_between(*a, *b));
  CHECK(found.scale == doctest::Approx(1 / 1.001).epsilon(2e-4));
  CHECK(std::abs(found.scale - 1) > 5 * found.sigma);
}

TEST_CASE("scale_test__tells_nothing_of_one_plane_or_of_clouds_apart") {
  PairScene plane;
  plane.sheet({-10, -10, 0}, {20, 0, 0}, {0, 20, 0});
  plane.standpoints = {{0, 0, 2}, {1, 1, 2}};
  const auto a = judged_scan(plane, 0, 1), b = judged_scan(plane, 1, 2);
  const ScaleTest flat = scale_test(a->judged, b->judged, shift_between(*a, *b));
  CHECK(flat.pairs > 500);
  CHECK(flat.sigma == 0);
  Transform apart = shift_between(*a, *b);
  apart.m[3] += 500;
  CHECK(scale_test(a->judged, b->judged, apart).pairs == 0);
}
