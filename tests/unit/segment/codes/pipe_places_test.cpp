// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/pipe_places.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "unit/segment/codes/coded.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// The outer half of a pipe of 38 mm about (10, 5), and a wall 10 cm behind its axis.
CloudPtr half_pipe(uint64_t seed, int on_pipe = 2000, int on_wall = 3000, double wall_y = 5.1) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  const double half_turn = std::acos(-1.0);
  for (int i = 0; i < on_pipe; ++i) {
    const double angle = half_turn * random.uniform(), r = 0.038 + 0.002 * random.normal();
    points.push_back({10 + r * std::cos(angle), 5 - r * std::sin(angle), 2.8 * random.uniform()});
  }
  for (int i = 0; i < on_wall; ++i)
    points.push_back(
        {9.5 + random.uniform(), wall_y + 0.002 * random.normal(), 2.8 * random.uniform()});
  return cloud_of(points);
}

}  // namespace

TEST_CASE("pipe_places__are_where_the_points_are") {
  for (uint64_t seed = 1; seed <= 5; ++seed)
    for (const double off : {0.0, 0.03}) {
      const std::string y = text_of(5 - off, 3);
      const CodedObjects all =
          surveyed("1;10;" + y + ";0;408\n2;10.038;" + y + ";0;409\n3;10;" + y + ";2.8;410\n");
      Task task;
      const auto places = pipe_places(*half_pipe(seed), all, task);
      REQUIRE(places.size() == 1);
      CHECK(std::fabs(places[0].off_m - off) < 0.003);
      CHECK(std::fabs(places[0].circle.radius - 0.038) < 0.002);
      CHECK(std::hypot(places[0].circle.centre.u + all.origin.x - 10,
                       places[0].circle.centre.v + all.origin.y - 5) < 0.003);
    }
}

TEST_CASE("pipe_places__a_wall_more_densely_scanned_than_its_pipe_does_not_draw_it") {
  const std::string building =
      "4;0;5.05;3;300.2\n5;20;5.05;3;300.4\n6;20;15;3;300.4\n7;0;15;3;300.4\n8;0;5.05;0;300.4\n";
  for (uint64_t seed = 1; seed <= 5; ++seed)
    for (const double off : {0.0, 0.03}) {
      const std::string y = text_of(5 - off, 3);
      const CodedObjects all = surveyed(building + "1;10;" + y + ";0;408\n2;10.038;" + y +
                                        ";0;409\n3;10;" + y + ";2.8;410\n");
      Task task;
      const auto places = pipe_places(*half_pipe(seed, 300, 60000, 5.045), all, task);
      REQUIRE(places.size() == 1);
      CHECK(std::fabs(places[0].off_m - off) < 0.003);
      CHECK(std::fabs(places[0].circle.radius - 0.038) < 0.002);
    }
}

TEST_CASE("pipe_places__a_wave_of_the_wall_as_round_as_the_pipe_is_not_taken_for_it") {
  // Crests of a corrugated sheet, 2.5 cm in waves of 20 cm, are arcs of 4 cm; one stands 2 cm behind the pipe's axis.
  const std::string building =
      "4;0;5.04;3;300.2\n5;20;5.04;3;300.4\n6;20;15;3;300.4\n7;0;15;3;300.4\n8;0;5.04;0;300.4\n";
  for (uint64_t seed = 1; seed <= 20; ++seed)
    for (const double off : {0.0, 0.03}) {
      RandomStream random(seed, 1);
      std::vector<Vec3> points;
      for (int i = 0; i < 3400; ++i) {
        const double angle = std::acos(-1.0) * random.uniform(),
                     r = 0.038 + 0.002 * random.normal();
        points.push_back(
            {10 + r * std::cos(angle), 5 - r * std::sin(angle), 2.8 * random.uniform()});
      }
      for (int i = 0; i < 28000; ++i) {
        const double x = random.uniform() - 0.5;
        points.push_back(
            {10 + x, 5.045 - 0.025 * std::cos(10 * std::acos(-1.0) * x) + 0.002 * random.normal(),
             2.8 * random.uniform()});
      }
      const std::string y = text_of(5 - off, 3);
      const CodedObjects all = surveyed(building + "1;10;" + y + ";0;408\n2;10.038;" + y +
                                        ";0;409\n3;10;" + y + ";2.8;410\n");
      Task task;
      const auto places = pipe_places(*cloud_of(points), all, task);
      REQUIRE(places.size() == 1);
      CHECK(std::fabs(places[0].off_m - off) < 0.003);
      CHECK(std::fabs(places[0].circle.radius - 0.038) < 0.002);
    }
}

TEST_CASE("pipe_places__none_without_a_round_of_points") {
  Task task;
  std::vector<Vec3> wall;
  for (int i = 0; i < 200; ++i) wall.push_back({0.01 * i, 0.03, 1});
  const CodedObjects all = surveyed("1;1;0;0;408\n2;1.038;0;0;409\n3;1;0;2.8;410\n");
  for (const PipePlace& place : pipe_places(*cloud_of(wall), all, task)) CHECK(place.off_m < 0.06);
  CHECK(pipe_places(*cloud_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), all, task).empty());
  CHECK(pipe_places(*cloud_of(wall), surveyed(""), task).empty());
}
