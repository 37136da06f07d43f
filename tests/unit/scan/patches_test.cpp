// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/patches.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.h"
#include "unit/scan/plates.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("patches__are_the_groups_in_the_order_of_their_first_triangle") {
  Model model;
  add_plate(model, 0, 1, 0, 1);
  add_plate(model, 5, 6, 0, 1);
  add_plate(model, 1, 4, 0, 1);
  model.vertices.push_back({9, 9, 0});
  model.triangles.push_back({12, 12, 12});  // without area: of no patch
  model.triangle_faces.push_back(9);
  Task task;
  const FlatTriangles flats(model, task);
  UnionFind groups(flats.size());
  groups.join(2, 3);
  groups.join(0, 1);
  groups.join(4, 5);
  groups.join(5, 1);
  const Patches patches(flats, groups, task);
  REQUIRE(patches.size() == 2);
  const auto first = patches.triangles(0), second = patches.triangles(1);
  CHECK(std::vector<uint32_t>(first.begin(), first.end()) == std::vector<uint32_t>{0, 1, 4, 5});
  CHECK(std::vector<uint32_t>(second.begin(), second.end()) == std::vector<uint32_t>{2, 3});
  CHECK(patches[0].largest == 4);  // 1.5 m2, the first of the two
  CHECK(patches[0].box.min == Vec3{0, 0, 0});
  CHECK(patches[0].box.max == Vec3{4, 1, 0});
}

TEST_CASE("patches__boxes_meet_within_a_tenth_of_a_millimetre") {
  const Box3 a{{0, 0, 0}, {1, 1, 0}};
  for (int k = 0; k < 3; ++k)
    for (const double gap : {0.9e-4, 1.1e-4}) {
      Box3 b{{0, 0, 0}, {1, 1, 0}};
      b.min[k] = a.max[k] + gap;
      b.max[k] = b.min[k] + 1;
      CHECK(meet(a, b) == (gap < kTouching_m));
      CHECK(meet(b, a) == (gap < kTouching_m));
    }
  CHECK(meet(a, a));
}

TEST_CASE("patches__that_meet_share_the_one_bin_in_which_they_are_compared") {
  RandomStream random(7, 0);
  Model model;
  for (int i = 0; i < 200; ++i) {
    const double x = 20 * random.uniform(), y = 3 * random.uniform(),
                 z = 2 * static_cast<double>(random.below(3));
    const double length = 2 * random.uniform() + 0.1, width = random.uniform() + 0.1;
    add_plate(model, x, x + length, y, y + width, z);
  }
  Task task;
  const FlatTriangles flats(model, task);
  UnionFind groups(flats.size());
  for (uint32_t t = 0; t < flats.size(); t += 2) groups.join(t, t + 1);
  const Patches patches(flats, groups, task);
  REQUIRE(patches.size() == 200);
  const PatchBins bins(patches, task);
  CHECK(bins.size() > 1);
  const auto has = [&](size_t bin, uint32_t p) {
    const auto members = bins.members(bin);
    return std::count(members.begin(), members.end(), p) == 1;
  };
  size_t meeting = 0;
  for (uint32_t a = 0; a < patches.size(); ++a)
    for (uint32_t b = a + 1; b < patches.size(); ++b) {
      if (!meet(patches[a].box, patches[b].box)) continue;
      ++meeting;
      const size_t bin = bins.bin_of(patches[a].box, patches[b].box);
      REQUIRE(bin < bins.size());
      CHECK(bin == bins.bin_of(patches[b].box, patches[a].box));
      CHECK(has(bin, a));
      CHECK(has(bin, b));
    }
  CHECK(meeting > 10);
}

TEST_CASE("patches__of_an_empty_model_are_none") {
  Task task;
  const Model model;
  const FlatTriangles flats(model, task);
  UnionFind groups(0);
  CHECK(Patches(flats, groups, task).size() == 0);
}
