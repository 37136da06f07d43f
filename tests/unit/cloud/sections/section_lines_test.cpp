// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/section_lines.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"

namespace jalon {
namespace {

constexpr double kSigma_m = 0.005;

void add_side(std::vector<Vec2>& points, const Vec2& a, const Vec2& b, size_t n,
              RandomStream& random) {
  const Vec2 d = b - a;
  const double length = std::sqrt(d.u * d.u + d.v * d.v);
  for (size_t i = 0; i < n; ++i) {
    const double t = random.uniform(), off = kSigma_m * random.normal();
    points.push_back(a + d * t + Vec2{-d.v / length, d.u / length} * off);
  }
}

// A room 4 x 3 m with a pier, turned, by 250 points a metre.
std::vector<Vec2> corners_of_room() {
  std::vector<Vec2> room{{0, 0},     {4, 0},     {4, 3},   {2.5, 3},
                         {2.5, 2.6}, {2.1, 2.6}, {2.1, 3}, {0, 3}};
  const double c = std::cos(0.3), s = std::sin(0.3);
  for (Vec2& p : room) p = {c * p.u - s * p.v, s * p.u + c * p.v};
  return room;
}
std::vector<Vec2> room(uint64_t seed) {
  RandomStream random(seed, 1);
  std::vector<Vec2> points;
  const std::vector<Vec2> corners = corners_of_room();
  for (size_t k = 0; k < corners.size(); ++k) {
    const Vec2 a = corners[k], b = corners[(k + 1) % corners.size()], d = b - a;
    add_side(points, a, b, static_cast<size_t>(250 * std::sqrt(d.u * d.u + d.v * d.v)), random);
  }
  return points;
}

double nearest(const Vec2& p, const std::vector<Vec2>& to) {
  double best = INFINITY;
  for (const Vec2& q : to) best = std::min(best, std::hypot(q.u - p.u, q.v - p.v));
  return best;
}

std::vector<SectionLine> lines_of(const std::vector<Vec2>& points, SectionSettings settings = {}) {
  double cell_m = 0;
  Task task;
  return section_lines(points, settings, cell_m, task);
}

TEST_CASE("section_lines__a_room_is_one_loop_with_its_corners") {
  for (const uint64_t seed : {1, 2, 3}) {
    const std::vector<SectionLine> lines = lines_of(room(seed));
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].is_closed);
    const std::vector<Vec2> truth = corners_of_room();
    REQUIRE(lines[0].vertices.size() == truth.size());
    for (const Vec2& corner : truth) CHECK(nearest(corner, lines[0].vertices) < kSigma_m);
    CHECK(lines[0].rms_m == doctest::Approx(kSigma_m).epsilon(0.1).scale(0));
    CHECK(lines[0].length_m == doctest::Approx(14.8).epsilon(0.001));
    CHECK(lines[0].points > 0.98 * 250 * 14.8);
  }
}

TEST_CASE("section_lines__the_order_of_the_points_changes_no_bit") {
  std::vector<Vec2> points = room(4);
  const std::vector<SectionLine> first = lines_of(points);
  std::reverse(points.begin(), points.end());
  std::rotate(points.begin(), points.begin() + 1234, points.end());
  const std::vector<SectionLine> second = lines_of(points);
  REQUIRE(first.size() == second.size());
  for (size_t k = 0; k < first.size(); ++k) {
    CHECK(first[k].vertices == second[k].vertices);
    CHECK(first[k].rms_m == second[k].rms_m);
  }
}

TEST_CASE("section_lines__an_arc_is_followed_within_the_tolerance") {
  RandomStream random(5, 1);
  std::vector<Vec2> points;
  for (int i = 0; i < 6000; ++i) {
    const double turn = std::numbers::pi * random.uniform(), r = 4 + kSigma_m * random.normal();
    points.push_back({r * std::cos(turn), r * std::sin(turn)});
  }
  SectionSettings settings;
  const std::vector<SectionLine> lines = lines_of(points, settings);
  REQUIRE(lines.size() == 1);
  CHECK_FALSE(lines[0].is_closed);
  for (const Vec2& p : lines[0].vertices)
    CHECK(std::fabs(std::hypot(p.u, p.v) - 4) < settings.tolerance_m);
  for (size_t k = 0; k + 1 < lines[0].vertices.size(); ++k) {
    const Vec2 middle = (lines[0].vertices[k] + lines[0].vertices[k + 1]) * 0.5;
    CHECK(std::fabs(std::hypot(middle.u, middle.v) - 4) < settings.tolerance_m);
  }
  CHECK(lines[0].vertices.size() < 30);
}

TEST_CASE("section_lines__break_off_at_gaps_and_end_with_their_points") {
  RandomStream random(6, 1);
  std::vector<Vec2> points;
  add_side(points, {0, 0}, {2, 0}, 1000, random);
  add_side(points, {2.5, 0}, {5, 0}, 1000, random);
  add_side(points, {7, 0}, {7.1, 0}, 50, random);  // too short to be told
  const std::vector<SectionLine> lines = lines_of(points);
  REQUIRE(lines.size() == 2);
  CHECK(nearest({0, 0}, lines[0].vertices) < 0.02);
  CHECK(nearest({2, 0}, lines[0].vertices) < 0.02);
  CHECK(nearest({2.5, 0}, lines[1].vertices) < 0.02);
  SectionSettings bridged;
  bridged.gap_m = 0.6;
  CHECK(lines_of(points, bridged).size() == 1);
}

TEST_CASE("section_lines__nothing_of_nothing") {
  CHECK(lines_of({}).empty());
  CHECK(lines_of({{1, 1}}).empty());
  CHECK(lines_of(std::vector<Vec2>(100, Vec2{3, 4})).empty());
  SectionSettings all;
  all.min_length_m = 0;
  for (const SectionLine& line : lines_of({{0, 0}, {0.1, 0}}, all)) CHECK(line.length_m > 0);
}

}  // namespace
}  // namespace jalon
