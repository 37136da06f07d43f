// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/feature_match.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.h"
#include "registration/coarse/feature_histogram.h"

using namespace jalon;

namespace {

/// n points with features, every second of them distinct.
CoarseSurface described(size_t n, uint64_t seed) {
  CoarseSurface s;
  RandomStream random(seed, 0);
  s.features.resize(n);
  for (Feature& f : s.features)
    for (float& v : f) v = static_cast<float>(random.below(8));
  for (uint32_t i = 0; i < n; i += 2) s.distinct.push_back(i);
  return s;
}

// Whether b is among the rank nearest of the distinct points of a side, ties by index.
bool is_near(const Feature& f, uint32_t b, const CoarseSurface& side, size_t rank) {
  size_t nearer = 0;
  const float own = squared_distance(f, side.features[b]);
  for (const uint32_t other : side.distinct) {
    const float d = squared_distance(f, side.features[other]);
    nearer += d < own || (d == own && other < b);
  }
  return nearer < rank;
}

}  // namespace

TEST_CASE("match_features__are_the_mutual_neighbours_that_brute_force_finds") {
  const CoarseSurface reference = described(150, 1), moving = described(131, 2);
  for (const size_t rank : {1u, 2u, 5u}) {
    Task task;
    const auto matches = match_features(reference, moving, rank, 100000, task);
    size_t expected = 0;
    for (const uint32_t m : moving.distinct)
      for (const uint32_t r : reference.distinct)
        expected += is_near(moving.features[m], r, reference, rank) &&
                    is_near(reference.features[r], m, moving, rank);
    CHECK(matches.size() == expected);
    for (const FeatureMatch& match : matches) {
      CHECK(is_near(moving.features[match.moving], match.reference, reference, rank));
      CHECK(is_near(reference.features[match.reference], match.moving, moving, rank));
      CHECK(match.distance ==
            squared_distance(moving.features[match.moving], reference.features[match.reference]));
    }
  }
}

TEST_CASE("match_features__the_nearest_come_first_and_no_more_than_asked_for") {
  const CoarseSurface reference = described(100, 3), moving = described(100, 4);
  Task task;
  const auto all = match_features(reference, moving, 3, 100000, task);
  REQUIRE(all.size() > 10);
  const auto few = match_features(reference, moving, 3, 10, task);
  REQUIRE(few.size() == 10);
  for (size_t i = 0; i < 10; ++i) {
    CHECK(few[i].moving == all[i].moving);
    CHECK(few[i].reference == all[i].reference);
  }
  CHECK(std::is_sorted(all.begin(), all.end(), [](const FeatureMatch& a, const FeatureMatch& b) {
    return a.distance < b.distance;
  }));
}

TEST_CASE("match_features__without_distinct_points_there_are_none") {
  CoarseSurface none;
  Task task;
  CHECK(match_features(described(10, 5), none, 2, 10, task).empty());
  CHECK(match_features(none, described(10, 5), 2, 10, task).empty());
}
