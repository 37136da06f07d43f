// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/overlap/overlap.h"

#include <doctest/doctest.h>

#include "unit/compare/overlap/overlap_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("clouds_overlap__of_two_scans_of_one_place_is_nearly_all") {
  Task task;
  const CloudsOverlap found =
      clouds_overlap(cloud_by(hall_points(1)), cloud_by(hall_points(2)), task);
  CHECK(found.reference_share > 0.95);
  CHECK(found.compared_share > 0.95);
  CHECK_FALSE(found.is_apart);
  CHECK(found.gap_m == 0);
  CHECK(found.cause == ApartCause::kUnknown);
}

TEST_CASE("clouds_overlap__a_small_part_of_a_large_cloud_is_not_apart") {
  Task task;
  std::vector<Vec3> corner;
  for (const Vec3& p : hall_points(3, 60000))
    if (p.x < 31 && p.y < 51 && p.z < 3) corner.push_back(p);
  REQUIRE(corner.size() > 50);
  for (const bool is_reference : {true, false}) {
    const Cloud small = cloud_by(corner), large = cloud_by(hall_points(4));
    const CloudsOverlap found =
        clouds_overlap(is_reference ? small : large, is_reference ? large : small, task);
    CHECK_FALSE(found.is_apart);
    CHECK(found.cause == ApartCause::kUnknown);
    CHECK((is_reference ? found.reference_share : found.compared_share) > 0.9);
  }
}

TEST_CASE("clouds_overlap__tells_the_gap_of_disjoint_clouds_and_none_of_empty_ones") {
  Task task;
  const Cloud hall = cloud_by(hall_points(1));
  const CloudsOverlap far = clouds_overlap(hall,
                                           cloud_by(hall_points(2),
                                                    [](const Vec3& p) {
                                                      return p + Vec3{120, 0, 0};
                                                    }),
                                           task);
  CHECK(far.is_apart);
  CHECK(far.gap_m == doctest::Approx(100).epsilon(0.01));
  CHECK_FALSE(clouds_overlap(hall, Cloud{}, task).is_apart);
  CHECK(clouds_overlap(cloud_by({{1, 2, 3}}), hall, task).is_apart);
}

TEST_CASE("overlap_table__has_one_row_of_what_was_found") {
  CloudsOverlap overlap;
  overlap.is_apart = true;
  overlap.cause = ApartCause::kAxes;
  overlap.axes = {2, 1, -3};
  const FieldTable table = overlap_table(overlap);
  CHECK(table.require("apart").values<uint8_t>()[0] == 1);
  CHECK(table.require("cause").values<uint8_t>()[0] == 1);
  CHECK(table.require("axes").values<int8_t>()[2] == -3);
}
