// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// The wall with window surrounds by level rays across a window; what stands before and behind it by its places.

namespace {

Box3 ring_box(const Model& model, const Face& face) {
  Box3 box;
  const Ring& ring = model.rings[face.first_ring];
  for (uint64_t k = ring.first; k < ring.first + ring.count; ++k)
    box.add(model.vertices[model.corners[k]]);
  return box;
}

}  // namespace

TEST_CASE("scene_surrounds__steps_from_wall_to_surround_to_joinery_to_glass_at_each_window") {
  for (const double glass : {0.0, 0.02, 0.1}) {
    CAPTURE(glass);
    const Model model = built(build_surrounds, {.glass_m = glass});
    // Windows of 1.2 x 1.8 m amid cells of 3 x 3 m; joinery 8 cm inside, surrounds 15 cm outside of them.
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i)
        for (const double side : {-1.0, 1.0}) {
          const auto beside = [&](double du) {
            return front_y(model, 1.5 + 3 * i + side * du, 1.5 + 3 * j);
          };
          const auto over = [&](double dv) {
            return front_y(model, 1.5 + 3 * i, 1.5 + 3 * j + side * dv);
          };
          CHECK(beside(0.76) == doctest::Approx(0));
          CHECK(over(1.06) == doctest::Approx(0));
          for (const double in : {0.01, 0.14}) {
            CHECK(beside(0.6 + in) == doctest::Approx(-0.06).scale(0));
            CHECK(over(0.9 + in) == doctest::Approx(-0.06).scale(0));
          }
          for (const double in : {0.01, 0.07}) {
            CHECK(beside(0.6 - in) == doctest::Approx(0.20).scale(0));
            CHECK(over(0.9 - in) == doctest::Approx(0.20).scale(0));
          }
          if (glass > 0) CHECK(beside(0.51) == doctest::Approx(0.20 + glass));
          else CHECK(std::isinf(beside(0.51)));
        }
    const double panes = glass > 0 ? 0 : 12 * 1.04 * 1.64;
    CHECK(norm(shell_of(model, {}).vector_area + Vec3{0, 12 * 9 - panes, 0}) < kRounding_m);
  }
}

TEST_CASE("scene_unwanted__is_the_glazed_house_behind_what_stands_apart_from_it") {
  const Model house = built(build_surrounds, {.glass_m = 0.02}), model = built(build_unwanted);
  REQUIRE(model.faces.size() > house.faces.size());
  for (size_t i = 0; i < house.faces.size(); ++i) {
    CHECK(model.faces[i].plane.normal == house.faces[i].plane.normal);
    CHECK(model.faces[i].plane.offset == house.faces[i].plane.offset);
    CHECK(model.faces[i].area_m2 == house.faces[i].area_m2);
  }
  size_t before = 0, behind = 0;
  for (size_t t = house.triangles.size(); t < model.triangles.size(); ++t)
    for (const Vec3& p : corners_of(model, t)) {
      REQUIRE((p.y < -0.5 || p.y >= 0.8 - kRounding_m));  // nothing touches the house
      REQUIRE(p.y <= 6 + kRounding_m);
      ++(p.y < 0 ? before : behind);
    }
  CHECK(behind == 3 * 2 * 12 * 3);  // three sheets a window
  CHECK(before > 3 * 3 * 1000);     // leaves
  CHECK(parts_named(model, "tree").size() == 3);
  CHECK(parts_named(model, "car").size() == 2);
  CHECK(parts_named(model, "pedestrian").size() == 2);
}

TEST_CASE("scene_unwanted__spreads_furniture_evenly_behind_the_windows_by_its_seed") {
  double sum = 0, n = 0;
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const Model model = built(build_unwanted, {.seed = seed});
    int sheet = 0;
    for (const Face& face : model.faces) {
      if (model.parts[face.part].part_class != "ghost") continue;
      const int window = sheet++ / 3;
      const double x = 1.5 + 3 * (window % 4), z = 1.5 + 3 * (window / 4);
      const Box3 box = ring_box(model, face);
      CHECK(face.plane.normal == Vec3{0, -1, 0});
      CHECK(std::abs((box.min.x + box.max.x) / 2 - x) <= 1 + kRounding_m);
      CHECK(box.min.z <= z + 0.9);  // it begins no higher than the window ends
      CHECK(box.max.z <= 9 + kRounding_m);
      sum += box.min.y;
      n += 1;
    }
    CHECK(sheet == 36);
  }
  // Uniform between 0.8 and 6 m.
  CHECK(std::abs(sum / n - 3.4) < 5 * 5.2 / std::sqrt(12 * n));
  const Model one = built(build_unwanted, {.seed = 1}), again = built(build_unwanted, {.seed = 1}),
              other = built(build_unwanted, {.seed = 2});
  CHECK(one.vertices == again.vertices);
  CHECK(one.vertices != other.vertices);
}
