// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "triangle_growing": the study of its search distance.
#include <doctest/doctest.h>

#include <string>

#include "unit/segment/plane_methods.h"
#include "unit/segment/ramp.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE(
    "triangle_growing__a_smaller_search_distance_makes_smaller_segments_below_the_spacing_none") {
  const Scene scene = ramp(0.002, 3);
  size_t before = 0;
  for (const char* search : {"0.05", "0.1", "0.2", "0.4"}) {  // of a spacing of 0.2 m
    const Segmentation s =
        segment_by("triangle_growing", cloud_of(scene.points),
                   (std::string("{\"merge_gap_m\": 0, \"search_m\": ") + search + "}").c_str());
    const size_t largest = s.segments.empty() ? 0 : s.segments[0].fit.n;
    CHECK(largest >= before);
    if (std::string(search) == "0.1") CHECK(largest == 0);
    before = largest;
  }
  CHECK(before > 300);
}
