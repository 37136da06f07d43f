// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "compare/changes/regions.h"
#include "model/part_classes.h"
#include "report/pages/change_outlines.h"
#include "report/pages/zone_outlines.h"
#include "unit/compare/landslide/slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("zone_outlines__are_the_zones_and_what_was_not_measured_on_the_ground") {
  const auto gap = [](double x, double y) { return x > 18 && x < 22 && y > 15 && y < 27; };
  const Comparison made =
      compared_slopes(slope_survey(false, 1), slope_survey(true, 2, 60000, gap));
  Task task;
  const FieldTable points = region_points_table(change_regions(made, {}, task));
  const Model model = change_outlines({&made, &points}, {}, nullptr, {}, task);
  size_t down = 0, up = 0, unmeasured = 0;
  double unmeasured_m2 = 0, down_m2 = 0;
  for (const Face& face : model.faces) {
    const std::string& of = model.parts[face.part].part_class;
    down += of == part_class::kDepletion;
    up += of == part_class::kAccumulation;
    unmeasured += of == part_class::kUnmeasured;
    const double plan_m2 = face.area_m2 * face.plane.normal.z;
    if (of == part_class::kUnmeasured) unmeasured_m2 += plan_m2;
    if (of == part_class::kDepletion) down_m2 += plan_m2;
  }
  CHECK(down == 2);  // on either side of the strip
  CHECK(up == 1);
  CHECK(unmeasured >= 1);
  CHECK(unmeasured_m2 == doctest::Approx(48).epsilon(0.1));
  CHECK(down_m2 == doctest::Approx(24).epsilon(0.1));
  for (const Vec3& p : model.vertices) CHECK(std::abs(p.z - slope_ground(p.x, p.y, false)) < 0.8);
}

TEST_CASE("zone_outlines__need_the_regions_of_the_comparison") {
  const Comparison made =
      compared_slopes(slope_survey(false, 1, 20000), slope_survey(true, 2, 20000));
  Model model;
  CHECK_THROWS_AS(add_zone_outlines(made, {}, 0, model), Error);
  FieldTable points;
  points.set(make_column<uint32_t>({"region", ElementType::kUint32, 1, "", ""},
                                   std::vector<uint32_t>(made.cloud->size(), UINT32_MAX)));
  CHECK_THROWS_AS(add_zone_outlines(made, points, 0, model), Error);
}
