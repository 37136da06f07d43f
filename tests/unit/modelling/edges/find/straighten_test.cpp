// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "modelling/edges/find/straighten.h"

using namespace jalon;

namespace {

// A polygon's border as a chain: a point every step, inside by up to a step (the solid is on the left).
std::vector<Vec2> ragged(const std::vector<Vec2>& polygon, double step, double rag, uint64_t seed) {
  RandomStream random(seed, 3);
  std::vector<Vec2> out;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double length = norm(b - a);
    const Vec2 along = (b - a) * (1 / length), inward{-along.v, along.u};
    for (double t = step; t < length - step; t += step)
      out.push_back(a + along * t + inward * (rag * random.uniform()));
  }
  return out;
}

StraightenSetting setting_of(double spacing) {
  StraightenSetting s;
  s.max_edge_m = 4 * spacing;
  s.tolerance_m = 2 * spacing;
  s.snap_angle_rad = 0.05;
  s.set_back_m = 0.5 * spacing;
  return s;
}

}  // namespace

TEST_CASE("straightened: a ragged rectangle gives four corners, exactly upright") {
  const std::vector<Vec2> truth{{0, 0}, {3, 0}, {3, 2}, {0, 2}};
  const auto polygon = straightened(ragged(truth, 0.02, 0.02, 1), setting_of(0.02));
  REQUIRE(polygon.size() == 4);
  for (size_t i = 0; i < 4; ++i) {
    const Vec2 edge = polygon[(i + 1) % 4] - polygon[i];
    CHECK((edge.u == 0 || edge.v == 0));
    double nearest = INFINITY;
    for (const Vec2& p : truth) nearest = std::min(nearest, norm(p - polygon[i]));
    CHECK(nearest < 0.01);
  }
}

TEST_CASE("straightened: turned by any angle a rectangle keeps four corners") {
  for (double angle = 0; angle < 1.6; angle += 0.1) {
    std::vector<Vec2> truth;
    for (const Vec2 p : {Vec2{0, 0}, Vec2{3, 0}, Vec2{3, 2}, Vec2{0, 2}})
      truth.push_back({p.u * std::cos(angle) - p.v * std::sin(angle),
                       p.u * std::sin(angle) + p.v * std::cos(angle)});
    const auto polygon = straightened(ragged(truth, 0.02, 0.02, 2), setting_of(0.02));
    CAPTURE(angle);
    REQUIRE(polygon.size() == 4);
    for (const Vec2& p : truth) {
      double nearest = INFINITY;
      for (const Vec2& q : polygon) nearest = std::min(nearest, norm(p - q));
      CHECK(nearest < 0.06);  // snapping may turn it by up to 3 degrees
    }
  }
}

TEST_CASE("straightened: random rings stay simple and keep their sense") {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    RandomStream random(seed, 9);
    std::vector<Vec2> star;
    const size_t n = 3 + random.below(60);
    for (size_t i = 0; i < n; ++i) {
      const double angle = 2 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(n);
      const double radius = 0.1 + random.uniform() * (seed % 2 == 0 ? 0.1 : 1.0);
      star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const auto polygon = straightened(star, setting_of(0.02));
    CAPTURE(seed);
    REQUIRE(polygon.size() >= 3);
    CHECK(is_simple(polygon));
    CHECK(signed_area(polygon) > 0);
  }
}

TEST_CASE("fitted_rectangle: takes rectangles and refuses other forms") {
  const std::vector<Vec2> window{
      {0, 0}, {0, 2}, {1, 2}, {1, 0}};  // clockwise: the solid is outside
  const auto polygon = fitted_rectangle(ragged(window, 0.02, 0.02, 4), setting_of(0.02));
  REQUIRE(polygon.size() == 4);
  CHECK(-signed_area(polygon) == doctest::Approx(2).epsilon(0.01));
  const std::vector<Vec2> triangle{{0, 0}, {0, 2}, {1, 0}};
  CHECK(fitted_rectangle(ragged(triangle, 0.02, 0.02, 4), setting_of(0.02)).empty());
  const std::vector<Vec2> l_shape{{0, 0}, {0, 2}, {0.5, 2}, {0.5, 1}, {1, 1}, {1, 0}};
  CHECK(fitted_rectangle(ragged(l_shape, 0.02, 0.02, 4), setting_of(0.02)).empty());
}
