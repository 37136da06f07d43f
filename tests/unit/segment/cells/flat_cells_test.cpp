// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/cells/flat_cells.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "spatial/octree/morton.h"
#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Scene corner(uint64_t seed) {
  Scene scene;
  RandomStream random(seed, 0);
  scene.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 0, 3}, 12000, 0.003, random);
  scene.rectangle(2, {0, -3, 0}, {4, 0, 0}, {0, 3, 0}, 12000, 0.003, random);
  return scene;
}

// All points of a scene.
struct AllPoints {
  std::vector<uint32_t> positions;
  CellPoints points;
  explicit AllPoints(const MadeScene& made)
      : positions(made.scene.size()), points{*made.scene.tree, {}} {
    std::iota(positions.begin(), positions.end(), 0u);
    points.positions = positions;
  }
};

const SplitRule kSplit{0.025, 0.05, 6};

}  // namespace

TEST_CASE("flat_cells__hold_points_of_one_plane_each_and_most_of_all") {
  const Scene scene = corner(4);
  MadeScene made(scene.points);
  const AllPoints all(made);
  const auto cells = split_cells(all.points, kSplit, made.task);
  size_t held = 0, before = 0;
  for (const FlatCell& cell : cells) {
    CHECK(cell.first >= before);
    before = cell.last;
    held += cell.last - cell.first;
    CHECK(cell.fit.sigma <= 0.42 * 0.025);
    CHECK(cell.moments.n == cell.last - cell.first);
  }
  CHECK(static_cast<double>(held) > 0.95 * static_cast<double>(scene.points.size()));
}

TEST_CASE("flat_cells__touch_when_their_cubes_do") {
  const Scene scene = corner(5);
  MadeScene made(scene.points);
  const Octree& tree = *made.scene.tree;
  const AllPoints all(made);
  const auto cells = split_cells(all.points, kSplit, made.task);
  const auto touching = touching_cells(all.points, cells, made.task);
  struct Cube3 {
    int64_t low[3], edge;
  };
  std::vector<Cube3> cubes;
  for (const FlatCell& cell : cells) {
    const int shift = kMaxLevel - cell.level;
    const CellNumbers at = cell_numbers(tree.code(cell.first) >> (3 * shift));
    cubes.push_back({{int64_t{at.p} << shift, int64_t{at.q} << shift, int64_t{at.r} << shift},
                     int64_t{1} << shift});
  }
  for (uint32_t a = 0; a < cells.size(); ++a)
    for (uint32_t b = 0; b < cells.size(); ++b) {
      bool near = a != b;
      for (int k = 0; k < 3; ++k)
        near = near && cubes[a].low[k] <= cubes[b].low[k] + cubes[b].edge &&
               cubes[b].low[k] <= cubes[a].low[k] + cubes[a].edge;
      if (std::binary_search(touching[a].begin(), touching[a].end(), b) != near) {
        CAPTURE(a);
        FAIL(b);
      }
    }
}

TEST_CASE("flat_cells__merge_to_the_two_planes_of_a_corner") {
  const Scene scene = corner(6);
  MadeScene made(scene.points);
  const AllPoints all(made);
  const auto cells = split_cells(all.points, kSplit, made.task);
  std::vector<uint32_t> labels;
  std::vector<Plane> planes;
  const auto touching = touching_cells(all.points, cells, made.task);
  const uint32_t count = merge_cells(cells, touching, {0.025, 0.17}, labels, planes, made.task);
  REQUIRE(count == planes.size());
  std::vector<uint64_t> points(count, 0);
  for (size_t c = 0; c < cells.size(); ++c) points[labels[c] - 1] += cells[c].moments.n;
  std::sort(points.rbegin(), points.rend());
  CHECK(points[0] + points[1] > 22500);
  CHECK(points[1] > 11000);
}
