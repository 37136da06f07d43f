// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Sections against rectangles and notches of known places.
#include "formats/geopackage/plan.h"

#include <doctest/doctest.h>

#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::gpkg;
using namespace jalon::test;

namespace {

// A wall of 10 x 5 m along x on a national grid, a door as a notch at 1 to 2 m, a window of part 7 at 4 to 6, 1 to 3 m.
Model notched() {
  const auto at = [](double x, double z) { return Vec3{652000 + x, 6861000, 100 + z}; };
  Model model;
  Face face;
  face.plane.normal = {0, -1, 0};
  model.add_face(
      face, {{at(0, 0), at(1, 0), at(1, 2), at(2, 2), at(2, 0), at(10, 0), at(10, 5), at(0, 5)},
             {at(4, 1), at(4, 3), at(6, 3), at(6, 1)}});
  model.rings[1].part = 7;
  return model;
}

std::vector<std::array<double, 2>> spans(const std::vector<SectionLine>& lines, bool openings) {
  std::vector<std::array<double, 2>> out;
  for (const SectionLine& line : lines)
    if (line.is_opening == openings) out.push_back({line.from.x - 652000, line.to.x - 652000});
  return out;
}

using Spans = std::vector<std::array<double, 2>>;

}  // namespace

TEST_CASE("gpkg_plan__walls_have_gaps_at_notches_and_holes_and_holes_are_lines_of_their_part") {
  const Model model = notched();
  const double level_m = section_level_m(model, {0}, 1.5);
  CHECK(level_m == 101.5);
  const auto lines = section_of(model, {0}, level_m);
  CHECK(spans(lines, false) == Spans{{0, 1}, {2, 4}, {6, 10}});
  CHECK(spans(lines, true) == Spans{{4, 6}});
  for (const SectionLine& line : lines) {
    CHECK(line.from.z == 101.5);
    CHECK(line.from.y == 6861000);
    CHECK(line.part == (line.is_opening ? 7u : model.faces[0].part));
  }
}

TEST_CASE("gpkg_plan__a_level_through_corners_counts_each_once") {
  const Model model = notched();
  CHECK(spans(section_of(model, {0}, 101), false) == Spans{{0, 1}, {2, 10}});  // the sill: below it
  CHECK(spans(section_of(model, {0}, 103), false) == Spans{{0, 4}, {6, 10}});  // the lintel: in it
  CHECK(section_of(model, {0}, 105.001).empty());
  CHECK(section_of(model, {0}, 99.999).empty());
}

TEST_CASE("gpkg_plan__ground_and_roofs_are_not_cut") {
  Model model;
  Face ground;
  ground.plane.normal = {0, 0, 1};
  model.add_face(ground, {{{0, 0, 0}, {9, 0, 0}, {9, 9, 0.2}, {0, 9, 0.2}}});
  CHECK(std::isnan(section_level_m(model, {0}, 1)));
  CHECK(section_of(model, {0}, 0.1).empty());
}
