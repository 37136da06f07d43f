// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/slid_points.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "cloud/sections/sections.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

constexpr double kSlab_m = 0.05, kSlidTolerance_m = 0.02, kSlidNoise_m = 0.004;

// A wall through the origin whose normal leans out of the section by so many degrees: u across its trace, v along it.
std::vector<Vec3> leaning_wall(uint64_t seed, double lean_deg, double noise_m) {
  RandomStream random(seed, 17);
  const double lean = lean_deg * std::numbers::pi / 180;
  std::vector<Vec3> points;
  for (int i = 0; i < 6000; ++i) {
    const double along = 4 * random.uniform(), w = kSlab_m * (random.uniform() - 0.5);
    const double off = noise_m * random.normal() / std::cos(lean);
    points.push_back({-w * std::tan(lean) + off, along, w});
  }
  return points;
}

double rms_across(const std::vector<Vec2>& points) {
  double sum = 0;
  for (const Vec2& p : points) sum += p.u * p.u;
  return std::sqrt(sum / static_cast<double>(points.size()));
}

TEST_CASE("slid_points__of_a_leaning_wall_scatter_by_its_noise_alone") {
  Task task;
  for (const double lean_deg : {10.0, 30.0, 45.0, 60.0})
    for (uint64_t seed = 1; seed < 6; ++seed) {
      CAPTURE(lean_deg);
      const auto out =
          slid_points(leaning_wall(seed, lean_deg, kSlidNoise_m), kSlab_m, kSlidTolerance_m, task);
      const double noise_across = kSlidNoise_m / std::cos(lean_deg * std::numbers::pi / 180);
      CHECK(rms_across(out) < 1.15 * noise_across);
    }
}

TEST_CASE("slid_points__of_an_upright_wall_stay_where_they_are") {
  Task task;
  size_t moved = 0;
  for (uint64_t seed = 1; seed < 6; ++seed) {
    std::vector<Vec3> points = leaning_wall(seed, 0, kSlidNoise_m);
    std::ranges::sort(points, {}, [](const Vec3& p) { return std::pair(p.x, p.y); });
    const auto out = slid_points(points, kSlab_m, kSlidTolerance_m, task);
    for (size_t i = 0; i < out.size(); ++i) moved += out[i].u != points[i].x;
  }
  CHECK(moved < 600);  // of 30 000
}

TEST_CASE("slid_points__of_a_face_in_the_section_and_of_few_stay_above_their_feet") {
  Task task;
  RandomStream random(3, 18);
  std::vector<Vec3> floor;
  for (int i = 0; i < 4000; ++i)
    floor.push_back({2 * random.uniform(), 2 * random.uniform(), 0.003 * random.normal()});
  std::ranges::sort(floor, {}, [](const Vec3& p) { return std::pair(p.x, p.y); });
  const auto out = slid_points(floor, kSlab_m, kSlidTolerance_m, task);
  for (size_t i = 0; i < out.size(); ++i) CHECK(out[i] == Vec2{floor[i].x, floor[i].y});
  CHECK(slid_points({}, kSlab_m, kSlidTolerance_m, task).empty());
  CHECK(slid_points({{1, 2, 0.02}}, kSlab_m, kSlidTolerance_m, task) == std::vector<Vec2>{{1, 2}});
  CHECK(slid_points({{1e300, -1e300, 0.02}}, kSlab_m, kSlidTolerance_m, task).size() == 1);
}

// A room of 5 x 4 m, 2.8 m high, turned about the vertical: its walls meet upright sections at an angle.
std::vector<Vec3> turned_room(uint64_t seed, double turn_deg) {
  RandomStream random(seed, 19);
  const double turn = turn_deg * std::numbers::pi / 180, c = std::cos(turn), s = std::sin(turn);
  std::vector<Vec3> points;
  for (int i = 0; i < 400000; ++i) {
    const auto side = random.below(6);
    const double a = random.uniform(), b = random.uniform(), off = 0.003 * random.normal();
    Vec3 p;
    if (side < 2) p = {side == 0 ? off : 5 + off, 4 * a, 2.8 * b};
    else if (side < 4) p = {5 * a, side == 2 ? off : 4 + off, 2.8 * b};
    else p = {5 * a, 4 * b, side == 4 ? off : 2.8 + off};
    p = p - Vec3{2.5, 2, 0};
    points.push_back({c * p.x - s * p.y, s * p.x + c * p.y, p.z});
  }
  return points;
}

TEST_CASE("sections__at_an_angle_to_walls_have_one_line_and_four_corners") {
  Task task;
  SectionSettings settings;
  settings.direction = {1, 0, 0};
  settings.at_m = {-0.4, 0.5};
  for (const double turn_deg : {25.0, 45.0}) {
    CAPTURE(turn_deg);
    const Sections sections = cut_sections(cloud_of(turned_room(1, turn_deg)), {}, settings, task);
    for (const Section& section : sections.sections) {
      REQUIRE(section.lines.size() == 1);
      CHECK(section.lines[0].is_closed);
      CHECK(section.lines[0].vertices.size() == 4);
      CHECK(section.lines[0].rms_m < 0.006);
    }
  }
}

TEST_CASE("sections__at_an_angle_to_walls_stay_under_jitter_rounding_order_and_grid") {
  Task task;
  SectionSettings settings;
  settings.direction = {1, 0, 0};
  settings.at_m = {0.5};
  const std::vector<Vec3> room = turned_room(2, 25);
  const auto outline_of = [&](std::vector<Vec3> points) {
    const Sections sections = cut_sections(cloud_of(points), {}, settings, task);
    REQUIRE(sections.sections[0].lines.size() == 1);
    CHECK(sections.sections[0].lines[0].is_closed);
    REQUIRE(sections.sections[0].lines[0].vertices.size() == 4);
    return sections.sections[0].lines[0].vertices;
  };
  const auto as_it_is = outline_of(room);
  std::vector<Vec3> jittered = room, rounded = room, reversed(room.rbegin(), room.rend()),
                    on_grid = room;
  RandomStream random(2, 20);
  for (size_t i = 0; i < room.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      jittered[i][k] += 0.0003 * random.normal();
      rounded[i][k] = std::round(room[i][k] * 1000) / 1000;
      on_grid[i][k] += k == 0 ? 652000 : k == 1 ? 6862000 : 100;
    }
  CHECK(outline_of(reversed) == as_it_is);
  outline_of(jittered);
  outline_of(rounded);
  settings.at_m = {652000.5};
  outline_of(on_grid);
}

}  // namespace
}  // namespace jalon
