// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <set>

#include "scan/grammar/realise.h"
#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

namespace {

/// What fills one opening of the wall y = 0.
Model filled(const PlannedOpening& o) {
  SceneBuilder out{Transform{}};
  Dice dice(1, 1);
  const uint32_t wall = out.part("wall", "wall");
  add_filling(out, out.part("opening", "window", wall), {{}, {1, 0, 0}, {0, 0, 1}}, o, dice);
  return out.take();
}

PlannedOpening opening_of(Filling::Kind kind) {
  PlannedOpening o;
  o.shape = Shape::flat({0, 1.2, 0, 2});
  o.depth_m = 0.25;
  o.filling.kind = kind;
  return o;
}

}  // namespace

TEST_CASE("filling__of_a_sash_is_a_frame_at_its_depth_with_glass_and_bars") {
  PlannedOpening o = opening_of(Filling::Kind::kSash);
  o.filling.transoms = 1;
  const Model model = filled(o);
  CHECK(front_y(model, 0.03, 1.2) == doctest::Approx(0.25));  // frame
  CHECK(front_y(model, 0.3, 1.4) == doctest::Approx(0.28));   // glass
  CHECK(front_y(model, 0.6, 1.4) == doctest::Approx(0.25));   // mullion
  CHECK(front_y(model, 0.3, 1.0) == doctest::Approx(0.252));  // transom
  CHECK(ids_of(model, "glass").size() == 1);
  // Jambs, sill and lintel reach from the wall to the frame.
  CHECK(shell_of(model, ids_of(model, "reveal")).area_m2 == doctest::Approx(0.25 * 6.4));
  // Nothing passes but through the glass's edges: a front view is closed.
  for (double x = 0.01; x < 1.2; x += 0.05)
    for (double z = 0.01; z < 2; z += 0.05) CHECK(front_y(model, x, z) <= 0.2801);
}

TEST_CASE("filling__follows_every_form_of_opening") {
  for (const Shape& shape :
       {Shape::arched({0, 1.2, 0, 2}, 0.6), Shape::arched({0, 1.2, 0, 2}, 0.15),
        Shape::pointed({0, 1.2, 0, 2}), Shape::round({0.6, 1}, 0.6),
        Shape::polygon({{0, 0}, {1.2, 0}, {1.2, 2}}), Shape::flat({0, 0.3, 0, 0.3})}) {
    PlannedOpening o = opening_of(Filling::Kind::kSash);
    o.shape = shape;
    o.filling.mullions = o.filling.transoms = 2;
    const Model model = filled(o);
    for (const Face& face : model.faces) CHECK(is_sound(model, face));
    const Outline ring = chords_of(contour_of(shape));
    for (double x = -0.095; x < 1.3; x += 0.05)
      for (double z = -0.095; z < 2.1; z += 0.05)
        CHECK((front_y(model, x, z) < 0.3) == contains(ring, {x, z}));
  }
}

TEST_CASE("filling__of_leaves_blinds_and_slats_is_closed_and_of_passages_open") {
  using K = Filling::Kind;
  for (const K kind : {K::kLeaf, K::kClosed, K::kLouvre}) {
    const Model model = filled(opening_of(kind));
    for (double x = 0.02; x < 1.2; x += 0.06)
      for (double z = 0.02; z < 2; z += 0.06) {
        const double y = front_y(model, x, z);
        CHECK(y <= 0.25 + kRounding_m);
        CHECK(y >= 0.23 - kRounding_m);
      }
    CHECK(ids_of(model, "glass").empty());
  }
  for (const K kind : {K::kNothing, K::kRecess})
    CHECK(std::isinf(front_y(filled(opening_of(kind)), 0.5, 1)));
}

TEST_CASE("filling__has_blinds_before_and_curtains_behind_its_glass") {
  PlannedOpening o = opening_of(Filling::Kind::kSash);
  o.filling.blind_share = 0.5;
  o.filling.curtain_share = 1;
  o.filling.stall_m = 0.4;
  const Model model = filled(o);
  CHECK(front_y(model, 0.3, 1.9) == doctest::Approx(0.2).scale(0));   // blind
  CHECK(front_y(model, 0.3, 0.9) == doctest::Approx(0.28));           // glass below it
  CHECK(front_y(model, 0.3, 0.2) == doctest::Approx(0.23).scale(0));  // panel at the foot
  double curtain_y = 0;
  for (const Face& face : model.faces)
    if (model.parts[face.part].part_class == "curtain") curtain_y = -face.plane.offset;
  CHECK(curtain_y >= 0.33);
  CHECK(curtain_y <= 0.55);
  o.filling.mirrors = true;
  CHECK(ids_of(filled(o), "glass").empty());
  CHECK(ids_of(filled(o), "dark").size() == 1);
}
