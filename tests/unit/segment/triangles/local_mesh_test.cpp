// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/local_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double area_of(const Octree& tree, const LocalMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = tree.local(t[0]);
    area += norm(cross(tree.local(t[1]) - a, tree.local(t[2]) - a)) / 2;
  }
  return area;
}

}  // namespace

TEST_CASE("local_mesh__of_a_wall_covers_it_about_once") {
  Scene scene;
  RandomStream random(6, 0);
  scene.rectangle(1, {0, 0, 0}, {3, 0, 0}, {0, 0, 2}, 2400, 0, random);
  MadeScene made(scene.points);
  const Octree& tree = *made.scene.tree;
  const LocalMesh mesh = local_mesh(tree, {.k = 20}, made.task);
  const double area = area_of(tree, mesh);
  CHECK(area > 5.4);  // edges of chance gaps are longer than three spacings
  CHECK(area < 6.1);
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    CHECK(t[0] < t[1]);
    CHECK(t[1] < t[2]);
    ++edges[{t[0], t[1]}];
    ++edges[{t[1], t[2]}];
    ++edges[{t[0], t[2]}];
  }
  const auto crowded = std::ranges::count_if(edges, [](const auto& e) { return e.second > 2; });
  CHECK(100 * static_cast<size_t>(crowded) < edges.size());
  for (uint32_t p = 0; p < tree.size(); ++p)
    for (const uint32_t t : mesh.triangles_at(p))
      CHECK(std::ranges::find(mesh.triangles[t], p) != mesh.triangles[t].end());
}

TEST_CASE("local_mesh__stars_that_agree_keep_ghost_triangles_out") {
  // A wall and, 0.12 m before it, a strip: triangles from one to the other are ghosts.
  Scene scene;
  RandomStream random(7, 0);
  scene.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, 1600, 0.004, random);
  scene.rectangle(2, {0.8, -0.12, 0}, {0.4, 0, 0}, {0, 0, 2}, 320, 0.004, random);
  MadeScene made(scene.points);
  const auto ghosts = [&](uint32_t least_stars) {
    const LocalMesh mesh =
        local_mesh(*made.scene.tree, {.k = 16, .least_stars = least_stars}, made.task);
    return std::ranges::count_if(mesh.triangles, [&](const auto& t) {
      const auto face = [&](uint32_t p) { return scene.faces[made.point(p)]; };
      return face(t[0]) != face(t[1]) || face(t[1]) != face(t[2]);
    });
  };
  MESSAGE("FIGURE ghost triangles: " << ghosts(1) << " from single stars, " << ghosts(2)
                                     << " where two agree");
  CHECK(2 * ghosts(2) < ghosts(1));
}

TEST_CASE("local_mesh__below_the_spacing_has_no_triangles") {
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k) points.push_back({0.1 * i, 0.1 * k, 0});
  MadeScene made(points);
  CHECK(local_mesh(*made.scene.tree, {.search_m = 0.09}, made.task).triangles.empty());
  CHECK(local_mesh(*made.scene.tree, {.search_m = 0.15}, made.task).triangles.size() >= 500);
}
