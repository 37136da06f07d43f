// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/opening_sides.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr double kDeep_m = 0.15;  // of the reveals; the sill falls by 7 cm
constexpr OpeningFront kAhead{0.01, 0.002};

struct Section {
  std::vector<Vec3> frame, reveals;
  std::vector<Vec3> all() const {
    std::vector<Vec3> out = frame;
    out.insert(out.end(), reveals.begin(), reveals.end());
    return out;
  }
};

/// A frame of 2 m by 1 m, 8 cm wide, and its reveals, 2 mm of noise.
Section frame_in_wall(uint64_t seed) {
  RandomStream random(seed, 0);
  const auto noise = [&] { return 0.002 * random.normal(); };
  Section out;
  for (int i = 0; i < 5000; ++i) {
    const double s = 2 * random.uniform(), z = 1 + random.uniform();
    if (s > 0.08 && s < 1.92 && z > 1.08 && z < 1.92) continue;
    out.frame.push_back({s, kAhead.before(s) + noise(), z});
  }
  for (int i = 0; i < 3000; ++i) {
    const double before = kDeep_m * random.uniform(), u = random.uniform();
    const auto at = [&](double s, double z) {
      out.reveals.push_back({s, kAhead.before(s) + before, z});
    };
    if (i % 4 == 0) at(noise(), 1 + u);
    if (i % 4 == 1) at(2 + noise(), 1 + u);
    if (i % 4 == 2) at(2 * u, 1 - 0.07 / kDeep_m * before + noise());
    if (i % 4 == 3) at(2 * u, 2 + noise());
  }
  return out;
}

}  // namespace

TEST_CASE("opening_sides__are_where_the_reveals_meet_the_frame") {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    // Corners were measured to a centimetre.
    const OpeningSides found(frame_in_wall(seed).all(), kAhead, {-0.01, 2.01, 1.01, 1.99});
    const double places[] = {0, 2, 1, 2}, slopes[] = {0, 0, -0.07 / kDeep_m, 0};
    for (size_t k = 0; k < 4; ++k) {
      CAPTURE(k);
      const OpeningSides::Side& side = found.sides()[k];
      REQUIRE(side.is_found);
      CHECK(std::fabs(side.at_m - places[k]) < 0.001);
      CHECK(std::fabs(side.slope - slopes[k]) < 0.03);
    }
  }
}

TEST_CASE("opening_sides__points_near_the_edge_go_to_the_nearer_surface") {
  const Section section = frame_in_wall(1);
  const OpeningSides found(section.all(), kAhead, {0, 2, 1, 2});
  size_t frame_lost = 0, reveals_kept = 0, reveals_near = 0;
  for (const Vec3& p : section.frame) frame_lost += found.is_reveal(p, kAhead);
  for (const Vec3& p : section.reveals) {
    const double before = p.y - kAhead.before(p.x);
    if (before >= kBeforeFront_m) continue;
    ++reveals_near;
    reveals_kept += !found.is_reveal(p, kAhead);
  }
  CHECK(reveals_near > 100);
  CHECK(reveals_kept < reveals_near / 3);
  CHECK(frame_lost < section.frame.size() / 100);
}

TEST_CASE("opening_sides__without_reveals_nothing_is_one") {
  const Section section = frame_in_wall(1);
  const OpeningSides found(section.frame, kAhead, {0, 2, 1, 2});
  for (const OpeningSides::Side& side : found.sides()) CHECK(!side.is_found);
  for (const Vec3& p : section.all()) CHECK(!found.is_reveal(p, kAhead));
  CHECK(!OpeningSides({}, kAhead, {0, 2, 1, 2}).is_reveal({0, 0.02, 1.5}, kAhead));
}
