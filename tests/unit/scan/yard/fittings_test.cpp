// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "scan/yard/sheets.h"
#include "unit/scan/yard/yards.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct Fitted {
  Model model;
  std::vector<uint8_t> classes;
};

Fitted fitted(const yard::Opening& opening) {
  yard::Side side;
  side.wall = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  side.length_m = 4;
  side.top_m = 249.7;
  SceneBuilder builder{Transform{}};
  yard::Sheets sheets(builder);
  add_fittings(sheets, side, opening, {1, 1});
  return {builder.take(), sheets.classes()};
}

double area_of(const Fitted& f, const char* part_class, int c) {
  double sum = 0;
  for (const Face& face : f.model.faces)
    if (f.model.parts[face.part].part_class == part_class) {
      CHECK(f.classes[face.id - 1] == c);
      sum += face.area_m2;
    }
  return sum;
}

}  // namespace

TEST_CASE("yard_fittings__a_window_is_a_frame_with_panes_a_sill_and_something_behind") {
  const Fitted f = fitted({false, 1, 1, 3, 247.74, 248.91, 0.17, false, true});
  const double frame = area_of(f, "window", yard::kWindow),
               glass = area_of(f, "glass", yard::kWindow);
  CHECK(glass == doctest::Approx(1.76 * 1.01));
  CHECK(frame > 0.24 * 2 * 1.17);  // about a quarter, and the rebates
  CHECK(area_of(f, "reveal", yard::kWall) > 0.17 * 2 * (2 + 1.17));
  CHECK(area_of(f, "blind", yard::kRest) == doctest::Approx(0.1 * glass).epsilon(0.12).scale(0));
  CHECK(area_of(f, "inside", yard::kRest) == doctest::Approx(0.85 * glass));
  CHECK(front_y(f.model, 1.04, 248) == doctest::Approx(0.17));    // frame
  CHECK(front_y(f.model, 1.5, 248.01) == doctest::Approx(0.19));  // pane
  const double sill = front_y(f.model, 1.5, 247.705);             // half way down
  CHECK(sill == doctest::Approx(0.085).epsilon(0.01).scale(0));
}

TEST_CASE("yard_fittings__two_fifths_of_a_door_are_glass") {
  const Fitted f = fitted({true, 1, 1, 2, 246.82, 248.92, 0.11, false, false});
  CHECK(area_of(f, "glass", yard::kDoor) == doctest::Approx(0.4 * 2.1).epsilon(0.01).scale(0));
  CHECK(area_of(f, "door", yard::kDoor) > 0.6 * 2.1 * 0.99);
  CHECK(front_y(f.model, 1.1, 248) == doctest::Approx(0.11));
}

TEST_CASE("yard_fittings__a_flush_door_has_no_reveals") {
  const Fitted f = fitted({true, 1, 1, 2, 246.82, 248.92, 0, false, false});
  for (const Part& part : f.model.parts) CHECK(part.part_class != "reveal");
  CHECK(front_y(f.model, 1.1, 248) == doctest::Approx(0));
}
