// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/ajar_leaf.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kWidth_m = 1.6;
constexpr OpeningFront kShut{0.005, 0};
constexpr OpeningEnds kEnds{0, kWidth_m, 1, 2};

/// A leaf of 1.6 m by 1 m, its frame 8 cm wide, turned inward about one end; the reveals of its hole, a sheet in the
/// room behind it.
struct Room {
  std::vector<Vec3> leaf, others;
  explicit Room(double angle_deg, uint64_t seed, bool is_left = true) {
    RandomStream random(seed, 0);
    const double c = std::cos(angle_deg * kDegree), s = std::sin(angle_deg * kDegree);
    const auto noise = [&] { return 0.002 * random.normal(); };
    const auto mirrored = [&](double u) { return is_left ? u : kWidth_m - u; };
    for (int i = 0; i < 4000; ++i) {
      const double u = kWidth_m * random.uniform(), z = 1 + random.uniform(), off = noise();
      if (u > 0.08 && u < kWidth_m - 0.08 && z > 1.08 && z < 1.92) continue;
      leaf.push_back({mirrored(c * u + s * off), kShut.at_m - s * u + c * off, z});
    }
    for (int i = 0; i < 1200; ++i) {
      const double u = kWidth_m * random.uniform(), before = 0.1 * random.uniform();
      others.push_back(
          {i % 2 == 0 ? noise() : kWidth_m + noise(), kShut.at_m + before, 1 + random.uniform()});
      others.push_back({u, kShut.at_m + before, (i % 2 == 0 ? 1 : 2) + noise()});
      others.push_back({u, -0.6 + noise(), 1 + 0.8 * random.uniform()});
    }
  }
  std::vector<Vec3> all() const {
    std::vector<Vec3> out = leaf;
    out.insert(out.end(), others.begin(), others.end());
    return out;
  }
};

}  // namespace

TEST_CASE("ajar_leaf__is_found_at_its_angle_about_either_end") {
  for (uint64_t seed = 1; seed <= 3; ++seed)
    for (const bool is_left : {true, false})
      for (const double angle_deg : {5.0, 10.0, 15.0, 25.0}) {
        CAPTURE(angle_deg);
        const Room room(angle_deg, seed, is_left);
        AjarLeaf leaf;
        REQUIRE(find_ajar_leaf(room.all(), kShut, kEnds, kWidth_m, leaf));
        CHECK((leaf.along.u > 0) == is_left);
        CHECK(std::fabs(std::asin(-leaf.along.v) / kDegree - angle_deg) < 0.1);
        CHECK(std::fabs(leaf.length_m - kWidth_m) < 0.02);
        size_t held = 0, foreign = 0;
        for (const Vec3& p : room.leaf) held += leaf.holds(p, 0.03);
        for (const Vec3& p : room.others) foreign += leaf.holds(p, 0.03);
        CHECK(held > 0.99 * static_cast<double>(room.leaf.size()));
        CHECK(foreign < 0.05 * static_cast<double>(room.others.size()));
      }
}

TEST_CASE("ajar_leaf__is_found_where_the_front_is_that_of_the_reveals") {
  // Of a leaf that stands open, reveals have more points at their front than its hinge has.
  const Room room(15, 1);
  AjarLeaf leaf;
  REQUIRE(find_ajar_leaf(room.all(), {kShut.at_m + 0.03, 0.002}, kEnds, kWidth_m, leaf));
  CHECK(std::fabs(std::asin(-leaf.along.v) / kDegree - 15) < 0.1);
}

TEST_CASE("ajar_leaf__shut_ones_stay_shut") {
  AjarLeaf leaf;
  for (uint64_t seed = 1; seed <= 10; ++seed)
    for (const double angle_deg : {0.0, 0.5, 1.0})
      CHECK(!find_ajar_leaf(Room(angle_deg, seed).all(),
                            {kShut.at_m, -std::tan(angle_deg * kDegree)}, kEnds, kWidth_m, leaf));
  CHECK(!find_ajar_leaf(Room(0, 1).others, kShut, kEnds, kWidth_m, leaf));
  CHECK(!find_ajar_leaf({}, kShut, kEnds, kWidth_m, leaf));
}
