// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/found_planes.h"

#include <doctest/doctest.h>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Two halves of one wall, a floor, and a volume of clutter, each its own owner.
Scene pieces() {
  Scene scene;
  RandomStream random(9, 0);
  scene.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, 4000, 0.003, random);
  scene.rectangle(2, {2, 0, 0}, {2, 0, 0}, {0, 0, 2}, 4000, 0.003, random);
  scene.rectangle(3, {0, -2, 0}, {4, 0, 0}, {0, 2, 0}, 8000, 0.003, random);
  for (int i = 0; i < 300; ++i) {
    scene.points.push_back({4 * random.uniform(), -2 * random.uniform(), 0.5 + random.uniform()});
    scene.faces.push_back(4);
  }
  return scene;
}

}  // namespace

TEST_CASE("found_planes__are_fitted_and_clutter_is_set_free") {
  const Scene scene = pieces();
  MadeScene made(scene.points);
  for (uint32_t p = 0; p < made.scene.size(); ++p)
    made.scene.owner[p] = static_cast<uint32_t>(scene.faces[made.point(p)]);
  const auto surfaces = surfaces_of_owners(made.scene, 4, made.task);
  REQUIRE(surfaces.size() == 4);
  for (size_t k = 0; k < 2; ++k) {
    CHECK(std::fabs(surfaces[k].plane.normal.y) > 0.9999);
    CHECK(surfaces[k].sigma_m == doctest::Approx(0.003).epsilon(0.05).scale(0));
    CHECK(surfaces[k].area_m2 == doctest::Approx(4).epsilon(0.1));
  }
  CHECK(surfaces[3].positions.empty());
  for (uint32_t p = 0; p < made.scene.size(); ++p)
    if (scene.faces[made.point(p)] == 4) REQUIRE(made.scene.owner[p] == 0);
}

TEST_CASE("found_planes__pieces_of_one_wall_end_as_one_segment") {
  const Scene scene = pieces();
  MadeScene made(scene.points);
  for (uint32_t p = 0; p < made.scene.size(); ++p)
    made.scene.owner[p] = static_cast<uint32_t>(scene.faces[made.point(p)]);
  auto surfaces = surfaces_of_owners(made.scene, 4, made.task);
  const Segmentation s = settled_segmentation(made.cloud, made.scene, surfaces, made.task);
  REQUIRE(s.segments.size() == 2);
  CHECK(s.segments[0].fit.n + s.segments[1].fit.n >= 15900);
  CHECK(s.segments[1].fit.covariance[0] >= 0);
}
