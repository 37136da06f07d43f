// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "geometry/delaunay2.h"
#include "geometry/polygon2.h"
#include "modelling/contour/boundary_rings.h"
#include "modelling/contour/contour.h"
#include "modelling/plane/cell_rows.h"
#include "modelling/plane/plane_frame.h"
#include "modelling/plane/spacing.h"

using namespace jalon;

namespace {

std::vector<Vec2> scattered(size_t n, double width, double height, uint64_t seed) {
  RandomStream random(seed, 5);
  std::vector<Vec2> out(n);
  for (Vec2& p : out) p = {width * random.uniform(), height * random.uniform()};
  return out;
}

}  // namespace

TEST_CASE("typical_spacing: grids, scattered points and national-grid offsets") {
  Task task;
  std::vector<Vec2> grid;
  for (int i = 0; i < 80; ++i)
    for (int j = 0; j < 60; ++j) grid.push_back({0.02 * i, 0.02 * j});
  CHECK(typical_spacing(grid, task) == doctest::Approx(0.02).epsilon(0.15).scale(0));
  const auto random = scattered(20000, 4, 2, 1);
  CHECK(typical_spacing(random, task) == doctest::Approx(0.02).epsilon(0.2).scale(0));
  std::vector<Vec2> line;
  for (int i = 0; i < 1000; ++i) line.push_back({0.01 * i, 0});
  CHECK(typical_spacing(line, task) > 0);
  CHECK(typical_spacing(std::vector<Vec2>(100, Vec2{1, 1}), task) == 0);
  CHECK(typical_spacing({}, task) == 0);
}

TEST_CASE("extract_contour: leaving out inner points changes no ring of the full triangulation") {
  Task task;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    auto points = scattered(30000, 5, 3, seed);
    std::erase_if(points, [](const Vec2& p) {
      return (p.u > 1 && p.u < 2 && p.v > 1 && p.v < 2) || std::hypot(p.u - 3.5, p.v - 1.5) < 0.6;
    });
    ContourSetting setting;
    setting.mode = ContourMode::kLongEdge;
    setting.max_edge_m = 0.1;
    const Contour contour = extract_contour(points, setting, task);
    REQUIRE(contour.pieces.size() == 1);
    REQUIRE(contour.pieces[0].openings.size() == 2);
    // The slow way: all points.
    auto triangles = delaunay(points);
    std::erase_if(triangles, [&](const Triangle2& t) {
      for (size_t k = 0; k < 3; ++k)
        if (norm(points[t[k]] - points[t[(k + 1) % 3]]) > 0.1) return true;
      return false;
    });
    const auto pieces = boundary_rings(triangles, points, task);
    REQUIRE(pieces.size() == 1);
    std::vector<size_t> fast{contour.pieces[0].outline.size()}, slow;
    for (const auto& opening : contour.pieces[0].openings) fast.push_back(opening.size());
    for (const auto& ring : pieces[0].rings) slow.push_back(ring.size());
    std::sort(fast.begin(), fast.end());
    std::sort(slow.begin(), slow.end());
    CHECK(fast == slow);
    CHECK(contour.pieces[0].area_m2 == doctest::Approx(pieces[0].area));
  }
}

TEST_CASE("extract_contour: the rings of a piece touch nowhere, however ragged the points") {
  Task task;
  size_t openings = 0, touching = 0;
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    ContourSetting setting;
    setting.alpha_factor = 0.9;  // so narrow that inner points become holes
    setting.min_opening_area_m2 = setting.min_opening_width_m = 0;
    const Contour contour = extract_contour(scattered(4000, 4, 2, seed), setting, task);
    for (const ContourPiece& piece : contour.pieces) {
      std::vector<std::pair<double, double>> all;
      const auto add = [&](const Chain& chain) {
        for (const Vec2& p : chain) all.emplace_back(p.u, p.v);
      };
      add(piece.outline);
      for (const Chain& opening : piece.openings) {
        add(opening);
        CHECK(signed_area(opening) < 0);
      }
      openings += piece.openings.size();
      const size_t count = all.size();
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
      touching += count - all.size();
    }
  }
  CHECK(openings > 5);
  CHECK(touching == 0);
}

