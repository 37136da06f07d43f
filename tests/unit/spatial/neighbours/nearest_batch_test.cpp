// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/nearest.h"

#include <doctest/doctest.h>

#include <limits>

#include "base/error.h"
#include "spatial/neighbours/nearest_kernel.h"
#include "spatial/octree/impl.h"
#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

struct Nearest {
  std::vector<uint32_t> index;  // in the caller's order
  std::vector<double> squared;
  bool operator==(const Nearest&) const = default;
};

Nearest nearest_of(const Octree& reference, const Octree& compared,
                   double max_distance_m = kNoLimit, unsigned thread_count = 2) {
  Task task(threads(thread_count));
  Nearest out{std::vector<uint32_t>(compared.size()), std::vector<double>(compared.size())};
  for_each_nearest(reference, compared, max_distance_m, task, [&](const NearestBatch& b) {
    for (size_t i = 0; i < b.count; ++i) {
      const uint32_t to = compared.order()[b.first + i];
      out.index[to] = b.nearest[i] == kNoPoint ? kNoPoint : reference.order()[b.nearest[i]];
      out.squared[to] = b.squared[i];
    }
  });
  return out;
}

void check_against_brute_force(const std::vector<double>& reference,
                               const std::vector<double>& compared,
                               double max_distance_m = kNoLimit, size_t every = 1) {
  const auto r = build(reference), c = build(compared);
  const Nearest found = nearest_of(*r, *c, max_distance_m);
  for (size_t i = 0; i < c->size(); i += every) {
    const Neighbour expected = brute_force(reference, point(compared, i), 1)[0];
    if (expected.squared_distance <= max_distance_m * max_distance_m) {
      REQUIRE(found.index[i] == expected.index);
      REQUIRE(found.squared[i] == expected.squared_distance);
    } else {
      REQUIRE(found.index[i] == kNoPoint);
      REQUIRE(found.squared[i] == kNoLimit);
    }
  }
}

std::vector<double> moved(std::vector<double> xyz, const Vec3& by, double scale = 1) {
  for (size_t i = 0; i < xyz.size(); ++i) xyz[i] = xyz[i] * scale + by[static_cast<int>(i % 3)];
  return xyz;
}

}  // namespace

TEST_CASE("nearest__equals_brute_force_on_two_scans_of_one_street") {
  const auto reference = street(6000, 1), compared = street(5000, 2);
  check_against_brute_force(reference, compared);
  check_against_brute_force(reference, compared, 0.1);
  check_against_brute_force(reference, compared, 0.0);
  check_against_brute_force(reference, reference);
}

TEST_CASE("nearest__equals_brute_force_wherever_the_clouds_lie_to_each_other") {
  const auto reference = street(3000, 1);
  for (const Vec3& by : {Vec3{0.5, 0.25, 0.1}, Vec3{3, 0, 0}, Vec3{0, 100, -30}, Vec3{-1e4, 1e4, 0},
                         Vec3{6.8e6, 0, 0}})
    check_against_brute_force(reference, moved(street(1500, 2), by), kNoLimit, 3);
  for (const double scale : {1e-6, 1e-3, 0.1, 30.0, 1e5}) {
    check_against_brute_force(reference, moved(street(1500, 2), {1, 1, 1}, scale), kNoLimit, 3);
    check_against_brute_force(moved(street(1500, 2), {1, 1, 1}, scale), reference, kNoLimit, 3);
  }
  check_against_brute_force(reference, moved(street(1500, 2), {0.5, 0, 0}), 0.45);
  check_against_brute_force(reference, moved(street(1500, 2), {100, 0, 0}), 90);
}

TEST_CASE("nearest__equals_brute_force_on_very_uneven_densities") {
  check_against_brute_force(street(20000, 1), street(100, 2));
  check_against_brute_force(street(60, 1), street(10000, 2));
  auto uneven = street(2000, 3);
  const auto corner = moved(street(8000, 4), {5, 0, 5}, 0.01);
  uneven.insert(uneven.end(), corner.begin(), corner.end());
  check_against_brute_force(uneven, street(3000, 5));
  check_against_brute_force(street(3000, 5), uneven);
}

