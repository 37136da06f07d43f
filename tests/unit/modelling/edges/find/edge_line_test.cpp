// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Lines of contour edges and where they meet.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "modelling/edges/find/edge_line.h"
#include "modelling/edges/find/straighten.h"

using namespace jalon;

namespace {

std::vector<Vec2> points_along(const EdgeLine& line, int n, double step_m) {
  std::vector<Vec2> out;
  for (int i = 0; i < n; ++i) out.push_back(line.point + line.direction * (step_m * i));
  return out;
}

constexpr StraightenSetting kPlain{0.02, 0.04, 0, 0};

}  // namespace

TEST_CASE("edge_line__runs_through_its_points_their_way_and_outliers_do_not_turn_it") {
  for (const Vec2& d : {Vec2{0.6, 0.8}, Vec2{-0.6, 0.8}, Vec2{-0.8, -0.6}}) {
    const EdgeLine truth{{3, -2}, d};
    std::vector<Vec2> points = points_along(truth, 40, 0.02);
    for (size_t i = 0; i < points.size(); ++i)  // evenly on both sides
      points[i] = points[i] + Vec2{-d.v, d.u} * (i % 2 == 0 ? 0.001 : -0.001);
    const EdgeLine clean = fit_edge_line(points, kPlain);
    points[12] = points[12] + Vec2{-d.v, d.u} * 0.05;
    points.front() = points.front() + Vec2{-d.v, d.u} * 0.03;  // a corner that was cut
    const EdgeLine line = fit_edge_line(points, kPlain);
    for (const EdgeLine* l : {&clean, &line}) {
      CHECK(dot(l->direction, d) > 0.99999);
      CHECK(std::fabs(truth.distance(l->point)) < 2e-4);
    }
  }
}

TEST_CASE("edge_line__nearly_upright_ones_become_so_and_move_outward_by_the_set_back") {
  const StraightenSetting setting{0.02, 0.04, 0.05, 0.007};
  const EdgeLine level{{0, 5}, {std::cos(0.03), std::sin(0.03)}};
  auto points = points_along(level, 41, 0.05);
  const EdgeLine line = fit_edge_line(points, setting);
  CHECK(line.direction == Vec2{1, 0});
  // The mean height of its points, and to the right of the walk: down.
  CHECK(line.point.v == doctest::Approx(5 + 1.0 * std::sin(0.03) - 0.007).epsilon(1e-9));
  std::vector<Vec2> down;
  for (const Vec2& p : points) down.push_back({p.v, -p.u});
  const EdgeLine turned = fit_edge_line(down, setting);
  CHECK(turned.direction == Vec2{0, -1});
  CHECK(turned.point.u == doctest::Approx(line.point.v));  // a quarter turn clockwise of the same
  const EdgeLine slanted{{0, 5}, {std::cos(0.1), std::sin(0.1)}};
  CHECK(fit_edge_line(points_along(slanted, 41, 0.05), setting).direction.v ==
        doctest::Approx(std::sin(0.1)));
}

TEST_CASE("edge_line__upright_lines_meet_to_the_last_bit_and_flat_ones_do_not") {
  const EdgeLine upright{{1.0 / 3, 7}, {0, 1}}, level{{9, 0.1}, {-1, 0}};
  CHECK(*intersect(upright, level, 0.1) == Vec2{1.0 / 3, 0.1});
  const EdgeLine slanted{{0, 0}, {0.6, 0.8}};
  const auto corner = intersect(slanted, level, 0.1);
  REQUIRE(corner);
  CHECK(corner->v == 0.1);
  CHECK(std::fabs(slanted.distance(*corner)) < 1e-15);
  const EdgeLine flat{{0, 0}, {std::cos(0.09), std::sin(0.09)}};
  CHECK(!intersect(flat, level, 0.1));
  CHECK(intersect(flat, level, 0.05));
}

TEST_CASE("edge_line__aligned_is_within_5_degrees_the_same_way") {
  const auto at = [](double degrees) {
    const double a = degrees * 0.017453292519943295;
    return EdgeLine{{0, 0}, {std::cos(a), std::sin(a)}};
  };
  CHECK(are_aligned(at(10), at(14.9)));
  CHECK(!are_aligned(at(10), at(15.1)));
  CHECK(!are_aligned(at(10), at(190)));
}

TEST_CASE("edge_line__a_trimmed_mean_leaves_out_the_lowest_and_highest_sixth") {
  std::vector<double> values{1000, 2, 3, 4, 5, -500};
  CHECK(trimmed_mean(values) == 3.5);
  std::vector<double> few{1, 2, 9};
  CHECK(trimmed_mean(few) == 4);
  std::vector<double> one{7};
  CHECK(trimmed_mean(one) == 7);
}
