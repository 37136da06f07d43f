// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/scan_output.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("scan_output__gives_points_with_the_truth_they_were_set_with") {
  ScanOutput output(2);
  output.set_point(1, {4, 5, 6}, {4.1, 5.1, 6.1}, 8, 2);
  output.set_point(0, {1, 2, 3}, {1.1, 2.1, 3.1}, 4294967295u, 0);
  const Cloud cloud = output.take();
  REQUIRE(cloud.size() == 2);
  CHECK(std::vector<double>(cloud.xyz().begin(), cloud.xyz().end()) ==
        std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(values<uint32_t>(cloud, "face")[0] == 4294967295u);
  CHECK(values<uint32_t>(cloud, "face")[1] == 8);
  CHECK(values<uint32_t>(cloud, "segment")[0] == 0);
  CHECK(values<uint32_t>(cloud, "segment")[1] == 2);
  CHECK(true_point(cloud, 0) == Vec3{1.1, 2.1, 3.1});
  CHECK(true_point(cloud, 1) == Vec3{4.1, 5.1, 6.1});
  CHECK(ScanOutput(0).take().size() == 0);
}

TEST_CASE("scan_output__steps_to_the_nearest_multiple_and_not_at_all_for_zero") {
  const Vec3 p{1.2344, -0.0016, 7.00051};
  CHECK(stepped(p, 0) == p);
  const Vec3 q = stepped(p, 0.001);
  CHECK(norm(q - Vec3{1.234, -0.002, 7.001}) < 1e-12);
  CHECK(stepped(q, 0.001) == q);
  for (int a = 0; a < 3; ++a) CHECK(std::abs(stepped(p, 0.25)[a] - p[a]) <= 0.125);
  CHECK(stepped(p, 0.25) == Vec3{1.25, 0, 7});
}

TEST_CASE("scan_output__takes_an_offset_of_three_numbers_only") {
  const double four[] = {1, 2, 3, 4};
  CHECK(offset_of(std::span(four, 3)) == Vec3{1, 2, 3});
  CHECK_THROWS_AS(offset_of(std::span(four, 2)), Error);
  CHECK_THROWS_AS(offset_of(four), Error);
  CHECK_THROWS_AS(offset_of({}), Error);
}
