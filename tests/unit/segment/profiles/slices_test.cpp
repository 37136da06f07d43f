// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/profiles/slices.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("slices__of_a_corner_are_two_lines_each") {
  Scene scene;
  RandomStream random(2, 0);
  scene.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 0, 2}, 8000, 0.002, random);
  scene.rectangle(2, {0, 0, 0}, {0, 3, 0}, {0, 0, 2}, 6000, 0.002, random);
  MadeScene made(scene.points);
  const SliceRule rule{{0, 0, 1}, 0.25, 0.1, 0.05, 0.2, 0.025};
  const auto lines = profile_lines(made.scene, rule, made.task);
  std::set<uint32_t> slices;
  double length = 0;
  for (const ProfileLine& line : lines) {
    slices.insert(line.slice);
    length += std::hypot(line.to.u - line.from.u, line.to.v - line.from.v);
    CHECK(line.moments.n == line.positions.size());
    PlaneFit fit;
    REQUIRE(fit_plane(line.moments, fit));
  }
  CHECK(slices.size() >= 8);
  CHECK(length == doctest::Approx(7.0 * static_cast<double>(slices.size())).epsilon(0.06).scale(0));
  for (size_t i = 0; i + 1 < lines.size(); ++i) CHECK(lines[i].slice <= lines[i + 1].slice);
}

TEST_CASE("slices__through_planes_at_an_angle_are_lines_though_slices_are_thick") {
  Scene scene;
  RandomStream random(3, 0);
  // Leaning by 45 degrees: it rises by the slice's 0.25 m within each slice.
  scene.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 2, 2}, 8000, 0.002, random);
  MadeScene made(scene.points);
  const SliceRule rule{{0, 0, 1}, 0.25, 0.25, 0.05, 0.2, 0.025};
  const auto lines = profile_lines(made.scene, rule, made.task);
  REQUIRE(!lines.empty());
  double length = 0, slope = 0;
  for (const ProfileLine& line : lines) {
    const Vec2 d = line.to - line.from;
    length += std::hypot(d.u, d.v);
    slope = std::max(slope, std::fabs(d.v / d.u));
  }
  const double slices = lines.back().slice + 1.0;
  CHECK(length == doctest::Approx(4 * slices).epsilon(0.06).scale(0));
  CHECK(slope < 0.05);
}
