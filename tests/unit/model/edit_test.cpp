// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "model/edit.h"

using namespace jalon;

namespace {

// A wall of 6 x 4 m with two round-headed windows and their panes 0.2 m behind; the second repeats the first.
Model wall_with_copy() {
  Model model;
  model.parts.push_back({"facade", "facade", kNoParent});
  model.parts.push_back({"wall", "wall", 0});
  Face wall;
  wall.part = 1;
  wall.plane = {{0, -1, 0}, 0};
  const auto hole = [](double x) {
    return std::vector<Vec3>{{x, 0, 1}, {x, 0, 2}, {x + 1, 0, 2}, {x + 1, 0, 1}};
  };
  model.add_face(wall, {{{0, 0, 0}, {6, 0, 0}, {6, 0, 4}, {0, 0, 4}}, hole(1), hole(4)});
  for (int k = 0; k < 2; ++k) {
    const auto window = static_cast<uint32_t>(model.parts.size());
    model.parts.push_back({"window " + std::to_string(k + 1), "window", 1});
    model.parts.push_back({"joinery", "joinery", window});
    Face pane;
    pane.part = window + 1;
    pane.plane = {{0, -1, 0}, -0.2};
    const double x = k == 0 ? 1 : 4;
    model.add_face(pane, {{{x, 0.2, 1}, {x + 1, 0.2, 1}, {x + 1, 0.2, 2}, {x, 0.2, 2}}});
    model.rings[static_cast<size_t>(1 + k)].part = window;
  }
  model.parts[4].evidence = Evidence::kCopied;
  model.parts[4].copied_from = 2;
  model.sagittas.assign(model.corners.size(), 0);
  model.sagittas[5] = model.sagittas[9] = -0.5;  // heads of the holes
  const double semicircle = std::numbers::pi / 8;
  model.faces[0].area_m2 = 24 - 2 * (1 + semicircle);
  return model;
}

}  // namespace

TEST_CASE("edit: a renamed part leaves the old model as it was") {
  const Model model = wall_with_copy();
  const Model renamed = with_renamed_part(model, 2, "kitchen", "door");
  CHECK(renamed.parts[2].name == "kitchen");
  CHECK(renamed.parts[2].part_class == "door");
  CHECK(model.parts[2].name == "window 1");
  CHECK_THROWS_AS(with_renamed_part(model, 99, "", ""), Error);
}

TEST_CASE("edit: the veto of a copy closes its hole and keeps all else") {
  const Model model = wall_with_copy();
  const Model less = without_copy(model, 4);
  validate(less);
  REQUIRE(less.parts.size() == 4);
  CHECK(less.parts[3].parent == 2);
  REQUIRE(less.faces.size() == 2);
  CHECK(less.faces[0].ring_count == 2);
  CHECK(less.rings[less.faces[0].first_ring + 1].part == 2);
  CHECK(less.faces[1].part == 3);
  CHECK(less.vertices.size() == 12);
  CHECK(less.sagittas.size() == less.corners.size());
  CHECK(std::fabs(less.faces[0].area_m2 - (24 - 1 - std::numbers::pi / 8)) < 1e-12);
  CHECK(model.faces.size() == 3);
}

TEST_CASE("edit: only copies can be vetoed") {
  const Model model = wall_with_copy();
  for (const uint64_t part :
       {uint64_t{0}, uint64_t{1}, uint64_t{2}, uint64_t{3}, uint64_t{5}, uint64_t{6}, kNoParent})
    CHECK_THROWS_AS(without_copy(model, part), Error);
}
