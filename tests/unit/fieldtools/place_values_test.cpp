// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/place_values.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("place_values__of_whole_and_cut_places_equal_the_sums_over_their_points") {
  RandomStream random(3, 0);
  std::vector<Vec3> points = random_points(3000, 3, 8);
  for (size_t i = 0; i < 2000; ++i) points[i] = points[i % 3];
  const Cloud cloud = cloud_of(points);
  std::vector<double> values(points.size());
  for (double& v : values) v = random.normal();
  Task task;
  const ValuedPoints valued = valued_points(cloud, values, task);
  const PlaceValues places(valued, task);
  size_t whole = 0;
  for (uint32_t first = 0; first < 3000;) {
    const auto last = static_cast<uint32_t>(valued.tree->end_of_place(first));
    whole += last - first > 600;
    for (const uint32_t cut : {0u, 1u, 300u}) {
      if (last - first <= 2 * cut) continue;
      const Octree::PlaceGroup group{first + cut, last - cut, 0};
      for (const double most : {0.0, 0.3, 5.0, std::numeric_limits<double>::infinity()}) {
        const double from = valued.values[first];
        size_t count = 0;
        double sum = 0;
        for (uint32_t i = group.first; i < group.last; ++i)
          if (std::abs(valued.values[i] - from) <= most) ++count, sum += valued.values[i] - from;
        const PlaceValues::Part part = places.within(group, from, most);
        REQUIRE(part.count == count);
        REQUIRE(part.sum == doctest::Approx(sum).scale(1).epsilon(1e-11));
      }
    }
    first = last;
  }
  CHECK(whole == 3);
}
