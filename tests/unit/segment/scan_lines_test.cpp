// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "scan_lines": rows of a grid and about a station, degenerate clouds, the ramp, bits.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "unit/segment/lines/scanned.h"
#include "unit/segment/method_checks.h"
#include "unit/segment/plane_methods.h"
#include "unit/segment/ramp.h"
#include "unit/segment/same_bits.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("scan_lines__find_the_faces_of_a_house_by_fields_and_by_angles") {
  const Scanned scanned(scanned_house(), 0.005, 0.003, 7);
  for (const bool fields : {true, false}) {
    CAPTURE(fields);
    const Segmentation s = segment_by("scan_lines", scanned.cloud(fields));
    CHECK(s.segments.size() <= 8);
    for (int face = 1; face <= 6; ++face) {
      CAPTURE(face);
      CHECK(best_match(scanned.scene, s, face).share > 0.9);
    }
  }
}

TEST_CASE("scan_lines__split_the_ramp_into_its_three_planes") {
  const Scene exact = ramp(0, 1);  // 51 rows of 16 points
  const RampResult r = judge_ramp(exact, segment_by("scan_lines", in_rows(exact.points, 16)));
  CHECK(r.angle_rad < 1e-6);
  CHECK(r.wrong == 0);
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Scene scene = ramp(0.005, seed);
    const RampResult noisy = judge_ramp(scene, segment_by("scan_lines", in_rows(scene.points, 16)));
    CHECK(noisy.angle_rad < 0.0035);
    CHECK(noisy.wrong <= 16);
  }
}

TEST_CASE("scan_lines__give_the_same_bits_for_any_threads_and_on_a_national_grid") {
  Scanned scanned(scanned_house(), 0.01, 0.003, 8);
  scanned.scene.points = snapped(scanned.scene.points);
  const Segmentation one = segment_by("scan_lines", scanned.cloud(true), "{}", 1);
  check_same(one, segment_by("scan_lines", scanned.cloud(true), "{}", 2), false);
  check_same(one, segment_by("scan_lines", scanned.cloud(true), "{}", 7), false);
  check_same(one, segment_by("scan_lines", scanned.cloud(true, {652000, 6861000, 35})), true);
}

TEST_CASE("scan_lines__tell_degenerate_clouds_first_and_then_those_without_rows") {
  refuses_clouds_without_area([](const CloudPtr& cloud) {
    std::vector<Vec3> points;
    for (size_t i = 0; i < cloud->size(); ++i) points.push_back(cloud->point(i));
    segment_by("scan_lines", in_rows(points, 50));
  });
  try {
    segment_by("scan_lines", cloud_of(ramp(0, 1).points));
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kUnsupported);
  }
}
