// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Panes and reveals of openings: where they stand, which way they look, how large they are.
#include "modelling/facade/opening_faces.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "unit/modelling/model_checks.h"
#include "unit/modelling/planned_scene.h"

using namespace planned;

namespace {

/// A model with the faces that fill one opening of a wall on y = 0.
struct Filled {
  Model model;
  SharedVertices shared;
  PlaneVertices wall{model, shared, street_frame()};

  explicit Filled(const FacadeOpening& opening, bool with_reveals = true) {
    part_ring(wall, opening.outline);  // the hole, as the wall's face has it
    append_part(model, "window", "window", kNoParent, Evidence::kMeasured);
    append_opening_faces(model, wall, opening, 0, {}, with_reveals);
  }
  double area_of(const std::string& part_class) const {
    double sum = 0;
    for (const Face& face : model.faces)
      if (model.parts[face.part].part_class == part_class) sum += face.area_m2;
    return sum;
  }
};

}  // namespace

TEST_CASE("opening_faces__are_a_pane_at_its_depth_and_reveals_that_look_into_the_opening") {
  const Filled filled(opening_at({2, 1}, {3.2, 2.6}, 0.25));
  const Model& model = filled.model;
  REQUIRE(model.faces.size() == 5);
  CHECK(model.vertices.size() == 8);  // those of the hole are used again
  CHECK(filled.area_of("joinery") == doctest::Approx(1.2 * 1.6).epsilon(1e-12));
  CHECK(filled.area_of("reveal") == doctest::Approx(2 * (1.2 + 1.6) * 0.25).epsilon(1e-12));
  const Vec3 middle{2.6, 0.125, 1.8};
  for (const Face& face : model.faces) {
    CHECK(checks::ring_fault(model, face).empty());
    CHECK(checks::flatness(model, face) < 1e-12);
    // The room before the pane lies in front of every one of them.
    CHECK(face.plane.distance(middle) > 0.1);
    const Ring& ring = model.rings[face.first_ring];
    for (uint64_t c = ring.first; c < ring.first + ring.count; ++c)
      CHECK(std::fabs(face.plane.distance(model.vertices[model.corners[c]])) < 1e-12);
  }
  for (size_t part = 1; part < model.parts.size(); ++part) {
    CHECK(model.parts[part].parent == 0);
    CHECK(model.parts[part].depth_m == 0.25);
  }
}

TEST_CASE("opening_faces__follow_a_round_head_within_a_millimetre") {
  FacadeOpening round = opening_at({0, 0}, {1.2, 1.5}, 0.2);
  round.outline.edges[2].sagitta_m = 0.6;  // a semicircle
  const Filled filled(round);
  const double around = 1.2 + 2 * 1.5 + std::numbers::pi * 0.6;
  // Chords 1 mm from a circle of 0.6 m are shorter than their arcs by a share of 1e-3 / 3 / 0.6.
  const double lost = around * 0.2 - filled.area_of("reveal");
  CHECK(lost >= 0);
  CHECK(lost <= std::numbers::pi * 0.6 * 0.2 * (1.05e-3 / 3 / 0.6));
  CHECK(filled.area_of("joinery") ==
        doctest::Approx(1.2 * 1.5 + std::numbers::pi * 0.36 / 2).epsilon(1e-12));
  for (const Vec3& p : filled.model.vertices)
    if (p.z > 1.5)
      CHECK(std::hypot(p.x - 0.6, p.z - 1.5) == doctest::Approx(0.6).epsilon(1e-9).scale(0));
}

TEST_CASE("opening_faces__are_left_out_where_depths_give_none") {
  const auto faces = [](double depth_m, bool with_reveals = true) {
    return Filled(opening_at({0, 0}, {1, 1}, depth_m), with_reveals).model.faces.size();
  };
  CHECK(faces(kNaN) == 0);
  CHECK(faces(0.004) == 1);  // flush: the pane alone
  CHECK(faces(-0.1) == 1);   // before the wall
  CHECK(faces(0.006) == 5);
  CHECK(faces(0.2, false) == 1);
  const Filled before(opening_at({0, 0}, {1, 1}, -0.1));
  CHECK(before.model.faces[0].plane.distance({0.5, -0.1, 0.5}) == doctest::Approx(0));
  FacadeOpening copy = opening_at({0, 0}, {1, 1}, 0.2);
  copy.copied_from = 3;
  CHECK(Filled(copy).model.parts.back().evidence == Evidence::kCopied);
}

TEST_CASE("append_sides__turn_over_with_the_side_asked_for") {
  for (const bool right : {false, true}) {
    Model model;
    SharedVertices shared;
    PlaneVertices wall(model, shared, street_frame());
    append_part(model, "wall", "wall", kNoParent, Evidence::kMeasured);
    append_sides(model, wall, rectangle({0, 0}, {2, 1}), 0, -0.5, right, 0);
    REQUIRE(model.faces.size() == 4);
    for (const Face& face : model.faces) {
      CHECK((face.plane.distance({1, 0.25, 0.5}) < 0) == right);
      CHECK(checks::ring_fault(model, face).empty());
      CHECK(face.area_m2 > 0.4);
    }
  }
}
