// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Pieces of one wall told from what fills the openings of another in the same plane.
#include <doctest/doctest.h>

#include "modelling/evidence/coplanar.h"
#include "modelling/evidence/pieces_apart.h"
#include "unit/modelling/layers.h"

using namespace jalon;
using layers::add_layer;
using layers::cut;
using layers::kStep_m;

namespace {

constexpr double kLeaves_m = 0.22;  // of dormers, and of the leaves of the doors

// A wall with two doors, their leaves, and two dormers over it in the plane of the leaves.
Segmentation mansard(bool has_dormers) {
  std::vector<Vec3> wall, first, second, left, right;
  add_layer(wall, 0, 0, 8, 6, 0);
  for (const double u : {1.0, 5.0}) {
    cut(wall, u, 0, 1.6, 2.6);
    add_layer(u < 2 ? first : second, u, 0, 1.6, 2.6, kLeaves_m);
  }
  add_layer(left, 1, 6, 1.6, 2.2, kLeaves_m);
  add_layer(right, 5, 6, 1.6, 2.2, kLeaves_m);
  std::vector<std::vector<Vec3>> parts{wall, first, second};
  if (has_dormers) parts.insert(parts.end(), {left, right});
  Segmentation out = walls::segmentation_of(parts);
  for (size_t s = 0; s < parts.size(); ++s)
    out.segments[s].area_m2 = kStep_m * kStep_m * static_cast<double>(parts[s].size());
  return out;
}

}  // namespace

TEST_CASE("pieces_apart__leaves_of_doors_leave_the_dormers_in_their_plane") {
  const Segmentation given = mansard(true);
  Task task;
  const std::vector<uint32_t> whole = whole_walls(given, 0.03, task);
  for (size_t s = 2; s <= 4; ++s) CHECK(whole[s] == whole[1]);  // all on one plane
  Segmentation segmentation = given;
  const auto evidence = gather_whole_walls(segmentation, 0.03, {}, task);
  std::vector<size_t> points(5);
  for (const uint32_t label : segmentation.labels->values<uint32_t>()) ++points[label - 1];
  CHECK(points[1] + points[2] == given.segments[1].point_count() + given.segments[2].point_count());
  CHECK(points[3] + points[4] == given.segments[3].point_count() + given.segments[4].point_count());
  for (size_t s = 1; s < 5; ++s) {
    if (points[s] == 0) continue;
    CHECK(evidence[s].role == (s < 3 ? PlaneRole::kFilling : PlaneRole::kWall));
  }
  CHECK(evidence[0].role == PlaneRole::kWall);
}

TEST_CASE("pieces_apart__leaves_alone_stay_together") {
  const Segmentation given = mansard(false);
  Task task;
  const std::vector<uint32_t> whole = whole_walls(given, 0.03, task);
  const Segmentation joined = joined_pieces(given, whole, task);
  const auto evidence = gather_evidence(joined, {}, task);
  CHECK(pieces_apart(given, whole, evidence, task) == whole);
}
