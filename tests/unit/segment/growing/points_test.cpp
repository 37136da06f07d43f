// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What growing works on against clouds of known density, normal and outliers.
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "segment/growing/points.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct GrownCloud {
  CloudPtr cloud;
  Task task;
  SegmentScene scene;

  explicit GrownCloud(const Scene& from)
      : cloud(cloud_of(from.points)),
        scene(indexed_scene(*cloud, GrowingSettings{}.surface, task)) {}
  Vec3 normal(size_t position) const {
    const float* n = &scene.normals[3 * position];
    return {n[0], n[1], n[2]};
  }
};

Scene leaning_wall(size_t count, double sigma_m) {
  Scene out;
  RandomStream random(4, 12);
  out.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 0.3, 2}, count, sigma_m, random);
  return out;
}

// Away from its borders, where neighbourhoods are half as wide.
bool well_inside(const Vec3& p) { return p.x > 0.3 && p.x < 3.7 && p.z > 0.3 && p.z < 1.7; }

}  // namespace

TEST_CASE("points_to_grow__sparse_points_are_all_taken_with_their_normal_and_spacing") {
  const Scene wall = leaning_wall(6000, 0.003);
  GrownCloud made(wall);
  const GrowingPoints points = points_to_grow(made.scene, GrowingSettings{}, made.task);
  CHECK(points.tree == made.scene.tree);
  CHECK(points.positions.empty());
  CHECK(points.points_per_member == 1);
  const double per_m2 = 6000 / (4 * std::hypot(2.0, 0.3));
  const Vec3 normal = normalized(Vec3{0, 2, -0.3});
  double area = 0;
  size_t inside = 0, askew = 0;
  for (size_t p = 0; p < made.scene.size(); ++p) {
    const Vec3 at = wall.points[made.scene.order[p]];
    if (!well_inside(at)) continue;
    ++inside;
    area += std::pow(static_cast<double>(made.scene.spacing[p]), 2);
    askew += std::fabs(dot(made.normal(p), normal)) < std::cos(0.2);
  }
  // The disc that reaches to the 15th other point holds 15 of a random sample on average, 16 by the convention;
  // some 250 discs apart from each other, each right to 1 / sqrt(15): 0.02. Four of these.
  CHECK(area / static_cast<double>(inside) * per_m2 ==
        doctest::Approx(15.0 / 16).epsilon(0.08).scale(0));
  CHECK(askew * 200 <
        inside);  // 3 mm over an rms width of 4 cm, 16 points: 1 degree; 11 are far out
}

TEST_CASE("points_to_grow__of_dense_points_one_of_each_cell_stands_for_its_free_neighbours") {
  const Scene wall = leaning_wall(60000, 0.003);  // 12 mm apart, tolerance 25 mm
  GrownCloud made(wall);
  for (size_t p = 0; p < made.scene.size(); p += 3) made.scene.owner[p] = 5;
  const GrowingPoints points = points_to_grow(made.scene, GrowingSettings{}, made.task);
  const size_t members = points.tree->size();
  REQUIRE(points.positions.size() == members);
  CHECK(members < 28000);  // of 40 000
  CHECK(members > 12800);  // cells no wider than the tolerance cover the wall's 8.1 m2
  CHECK(points.points_per_member == doctest::Approx(40000.0 / static_cast<double>(members)));
  const std::set<uint32_t> distinct(points.positions.begin(), points.positions.end());
  CHECK(distinct.size() == members);
  size_t strange = 0, askew = 0;
  const Plane truth{normalized(Vec3{0, 2, -0.3}), 0};
  double off_m = 0;
  for (size_t i = 0; i < members; ++i) {
    CHECK(made.scene.owner[points.position(i)] == 0);
    off_m += truth.distance(made.cloud->point(made.scene.order[points.position(i)]));
    // Both trees round to a 2^31st of their cube.
    strange += norm(points.tree->local(i) + points.tree->cube().origin -
                    made.cloud->point(made.scene.order[points.position(i)])) > 1e-8;
  }
  CHECK(strange == 0);
  // The middle ones of their cells lie on neither side.
  CHECK(std::fabs(off_m / static_cast<double>(members)) < 4 * 0.003 / std::sqrt(12800.0));
  size_t inside = 0, unknown = 0;
  for (size_t p = 0; p < made.scene.size(); ++p) {
    if (made.scene.owner[p] != 0 || !well_inside(wall.points[made.scene.order[p]])) continue;
    ++inside;
    unknown += std::isnan(made.normal(p).x);
    askew += std::fabs(dot(made.normal(p), truth.normal)) < std::cos(0.3);
    CHECK(made.scene.spacing[p] > 0);
  }
  // 16 members a cell of 16 mm apart are 16 mm wide, by chance less than the 12.5 mm that a normal needs; 3 mm over 16
  // mm and sqrt(16) points is 3 degrees.
  CHECK(askew * 1000 < inside);
  CHECK(unknown * 20 < inside);
  // A free point and the one that stands for it share a cell no wider than the tolerance.
  Neighbour near[1];
  for (size_t p = 1; p < made.scene.size(); p += 33) {
    points.tree->knn(made.cloud->point(made.scene.order[p]), 1, near);
    if (made.scene.owner[p] == 0)
      CHECK(std::sqrt(near[0].squared_distance) <= 0.025 * std::sqrt(3.0));
  }
}

