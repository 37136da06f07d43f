// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "scan/yard/sheets.h"
#include "geometry/polygon2.h"
#include "unit/scan/yard/yards.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("yard_surroundings__ground_lies_about_the_buildings_and_not_in_them") {
  const yard::Plan plan = yard_plan(YardZone::kFacades);
  SceneBuilder builder{Transform{}};
  yard::Sheets sheets(builder);
  add_surroundings(sheets, plan, 1);
  const Model model = builder.take();
  double ground = 0, gutter_top = 0;
  for (const Face& face : model.faces) {
    const std::string& part_class = model.parts[face.part].part_class;
    const Ring& ring = model.rings[face.first_ring];
    Vec3 middle;
    for (uint64_t c = 0; c < ring.count; ++c)
      middle +=
          model.vertices[model.corners[ring.first + c]] * (1.0 / static_cast<double>(ring.count));
    if (part_class == "gutter") {
      gutter_top = std::max(gutter_top, middle.z);
      CHECK(sheets.classes()[face.id - 1] == yard::kGutter);
      continue;
    }
    CHECK(sheets.classes()[face.id - 1] == yard::kRest);
    if (part_class != "ground") continue;
    ground += face.area_m2;
    CHECK(std::fabs(middle.z - yard::kGround_m) <= 0.02);
    CHECK(face.plane.normal.z == doctest::Approx(1));
    for (const yard::Building& b : plan.buildings)
      if (b.name != 'A') CHECK(!contains(b.outline, {middle.x, middle.y}));  // its wall stands back
  }
  CHECK(ground > 500);
  CHECK(gutter_top == doctest::Approx((yard::kGround_m + yard::kGutterTop_m) / 2));
}
