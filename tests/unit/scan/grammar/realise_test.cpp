// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "scan/grammar/realise.h"
#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

namespace {

Model realised(const Plan& plan) {
  SceneBuilder out{Transform{}};
  Dice dice(1, 1);
  realise(plan, dice, out);
  return out.take();
}

}  // namespace

TEST_CASE("realise__makes_a_part_for_each_wall_and_each_opening_of_the_plan") {
  for (const FacadeKind kind : all_kinds()) {
    CAPTURE(static_cast<int>(kind));
    const Plan plan = planned(kind, 2);
    const Model model = realised(plan);
    CHECK_NOTHROW(validate(model));
    CHECK(parts_named(model, "wall").size() == plan.walls.size());
    for (int c = 0; c <= static_cast<int>(OpeningClass::kRecess); ++c) {
      const auto wanted = static_cast<OpeningClass>(c);
      CHECK(parts_named(model, name_of(wanted)).size() == count_of_class(plan, wanted));
    }
    for (const Face& face : model.faces) CHECK(is_sound(model, face));
  }
}

TEST_CASE("realise__walls_have_the_area_that_their_openings_leave") {
  for (const FacadeKind kind : all_kinds()) {
    CAPTURE(static_cast<int>(kind));
    const Plan plan = planned(kind, 4);
    const Model model = realised(plan);
    const std::vector<uint32_t> parts = parts_named(model, "wall");
    for (size_t w = 0; w < plan.walls.size(); ++w) {
      double area_m2 = area_of(plan.walls[w].outline);
      for (const PlannedOpening& o : plan.walls[w].openings)
        area_m2 -= area_of(contour_of(o.shape));
      CHECK(shell_of(model, ids_of(model, "wall", parts[w])).area_m2 ==
            doctest::Approx(area_m2).epsilon(1e-9));
    }
  }
}

TEST_CASE("realise__panels_stand_out_of_the_wall_as_far_as_planned") {
  BareSketch s;
  CHECK(s.sketch.pad(s.wall, "panel", {2, 4, 1, 2}, 0, 0.04));
  s.sketch.drainpipe(s.wall, 8, 6);
  s.sketch.canopy(s.wall, 5, 6, 3, 1);
  const Model model = realised(s.plan);
  CHECK(front_y(model, 3, 1.5) == doctest::Approx(-0.04).scale(0));
  CHECK(front_y(model, 1, 1.5) == doctest::Approx(0));
  CHECK(front_y(model, 8, 3) < -0.1);
  CHECK(front_y(model, 5.5, 2.95) < -0.05);
  CHECK(shell_of(model, ids_of(model, "panel")).area_m2 == doctest::Approx(2 + 6 * 0.04));
}