TEST_CASE("points_to_grow__a_point_off_its_neighbours_is_isolated_and_borders_are_not") {
  Scene wall = leaning_wall(6000, 0.003);
  const std::vector<Vec3> lonely{{1, 1.2, 1}, {3, -0.8, 1}, {5, 0, 1}};
  wall.points.insert(wall.points.end(), lonely.begin(), lonely.end());
  wall.faces.resize(wall.points.size(), 0);
  GrownCloud made(wall);
  const GrowingPoints points = points_to_grow(made.scene, GrowingSettings{}, made.task);
  size_t of_wall = 0;
  for (size_t i = 0; i < points.tree->size(); ++i) {
    const bool on_wall = wall.faces[made.scene.order[points.position(i)]] == 1;
    if (!on_wall) CHECK(points.isolated[i] == 1);
    else of_wall += points.isolated[i];
  }
  CHECK(of_wall < 60);  // one in a hundred
}

TEST_CASE("points_to_grow__points_of_one_line_of_a_scan_have_no_normal") {
  for (const double apart_m : {0.4, 0.04}) {
    Scene lines;
    RandomStream random(5, 12);
    for (int line = 0; line < 10; ++line)
      lines.rectangle(1, {0, apart_m * line, 0}, {4, 0, 0}, {0, 0, 0}, 160, 0.003, random);
    GrownCloud made(lines);
    const GrowingPoints points = points_to_grow(made.scene, GrowingSettings{}, made.task);
    REQUIRE(points.tree->size() == 1600);
    size_t known = 0;
    for (size_t p = 0; p < 1600; ++p) known += !std::isnan(made.normal(p).x);
    // 16 points of one line reach 0.2 m to either side and are as wide as the noise.
    if (apart_m > 0.2) CHECK(known < 160);
    else CHECK(known > 1440);
  }
}

TEST_CASE("points_to_grow__leaves_across_a_gap_are_neighbours_when_gap_m_spans_it") {
  Scene panels;
  RandomStream random(6, 12);
  panels.rectangle(1, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2000, 0.002, random);
  panels.rectangle(2, {1.3, 0, 0}, {1, 0, 0}, {0, 0, 1}, 2000, 0.002, random);
  for (const double gap_m : {0.0, 0.25, 0.4}) {
    GrownCloud made(panels);
    GrowingSettings settings;
    settings.gap_m = gap_m;
    const GrowingPoints points = points_to_grow(made.scene, settings, made.task);
    const auto face_of = [&](size_t leaf) {
      return panels.faces[made.scene.order[points.position(points.leaf_first()[leaf])]];
    };
    size_t across = 0, along = 0;
    for (size_t leaf = 0; leaf < points.leaves(); ++leaf)
      for (const uint32_t next : points.graph.of(leaf))
        ++(face_of(leaf) == face_of(next) ? along : across);
    CAPTURE(gap_m);
    CHECK(along > points.leaves());
    CHECK((across > 0) == (gap_m > 0.3));
  }
}
