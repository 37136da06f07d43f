// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/grid_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "unit/segment/lines/scanned.h"
#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// A grid in the plane y = 0, 0.1 m from point to point, but for those left out.
struct FlatGrid {
  std::vector<Vec3> points;
  std::vector<uint32_t> places;
  FlatGrid(uint32_t edge, const std::vector<uint32_t>& left_out) {
    for (uint32_t i = 0; i < edge * edge; ++i) {
      if (std::ranges::find(left_out, i) != left_out.end()) continue;
      points.push_back({0.1 * (i % edge), 0, 0.1 * (i / edge)});
      places.push_back(i);
    }
  }
};

struct Meshed {
  MadeScene made;
  CloudPtr organised;
  LocalMesh mesh;
  Meshed(const std::vector<Vec3>& points, CloudPtr cloud, const MeshRule& rule = {})
      : made(points), organised(std::move(cloud)) {
    const Octree& tree = *made.scene.tree;
    const auto grids = scan_grids(*organised, tree, made.scene.owner, made.task);
    mesh = grid_mesh(tree, grids, rule, made.task);
  }
  double area() const {
    double area = 0;
    const Octree& tree = *made.scene.tree;
    for (const auto& t : mesh.triangles) {
      const Vec3 a = tree.local(t[0]);
      area += norm(cross(tree.local(t[1]) - a, tree.local(t[2]) - a)) / 2;
    }
    return area;
  }
};

Meshed meshed(const FlatGrid& grid, uint32_t edge, const MeshRule& rule = {}) {
  std::vector<uint32_t> rows, columns;
  for (const uint32_t place : grid.places) {
    rows.push_back(place / edge);
    columns.push_back(place % edge);
  }
  return {grid.points, with_places(grid.points, rows, columns), rule};
}

}  // namespace

TEST_CASE("grid_mesh__covers_what_four_or_three_neighbours_span") {
  CHECK(meshed(FlatGrid(6, {}), 6).area() == doctest::Approx(0.25).epsilon(1e-6).scale(0));
  // A corner and a place in the middle: of the squares about the latter a half each is left.
  CHECK(meshed(FlatGrid(6, {0}), 6).area() == doctest::Approx(0.245).epsilon(1e-6).scale(0));
  CHECK(meshed(FlatGrid(6, {14}), 6).area() == doctest::Approx(0.23).epsilon(1e-6).scale(0));
  CHECK(meshed(FlatGrid(6, {14, 15}), 6).area() == doctest::Approx(0.21).epsilon(1e-6).scale(0));
}

TEST_CASE("grid_mesh__has_no_edge_beyond_the_search_distance") {
  CHECK(meshed(FlatGrid(6, {}), 6, {.search_m = 0.09}).mesh.triangles.empty());
  CHECK(meshed(FlatGrid(6, {}), 6, {.search_m = 0.12}).mesh.triangles.empty());  // diagonals
  CHECK(meshed(FlatGrid(6, {}), 6, {.search_m = 0.15}).mesh.triangles.size() == 50);
}

TEST_CASE("grid_mesh__lists_its_triangles_ascending_at_each_corner") {
  const Meshed m = meshed(FlatGrid(5, {7}), 5);
  size_t listed = 0;
  for (uint32_t p = 0; p < m.made.scene.size(); ++p) {
    const auto own = m.mesh.triangles_at(p);
    CHECK(std::ranges::is_sorted(own));
    for (const uint32_t t : own) {
      const auto& corners = m.mesh.triangles[t];
      CHECK(std::ranges::is_sorted(corners));
      CHECK(std::ranges::find(corners, p) != corners.end());
    }
    listed += own.size();
  }
  CHECK(listed == 3 * m.mesh.triangles.size());
}

TEST_CASE("grid_mesh__roughness_is_the_noise_of_a_wall_and_infinite_off_the_grid") {
  Scanned scanned({{{-3, 6, -2}, {6, 0, 0}, {0, 0, 4}}}, 0.01, 0.004, 3);
  scanned.scene.points.push_back({0, 3, 0});
  scanned.rows.push_back(scanned.rows[0]);  // behind another return
  scanned.columns.push_back(scanned.columns[0]);
  const Meshed m(scanned.scene.points, scanned.cloud(true));
  std::vector<float> roughness = m.mesh.roughness_m;
  std::nth_element(roughness.begin(),
                   roughness.begin() + static_cast<ptrdiff_t>(roughness.size() / 2),
                   roughness.end());
  CHECK(static_cast<double>(roughness[roughness.size() / 2]) ==
        doctest::Approx(0.004).epsilon(0.2).scale(0));
  CHECK(std::ranges::count(m.mesh.roughness_m, INFINITY) == 1);
}

TEST_CASE("grid_mesh__spans_steps_in_depth_about_as_seldom_as_local_triangles") {
  const Scanned scanned(scanned_house(), 0.01, 0.002, 5);
  const Meshed m(scanned.scene.points, scanned.cloud(true));
  const auto ghosts = [&](const LocalMesh& mesh) {
    const auto across = std::ranges::count_if(mesh.triangles, [&](const auto& t) {
      const auto face = [&](uint32_t p) { return scanned.scene.faces[m.made.point(p)]; };
      return face(t[0]) != face(t[1]) || face(t[1]) != face(t[2]);
    });
    return static_cast<double>(across) / static_cast<double>(mesh.triangles.size());
  };
  Task task;
  const double grid = ghosts(m.mesh), local = ghosts(local_mesh(*m.made.scene.tree, {}, task));
  MESSAGE("FIGURE triangles across faces: " << 100 * grid << " % of the grid's, " << 100 * local
                                            << " % of local ones");
  CHECK(grid < 0.03);
}
