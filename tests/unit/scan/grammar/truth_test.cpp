// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "scan/grammar/truth.h"
#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

namespace {

Contour contour_of_truth(const TruthContour& contour) {
  Contour out;
  for (const TruthCorner& c : contour) out.push_back({c.at, c.sagitta_m});
  return out;
}

}  // namespace

TEST_CASE("truth__has_the_walls_and_openings_of_the_plan_in_their_planes") {
  for (const FacadeKind kind : all_kinds()) {
    CAPTURE(static_cast<int>(kind));
    const Plan plan = planned(kind, 6);
    const FacadeTruth truth = truth_of(plan, Transform{});
    CHECK(truth.kind == name_of(kind));
    REQUIRE(truth.walls.size() == plan.walls.size());
    REQUIRE(truth.openings.size() == openings_of(plan));
    size_t i = 0;
    for (size_t w = 0; w < plan.walls.size(); ++w) {
      const TruthWall& wall = truth.walls[w];
      CHECK(wall.origin == Vec3{0, plan.walls[w].y_m, 0});
      CHECK(wall.normal == Vec3{0, -1, 0});
      double open_m2 = 0;
      for (const PlannedOpening& o : plan.walls[w].openings) {
        const TruthOpening& found = truth.openings[i++];
        CHECK(found.wall == w);
        CHECK(found.opening_class == o.opening_class);
        CHECK(found.depth_m == o.depth_m);
        CHECK(found.storey == o.storey);
        const Contour contour = contour_of_truth(found.contour);
        CHECK(area_of(contour) == doctest::Approx(area_of(contour_of(o.shape))));
        CHECK(found.touches_ground == (bounds_of(contour).v0 == 0));
        if (found.touches_border) open_m2 += area_of(contour);
        size_t arcs = 0;
        for (const TruthCorner& c : found.contour) arcs += c.sagitta_m > 0;
        const Shape::Form form = o.shape.form;
        CHECK(arcs == (form == Shape::Form::kArched    ? 1
                       : form == Shape::Form::kPointed ? 2
                       : form == Shape::Form::kRound   ? 4
                                                       : 0));
      }
      CHECK(area_of(contour_of_truth(wall.outline)) ==
            doctest::Approx(area_of(plan.walls[w].outline) - open_m2));
      CHECK(wall.covers.size() == plan.walls[w].pads.size());
      CHECK(wall.area_m2 > 0);
      CHECK(wall.area_m2 < area_of(plan.walls[w].outline));
    }
  }
}

TEST_CASE("truth__rasters_are_read_by_place") {
  SightRaster raster;
  raster.cell_m = 0.5;
  raster.low = {1, 2};
  raster.columns = 2, raster.rows = 1;
  raster.cells = {Sight::kSeen, Sight::kHidden};
  CHECK(raster.at({1.1, 2.1}) == Sight::kSeen);
  CHECK(raster.at({1.6, 2.4}) == Sight::kHidden);
  for (const Vec2& p : {Vec2{0.9, 2.1}, Vec2{2.1, 2.1}, Vec2{1.1, 1.9}, Vec2{1.1, 2.6}})
    CHECK(raster.at(p) == Sight::kOutside);
}