TEST_CASE("nearest__takes_the_smallest_index_of_equally_near_points") {
  const auto coarse = street(5000, 1, 0.25), other = street(4000, 2, 0.25);
  check_against_brute_force(coarse, other);  // duplicates and ties on every node
  check_against_brute_force(coarse,
                            moved(other, {0.125, 0.125, 0.125}));         // eight nodes equally far
  check_against_brute_force(street(5000, 1, 0.1), street(4000, 2, 0.1));  // not on the binary grid
}

TEST_CASE("nearest__single_points_and_points_all_equal") {
  const std::vector<double> one{1, 2, 3};
  check_against_brute_force(one, street(500));
  check_against_brute_force(street(500), one);
  check_against_brute_force(one, one);
  std::vector<double> equal;
  for (int i = 0; i < 60000; ++i) equal.insert(equal.end(), {0.1, 0.2, 0.3});
  check_against_brute_force(equal, street(3000), kNoLimit, 100);
  check_against_brute_force(equal, equal, kNoLimit, 6000);
  auto both = street(3000, 3);
  both.insert(both.end(), equal.begin(), equal.end());
  check_against_brute_force(both, street(3000), kNoLimit, 100);
  check_against_brute_force(both, both, kNoLimit, 6000);
}

TEST_CASE("nearest__refuses_an_empty_reference_and_a_negative_distance") {
  const auto some = build(street(10)), none = build({});
  CHECK_THROWS_AS(nearest_of(*none, *some), Error);
  CHECK_THROWS_AS(nearest_of(*some, *some, -1), Error);
  CHECK_NOTHROW(nearest_of(*some, *none));
}

TEST_CASE("nearest__is_the_same_for_any_number_of_threads_and_after_a_shift_by_whole_metres") {
  constexpr double kGrid = 1.0 / 1024;
  const auto reference = street(60000, 1, kGrid), compared = street(50000, 2, kGrid);
  const Nearest found = nearest_of(*build(reference), *build(compared), kNoLimit, 1);
  CHECK(found == nearest_of(*build(reference), *build(compared), kNoLimit, 2));
  CHECK(found == nearest_of(*build(reference), *build(compared), kNoLimit, 7));
  const Vec3 national{652000, 6861000, 130};
  CHECK(found == nearest_of(*build(moved(reference, national)), *build(moved(compared, national))));
}

TEST_CASE("nearest__both_instruction_sets_find_the_same") {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) {
    MESSAGE("skipped: this processor has no AVX2");
    return;
  }
  const auto xyz = street(3000);
  const auto tree = build(xyz);
  RandomStream random(4, 0);
  for (int n = 0; n < 500; ++n) {
    GridMap map;
    map.shift = n % 3;
    map.offset[n % 3] = 12345;
    int32_t query[3];
    for (int32_t& c : query) c = static_cast<int32_t>(random.below(uint64_t{1} << 30));
    NearestOne a{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
                 kNoPoint},
        b = a;
    nearest_of_one_baseline(tree->impl().view, map, query, 7, a);
    nearest_of_one_avx2(tree->impl().view, map, query, 7, b);
    REQUIRE((a.best == b.best && a.position == b.position));
  }
#endif
}

TEST_CASE("nearest__equals_brute_force_where_the_grid_does_not_tell_points_apart") {
  for (const HostileCloud& cloud : hostile_clouds(2000)) {
    CAPTURE(cloud.name);
    check_against_brute_force(cloud.xyz, cloud.xyz);
    for (const Vec3& by : {Vec3{1e-9, 0, 0}, Vec3{0.125, 0.0625, 0}, Vec3{652000.5, 6861000, 0}}) {
      check_against_brute_force(cloud.xyz, moved(cloud.xyz, by), kNoLimit, 7);
      check_against_brute_force(moved(cloud.xyz, by), cloud.xyz, 0.01, 7);
    }
    check_against_brute_force(cloud.xyz, street(500), kNoLimit, 3);
    check_against_brute_force(street(500), cloud.xyz, kNoLimit, 3);
  }
}
