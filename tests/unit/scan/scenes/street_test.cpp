// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// The street by level rays toward its two sides: closed fronts, and what the second epoch moved.

namespace {

Model street_of(int epoch) { return built(build_street, {.epoch = epoch}); }

/// How far the front is from a line between columns and walls, on the north side or the south side.
double to_front(const Model& model, double x, double z, bool north) {
  return first_hit(model, {x, north ? 7.4 : -7.2, z}, {0, north ? 1.0 : -1.0, 0}).distance;
}

/// Toward the street, of the wall at this place; the row of "epoch" tells the sizes, the places are the recipe's.
double moved_m(double x, double z, bool north) {
  if (z < 0.05 || z > 1.15) return 0;
  const double along = std::fmod(x, 20);
  if (north) return along < 4 || along > 10 ? 0 : x < 20 ? 0.005 : x < 40 ? 0.020 : 0.100;
  if (x < 20) return along < 10 || along > 16 ? 0 : -0.020;  // from the other end of the facade
  return x < 40 && along > 2 && along < 18 ? 0.005 : 0;
}

}  // namespace

TEST_CASE("scene_street__its_six_fronts_are_closed_and_look_into_the_street") {
  const Model street = street_of(1);
  RandomStream random(1, 0);
  for (int k = 0; k < 400; ++k) {
    const bool north = k % 2 == 0;
    const double x = 60 * random.uniform(), z = 12 * random.uniform();
    const Hit hit = first_hit(street, {x, north ? 7.4 : -7.2, z}, {0, north ? 1.0 : -1.0, 0});
    REQUIRE(hit.is_front);
    REQUIRE(hit.distance < 1.5);  // the walls stand back 0.35 m at most, the panes 0.25 m
  }
  double walls = 0, panes = 0;
  std::map<uint32_t, const Face*> glass;
  for (const Face& face : street.faces) {
    const std::string& part_class = street.parts[face.part].part_class;
    if (part_class == "wall") walls += face.area_m2;
    if (part_class != "pane") continue;
    panes += face.area_m2;
    // The panes of a facade share their id and their plane.
    const Face& other = *glass.emplace(face.id, &face).first->second;
    CHECK(face.plane.normal == other.plane.normal);
    CHECK(std::abs(face.plane.offset - other.plane.offset) < kRounding_m);
  }
  CHECK(glass.size() == 6);
  CHECK(walls + panes == doctest::Approx(20 * (12 + 15 + 18 + 14 + 12 + 16)));
}

TEST_CASE("scene_street__second_epoch_moves_five_patches_and_nothing_else_of_the_fronts") {
  const Model before = street_of(1), after = street_of(2);
  int moved = 0;
  for (const bool north : {true, false})
    for (double x = 0.3; x < 60; x += 1)
      for (const double z : {0.03, 0.1, 1.1, 1.17, 2.5}) {
        CAPTURE(x);
        CAPTURE(z);
        CAPTURE(north);
        const double expected = moved_m(x, z, north);
        const double nearer = to_front(before, x, z, north) - to_front(after, x, z, north);
        REQUIRE(std::abs(nearer - expected) < kRounding_m);
        moved += expected != 0;
      }
  CHECK(moved == 2 * (4 * 6 + 16));  // four patches of 6 m and one of 16 m, at two heights
  CHECK(parts_named(before, "change").empty());
  CHECK(parts_named(after, "change").size() == 5);
}

TEST_CASE("scene_street__second_epoch_has_one_box_gone_one_new_and_a_pole") {
  const Model before = street_of(1), after = street_of(2);
  const auto height = [](const Model& model, double x, double y) { return top_z(model, x, y); };
  for (const Model* model : {&before, &after}) {
    CHECK(height(*model, 12, 3.4) == doctest::Approx(1.5));
    CHECK(height(*model, 50, 3.8) == doctest::Approx(1.6));
    CHECK(height(*model, 54, -2) == doctest::Approx(1.8));  // the sphere stands on the ground
    CHECK(std::abs(height(*model, 5, 0)) < kRounding_m);
  }
  CHECK(height(before, 34, -3.6) == doctest::Approx(1.4));
  CHECK(std::abs(height(after, 34, -3.6)) < kRounding_m);
  CHECK(std::abs(height(before, 24, -3.7)) < kRounding_m);
  CHECK(height(after, 24, -3.7) == doctest::Approx(1.5));
  const auto to_pole = [](const Model& model, double z) {
    return first_hit(model, {27, 3, z}, {0, 1, 0}).distance;
  };
  CHECK(to_pole(before, 5.9) > 4);
  CHECK(to_pole(after, 5.9) == doctest::Approx(0.9).epsilon(0.001).scale(0));
  CHECK(to_pole(after, 6.1) > 4);
}
