// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Walls as closed volumes, their thicknesses, and arcs drawn alike everywhere.
#include "modelling/facade/wall_solid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/cloud/clouds.h"
#include "unit/modelling/model_checks.h"
#include "unit/modelling/planned_scene.h"

using namespace planned;

TEST_CASE("wall_solid__is_closed_and_holds_the_face_times_its_thickness") {
  Model model;
  SharedVertices shared;
  PlaneVertices vertices(model, shared, street_frame(0.5));
  for (const char* name : {"wall", "window", "reveal"})
    append_part(model, name, name, kNoParent, Evidence::kMeasured);
  const VectorFace face{ring_of({{0, 0}, {6, 0}, {6, 4}, {3, 5.5}, {0, 4}}),
                        {hole({1, 1}, {2, 3}), hole({4, 1}, {5, 2})}};
  Face front;
  front.plane = {{0, -1, 0}, 0.5};
  append_wall_solid(model, vertices, face, front, {1, kNoPart}, {2, 0}, 0.3);
  REQUIRE(model.solids.size() == 1);
  CHECK(model.solids[0].face_count == 2 + 5 + 4 + 4);
  CHECK(checks::solid_fault(model, model.solids[0]).empty());
  CHECK(volume_within(model, 0, model.faces.size()) ==
        doctest::Approx((24 + 4.5 - 2 - 1) * 0.3).epsilon(1e-12));
  size_t reveals = 0, holes = 0;
  for (const Face& side : model.faces) {
    CHECK(checks::ring_fault(model, side).empty());
    CHECK(side.plane.distance(model.vertices[model.corners[model.rings[side.first_ring].first]]) ==
          doctest::Approx(0));
    reveals += side.part == 2;
  }
  for (const Ring& ring : model.rings) holes += ring.part == 1;
  CHECK(reveals == 4);
  CHECK(holes == 2);  // in front and behind
}

TEST_CASE("wall_thicknesses__are_medians_of_known_depths_or_those_of_all_facades_or_given") {
  PlannedScene scene;
  const auto depths = [&](const std::vector<double>& values) {
    scene.plan.facades.emplace_back();
    std::vector<FacadeOpening> openings;
    for (const double d : values) openings.push_back(opening_at({1, 1}, {2, 2}, d));
    scene.add_wall({0, 0}, {6, 4}, openings);
  };
  depths({kNaN, -0.1});
  CHECK(test::status_of([&] { wall_thicknesses(scene.plan, 0); }) == Status::kInsufficientData);
  CHECK_THROWS_WITH_AS(wall_thicknesses(scene.plan, 0), doctest::Contains("thickness_m"), Error);
  CHECK(wall_thicknesses(scene.plan, 0.4) == std::vector<double>{0.4});
  depths({0.1, kNaN, 0.5, 0.2});
  depths({0.9});
  depths({0.8, 0.7, 0.75});
  // All known: 0.1 0.2 0.5 0.7 0.75 0.8 0.9.
  CHECK(wall_thicknesses(scene.plan, 0) == std::vector<double>{0.7, 0.2, 0.9, 0.75});
  CHECK(wall_thicknesses(scene.plan, 0.4) == std::vector<double>(4, 0.4));
}

TEST_CASE("draw_chords__gives_holes_and_what_fills_them_the_same_points") {
  PlannedScene scene;
  PlannedWall& wall = scene.add_wall({0, 0}, {6, 4}, {opening_at({1, 1}, {2.3, 2.9}, 0.2)});
  FacadeOpening& opening = wall.wall.openings[0];
  opening.outline.edges[2].sagitta_m = 0.37;
  const double true_area = signed_area(opening.outline);
  scene.plan.planes[0].faces[0].openings[0] = reversed(opening.outline);
  wall.wall.outlines[0].edges[2].sagitta_m = 0.8;
  scene.plan.planes[0].faces[0].outline = wall.wall.outlines[0];
  wall.wall.shadows.push_back({reversed(reversed(opening.outline)), 0, false});
  draw_chords(scene.plan, 0.001);
  const VectorFace& face = scene.plan.planes[0].faces[0];
  const VectorRing* const drawn[] = {&face.outline, &face.openings[0], &opening.outline,
                                     &wall.wall.outlines[0], &wall.wall.shadows[0].outline};
  for (const VectorRing* ring : drawn) {
    CHECK(ring->corners.size() > 8);
    CHECK(ring->edges.size() == ring->corners.size());
    for (const VectorEdge& edge : ring->edges) CHECK(edge.sagitta_m == 0);
  }
  // A strip of 1 mm along an arc of less than 2 m.
  CHECK(std::fabs(signed_area(opening.outline) - true_area) < 0.002);
  const auto sorted = [](std::vector<Vec2> corners) {
    std::sort(corners.begin(), corners.end(),
              [](const Vec2& a, const Vec2& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
    return corners;
  };
  CHECK(sorted(face.openings[0].corners) == sorted(opening.outline.corners));
  CHECK(face.outline.corners == wall.wall.outlines[0].corners);
}
