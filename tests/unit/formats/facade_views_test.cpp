// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Fronts against facades set up at any angle.
#include "formats/facade_views.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/part_classes.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kMapRounding_m = 1e-8;

uint32_t add_part(Model& model, const char* part_class, uint64_t parent = kNoParent) {
  Part part;
  part.part_class = part_class;
  part.parent = parent;
  model.parts.push_back(part);
  return static_cast<uint32_t>(model.parts.size() - 1);
}

// An upright rectangle of a part, its left foot at a place, seen by one who looks against the direction of its normal.
void add_wall(Model& model, uint32_t part, const Vec3& foot, double angle, double width_m) {
  const Vec3 right{std::cos(angle) * width_m, std::sin(angle) * width_m, 0}, up{0, 0, 4};
  Face face;
  face.part = part;
  face.area_m2 = 4 * width_m;
  face.plane.normal = normalized(cross(right, up));
  model.add_face(face, {{foot, foot + right, foot + right + up, foot + up}});
}

}  // namespace

TEST_CASE("facade_views__the_house_has_one_front_that_its_ground_and_roof_belong_to") {
  const Model model = House().model();
  const auto facades = facades_side_by_side(model);
  REQUIRE(facades.size() == 1);
  CHECK(model.parts[facades[0].facade].part_class == part_class::kFacade);
  CHECK(facades[0].faces.size() == model.faces.size());
  CHECK(facades[0].left_m == 0);
  CHECK(std::fabs(facades[0].right_m - 12) < kMapRounding_m);
  CHECK(std::fabs(facades[0].bottom_m - 142.5) < kMapRounding_m);
}

TEST_CASE("facade_views__sheet_and_space_are_each_other_s_inverse_and_facades_do_not_touch") {
  for (const double angle : {0.0, 0.7, 2.0, 3.3, 5.9}) {
    Model model;
    const Vec3 foot{652000, 6861000, 80};
    const uint32_t a = add_part(model, part_class::kFacade),
                   b = add_part(model, part_class::kFacade);
    add_wall(model, add_part(model, part_class::kWall, a), foot, angle, 9);
    add_wall(model, add_part(model, part_class::kWall, b), foot, angle + 1.5, 5);
    const auto facades = facades_side_by_side(model);
    REQUIRE(facades.size() == 2);
    CHECK(std::fabs(facades[1].left_m - 11) < kMapRounding_m);
    CHECK(std::fabs(facades[1].right_m - 16) < kMapRounding_m);
    for (const PlacedFacade& facade : facades) {
      const Vec3 p = foot + Vec3{3, -2, 1.5};
      CHECK(norm(facade.in_space(facade.on_sheet(p)) - p) < kMapRounding_m);
    }
    CHECK(norm(facades[0].on_sheet(foot) - Vec3{0, 80, 0}) < kMapRounding_m);
  }
}

TEST_CASE("facade_views__what_lies_in_front_is_drawn_last_and_planes_stay_together") {
  using Order = std::vector<size_t>;
  CHECK(order_of_drawing({0.2, -0.1, 0.0}) == Order{1, 2, 0});
  CHECK(order_of_drawing({1e-9, 0, -1e-9}) == Order{0, 1, 2});
  CHECK(order_of_drawing({}).empty());
}
