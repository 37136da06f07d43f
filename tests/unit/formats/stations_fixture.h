// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rigid_motion.h"
#include "unit/formats/fixtures.h"

namespace jalon::test {

/// Points of a scanner that leans and of one whose pose nobody knows; the first three belong to none.
inline Cloud two_stations(bool with_loose_points = false) {
  Cloud cloud = random_points(20, 5, {1000, 2000, 50});
  const uint64_t loose = with_loose_points ? 3 : 0;
  Station& a = cloud.stations.emplace_back();
  a.name = "west \"1\" \xC3\xA9";
  a.has_pose = true;
  a.pose = rotation_by({0.1, -0.2, 2.5});
  a.pose.m[3] = 1000.25, a.pose.m[7] = 1999.5, a.pose.m[11] = 51.7;
  a.first = loose;
  a.count = 9;
  Station& b = cloud.stations.emplace_back();
  b.name = "east";
  b.first = loose + 9;
  b.count = 20 - b.first;
  return cloud;
}

inline void check_same_stations(const Cloud& a, const Cloud& b) {
  REQUIRE(a.stations.size() == b.stations.size());
  for (size_t k = 0; k < a.stations.size(); ++k) {
    const Station &p = a.stations[k], &q = b.stations[k];
    CHECK(p.name == q.name);
    CHECK(p.first == q.first);
    CHECK(p.count == q.count);
    REQUIRE(p.has_pose == q.has_pose);
    for (size_t i = 0; i < 12 && p.has_pose; ++i)
      CHECK(p.pose.m[i] == doctest::Approx(q.pose.m[i]).epsilon(1e-12));
  }
}

}  // namespace jalon::test
