// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/positions.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// More points than a stretch of them, each of one of the surfaces or of none.
struct OwnedPoints : MadeScene {
  explicit OwnedPoints(uint32_t surfaces) : MadeScene(anywhere()) {
    RandomStream random(1, 3);
    for (uint32_t& owner : scene.owner) owner = static_cast<uint32_t>(random.below(surfaces + 1));
  }
  static std::vector<Vec3> anywhere() {
    RandomStream random(1, 4);
    std::vector<Vec3> points(150000);
    for (Vec3& p : points) p = {random.uniform(), random.uniform(), random.uniform()};
    return points;
  }
};

}  // namespace

TEST_CASE("take_positions__gives_each_surface_its_owners_points_ascending") {
  OwnedPoints made(3);
  std::vector<Surface> surfaces(3);
  take_positions(made.scene, surfaces, made.task);
  for (uint32_t s = 0; s < 3; ++s) {
    std::vector<uint32_t> expected;
    for (uint32_t p = 0; p < made.scene.size(); ++p)
      if (made.scene.owner[p] == s + 1) expected.push_back(p);
    CHECK(surfaces[s].positions == expected);
  }
}

TEST_CASE("move_positions__is_what_taking_all_anew_gives") {
  constexpr size_t kPart = 40000;  // points of a part of the moves
  OwnedPoints made(4);
  std::vector<Surface> surfaces(4), anew(4);
  take_positions(made.scene, surfaces, made.task);
  RandomStream random(2, 3);
  std::vector<std::vector<MovedPoint>> moves(made.scene.size() / kPart + 1);
  for (uint32_t p = 0; p < made.scene.size(); ++p) {
    uint32_t& owner = made.scene.owner[p];
    const auto now = static_cast<uint32_t>(random.below(4));  // the last surface only loses some
    if (random.below(10) != 0 || now == owner) continue;
    moves[p / kPart].push_back({p, owner, now});
    owner = now;
  }
  take_positions(made.scene, anew, made.task);
  move_positions(moves, surfaces, made.task);
  for (size_t s = 0; s < 4; ++s) CHECK(surfaces[s].positions == anew[s].positions);
}