TEST_CASE("eroded: marks cells with eight marked neighbours") {
  Task task;
  std::vector<Vec2> points;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      if (!(i == 4 && j == 4)) points.push_back({i + 0.5, j + 0.5});
  const CellRows rows = sort_into_cells(points, 1, task);
  REQUIRE(rows.keys.size() == 24);
  const std::vector<uint8_t> all(24, 1);
  const auto inner = eroded(rows, all);
  CHECK(std::count(inner.begin(), inner.end(), 1) ==
        8);  // 3 x 3 without the one at the missing corner
  CHECK(inner[rows.find(rows.key_of({1.5, 1.5}))] == 1);
  CHECK(inner[rows.find(rows.key_of({3.5, 3.5}))] == 0);
  CHECK(inner[rows.find(rows.key_of({0.5, 2.5}))] == 0);
}

TEST_CASE("sort_into_cells: a wide sparse raster costs memory by points and gives the same cells") {
  Task task;
  auto points = scattered(500, 1, 1, 3);
  points.push_back({1e6, 1e6});
  const CellRows rows = sort_into_cells(points, 0.01, task);
  REQUIRE(rows.order.size() == 501);
  CHECK(std::is_sorted(rows.keys.begin(), rows.keys.end()));
  for (size_t c = 0; c < rows.keys.size(); ++c)
    for (uint32_t k = rows.first[c]; k < rows.first[c + 1]; ++k)
      CHECK(rows.key_of(points[rows.order[k]]) == rows.keys[c]);
}

TEST_CASE("equivalent_width: rectangles, discs and slits") {
  CHECK(equivalent_width(1.2 * 1.8, 6) == doctest::Approx(1.2));
  CHECK(equivalent_width(0.01 * 5, 10.02) == doctest::Approx(0.01));
  CHECK(equivalent_width(3.14159, 6.28318) == doctest::Approx(std::sqrt(3.14159)));
}

TEST_CASE("plane_frame: v is up on walls, u follows the facade on floors, both right-handed") {
  for (const Vec3 normal :
       {Vec3{0, -1, 0}, normalized(Vec3{0.3, -0.8, 0.1}), normalized(Vec3{1, 1, 1}), Vec3{0, 0, 1},
        Vec3{0, 0, -1}, normalized(Vec3{0.05, 0, 1})}) {
    const PlaneFrame frame = plane_frame({normal, 2.5}, {10, 20, 30}, {1, 0, 0});
    CHECK(norm(cross(frame.axis_u, frame.axis_v) - normal) < 1e-12);
    if (std::fabs(normal.z) < 0.9) {
      CHECK(frame.axis_u.z == 0);
      CHECK(frame.axis_v.z > 0);
    } else {
      CHECK(frame.axis_u.x > 0.99);
    }
    const Vec3 p = frame.lift({1.5, -2});
    CHECK(std::fabs(dot(normal, p) - 2.5) < 1e-12);
    CHECK(norm(frame.project(p) - Vec2{1.5, -2}) < 1e-12);
  }
}

// What a cancel has to wait for where the points around one are most of the cloud: one of them.
TEST_CASE("contour__obeys_a_cancel_between_two_points_that_may_be_foreign") {
  std::vector<Vec2> points;
  for (double u = 0; u < 4; u += 0.05)
    for (double v = 0; v < 2; v += 0.05) points.push_back({u, v});
  std::atomic<bool> cancel{false};
  Task::Hooks hooks;
  hooks.threads = 1;
  hooks.cancel = &cancel;
  Task task(hooks);
  size_t asked = 0;
  CHECK_THROWS_AS(extract_contour(points, {}, task,
                                  [&](uint32_t, double) {
                                    ++asked;
                                    cancel = true;
                                    return false;
                                  }),
                  Error);
  CHECK(asked == 1);
}
