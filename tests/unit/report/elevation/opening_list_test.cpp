// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Openings of walls made by hand, listed and typed, against the rectangles that they were made of.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "report/elevation/opening_list.h"
#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

struct MadeHole {
  double width, height;
  const char* part_class;  ///< nullptr: nothing fills it
  double sagitta = 0;      ///< of its head
};

// A wall of the plane y = 0, its holes in a row.
Model wall_with(const std::vector<MadeHole>& holes) {
  Model m;
  m.parts = {named_facade::part("wall", part_class::kWall, kNoParent)};
  std::vector<std::vector<Vec3>> rings{
      named_facade::lifted({{0, 0}, {100, 0}, {100, 9}, {0, 9}}, 0)};
  std::vector<double> sagittas(4, 0);
  double u = 1;
  for (const MadeHole& hole : holes) {
    rings.push_back(named_facade::lifted(named_facade::hole(u, 1, hole.width, hole.height), 0));
    sagittas.insert(sagittas.end(), {0, -hole.sagitta, 0, 0});
    u += hole.width + 1;
  }
  named_facade::add(m, 0, {{0, -1, 0}, 0}, rings, sagittas, 900, 1);
  for (size_t i = 0; i < holes.size(); ++i) {
    if (holes[i].part_class == nullptr) continue;
    m.rings[i + 1].part = static_cast<uint32_t>(m.parts.size());
    m.parts.push_back(named_facade::part("", holes[i].part_class, 0));
  }
  return m;
}

}  // namespace

TEST_CASE("opening_list__types_run_by_class_then_number_then_size") {
  const OpeningList list = list_openings(wall_with({{1, 2.2, "door"},
                                                    {0.6, 0.8, "window"},
                                                    {1.2, 1.5, "window"},
                                                    {1.22, 1.48, "window"},
                                                    {1.2, 1.5, "opening"},
                                                    {2, 2, "window"},
                                                    {1.2, 1.2, "window", 0.3}}),
                                         0.05);
  REQUIRE(list.rows.size() == 7);
  // The twins first, then the others by falling size: 2 x 2, the arch as large as a twin, the small one.
  const std::vector<std::string> tags{"W1", "W2", "W3", "W4", "D1", "O1"};
  const double areas[] = {1.21 * 1.49, 4, 1.8, 0.48, 2.2, 1.8};
  REQUIRE(list.types.size() == tags.size());
  for (size_t i = 0; i < tags.size(); ++i) {
    CHECK(list.types[i].tag == tags[i]);
    // Areas to the chords' error of the arch.
    CHECK(list.types[i].width_m * list.types[i].height_m ==
          doctest::Approx(areas[i]).epsilon(1e-3).scale(0));
  }
  CHECK(list.types[0].count == 2);
  CHECK(list.types[2].arched);
  CHECK(list.rows[2].type == 0);
  CHECK(list.rows[3].type == 0);
  CHECK(list.rows[6].type == 2);
  CHECK(list.rows[0].name == "part 1");
}

TEST_CASE("opening_list__every_row_is_of_its_own_class_and_all_are_counted") {
  RandomStream random(2, 0);
  const char* classes[] = {"window", "door", "opening"};
  for (int trial = 0; trial < 20; ++trial) {
    CAPTURE(trial);
    std::vector<MadeHole> holes;
    for (uint64_t n = 1 + random.below(20); n > 0; --n)
      holes.push_back(
          {1 + 0.2 * random.uniform(), 1 + 0.2 * random.uniform(), classes[random.below(3)]});
    const OpeningList list = list_openings(wall_with(holes), 0.02);
    std::vector<OpeningType> sums(list.types.size());
    for (size_t i = 0; i < list.rows.size(); ++i) {
      const OpeningRow& row = list.rows[i];
      CHECK(row.width_m == doctest::Approx(holes[i].width));
      CHECK(row.height_m == doctest::Approx(holes[i].height));
      REQUIRE(row.type < sums.size());
      CHECK(list.types[row.type].part_class == row.part_class);
      ++sums[row.type].count;
      sums[row.type].width_m += row.width_m;
      sums[row.type].height_m += row.height_m;
    }
    for (size_t i = 0; i < sums.size(); ++i) {
      const OpeningType& type = list.types[i];
      const auto n = static_cast<double>(sums[i].count);
      CHECK(type.count == sums[i].count);
      CHECK(type.width_m == doctest::Approx(sums[i].width_m / n));
      CHECK(type.height_m == doctest::Approx(sums[i].height_m / n));
      if (i > 0 && list.types[i - 1].part_class == type.part_class)
        CHECK(list.types[i - 1].count >= type.count);
    }
  }
}

TEST_CASE("opening_list__without_names_holes_of_steep_faces_count_from_three_decimetres_on") {
  const std::vector<MadeHole> holes{
      {0.29, 2, nullptr}, {0.31, 0.31, nullptr}, {2, 0.29, nullptr}, {1, 2, nullptr}};
  Model m = wall_with(holes);
  const OpeningList list = list_openings(m, 0.05);
  REQUIRE(list.rows.size() == 2);
  CHECK(list.rows[0].name == "hole 1");
  CHECK(list.rows[1].name == "hole 2");
  CHECK(list.rows[1].width_m == doctest::Approx(1));
  CHECK(list.rows[1].part == kNoPart);
  CHECK(list.types[0].tag == "O1");
  CHECK(list.types[0].width_m == doctest::Approx(1));  // the larger of two single ones
  // The same holes in a floor are none to look through.
  for (Vec3& p : m.vertices) p = {p.x, p.z, 0};
  m.faces[0].plane = {{0, 0, 1}, 0};
  CHECK(list_openings(m, 0.05).rows.empty());
  // One name, and the others are holes that nothing is known of.
  m = wall_with({{1, 2, nullptr}, {1, 1, "window"}});
  CHECK(list_openings(m, 0.05).rows.size() == 1);
  CHECK(list_openings({}, 0.05).rows.empty());
}

TEST_CASE("opening_list__a_door_in_a_notch_has_the_contour_of_its_leaf_and_the_wall_around_it") {
  named_facade::Setting s;
  s.rows = s.columns = 2;
  Model m = named_facade::make(s);
  const OpeningList list = list_openings(m, 0.05);
  REQUIRE(list.rows.size() == 4);
  const OpeningRow& door = list.rows.back();
  REQUIRE(door.part_class == "door");
  CHECK(door.wall == 0);
  REQUIRE(door.contour.size() == 1);
  CHECK(m.faces[door.contour[0].face].id == 11);
  CHECK(door.width_m == doctest::Approx(1));
  CHECK(door.height_m == doctest::Approx(2.3));
  for (const OpeningRow& row : list.rows) {
    REQUIRE(row.joinery.size() == 1);  // without the reveals
    CHECK(m.parts[m.faces[row.joinery[0]].part].part_class != std::string("reveal"));
  }
  // What the modeller tells of an opening's size counts before its contour.
  m.parts[door.part].width_m = 0.9;
  CHECK(list_openings(m, 0.05).rows.back().width_m == 0.9);
  CHECK(list_openings(m, 0.05).rows.back().height_m == doctest::Approx(2.3));
}
