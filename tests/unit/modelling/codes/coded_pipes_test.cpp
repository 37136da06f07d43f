// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/coded_pipes.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/modelling/model_checks.h"

using namespace jalon;

namespace {

Model pipe(const std::vector<Vec3>& axis, double radius_m, double chord_m = 0.001) {
  SharedFaces faces({734500, 642100, 0});
  add_coded_pipe(faces, faces.part("gutter", "gutter", kNoParent), 9, axis, radius_m, chord_m);
  Model model = faces.take({});
  validate(model);
  return model;
}

}  // namespace

TEST_CASE("coded_pipes__an_upright_gutter_is_a_closed_prism_within_the_chord") {
  const Model model = pipe({{1, 2, 0}, {1, 2, 2.8}}, 0.04);
  REQUIRE(model.solids.size() == 1);
  CHECK(checks::solid_fault(model, model.solids[0]) == "");
  double volume = 0;
  for (const Face& face : model.faces)
    volume +=
        face.area_m2 *
        dot(face.plane.normal, model.vertices[model.corners[model.rings[face.first_ring].first]] -
                                   Vec3{734501, 642102, 0}) /
        3;
  const double round = std::acos(-1.0) * 0.04 * 0.04 * 2.8;
  CHECK(volume < round);
  CHECK(volume > 0.95 * round);
  for (const Vec3& p : model.vertices)
    CHECK(std::hypot(p.x - 734501, p.y - 642102) == doctest::Approx(0.04).epsilon(1e-6).scale(0));
}

TEST_CASE("coded_pipes__bends_are_mitred_and_stay_closed") {
  const Model model = pipe({{0, 0, 0}, {0, 0, 2}, {0.3, 0, 2.3}, {0.3, 0.5, 2.3}}, 0.04);
  REQUIRE(model.solids.size() == 1);
  CHECK(checks::solid_fault(model, model.solids[0]) == "");
  for (const Face& face : model.faces) CHECK(checks::flatness(model, face) < 1e-8);
}

TEST_CASE("coded_pipes__an_axis_that_turns_back_ends_there") {
  const Model back = pipe({{0, 0, 0}, {0, 0, 2}, {0, 0, 1}}, 0.04);
  CHECK(checks::solid_fault(back, back.solids.at(0)) == "");
  double top = 0;
  for (const Vec3& p : back.vertices) top = std::max(top, p.z);
  CHECK(top == doctest::Approx(2));
  CHECK(pipe({{0, 0, 0}, {0, 0, 0}}, 0.04).faces.empty());
  CHECK(pipe({{0, 0, 0}, {0, 0, 1}}, 0).faces.empty());
}
