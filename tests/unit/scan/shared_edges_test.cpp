// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/shared_edges.h"

#include <doctest/doctest.h>

#include <bit>

#include "unit/scan/plates.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct Joined {
  std::vector<uint32_t> root;
  std::vector<uint8_t> inner;
};

Joined joined(const Model& model) {
  Task task;
  const FlatTriangles flats(model, task);
  UnionFind groups(flats.size());
  Joined out;
  out.inner = join_by_edges(flats, groups, task);
  for (uint32_t t = 0; t < flats.size(); ++t) out.root.push_back(groups.find(t));
  return out;
}

}  // namespace

TEST_CASE("shared_edges__join_plates_side_by_side_by_the_coordinates_of_their_edge") {
  Model model;
  add_plate(model, 0, 1, 0, 1);
  add_plate(model, 1, 2, 0, 1);    // a whole edge in common, vertices of its own
  add_plate(model, 2, 3, 0.5, 1);  // part of an edge
  add_plate(model, 0, 1, 1, 2, 0.5);
  const Joined j = joined(model);
  CHECK(j.root == std::vector<uint32_t>{0, 0, 0, 0, 4, 4, 6, 6});
  // Diagonals are inner edges; so is x = 1 from both sides: edge 1 of triangle 0, edge 2 of triangle 3.
  CHECK(j.inner == std::vector<uint8_t>{0b110, 0b001, 0b100, 0b101, 0b100, 0b001, 0b100, 0b001});
}

TEST_CASE("shared_edges__do_not_join_planes_at_an_angle") {
  Model model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  model.triangles = {{0, 1, 2}, {0, 1, 3}};
  model.triangle_faces = {1, 2};
  const Joined j = joined(model);
  CHECK(j.root == std::vector<uint32_t>{0, 1});
  CHECK(j.inner == std::vector<uint8_t>{0, 0});
}

TEST_CASE("shared_edges__of_both_sides_of_a_sheet_join_but_stay_a_border") {
  Model model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  model.triangles = {{0, 1, 2}, {1, 0, 2}};
  model.triangle_faces = {1, 1};
  const Joined j = joined(model);
  CHECK(j.root == std::vector<uint32_t>{0, 0});
  CHECK(j.inner == std::vector<uint8_t>{0, 0});
}

TEST_CASE("shared_edges__of_a_large_grid_make_it_one_with_only_its_rim_open") {
  constexpr int kSide = 60;
  Model model;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) add_plate(model, i, i + 1, j, j + 1);
  const Joined j = joined(model);
  size_t inner = 0;
  for (size_t t = 0; t < j.root.size(); ++t) {
    CHECK(j.root[t] == 0);
    inner += static_cast<size_t>(std::popcount(j.inner[t]));
  }
  CHECK(3 * j.root.size() - inner == 4 * kSide);
  CHECK(joined(Model{}).inner.empty());
}
