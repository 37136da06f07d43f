// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/names/no_data.h"

#include <doctest/doctest.h>

using namespace jalon;

TEST_CASE("no_data__has_its_share_of_the_walls_with_it") {
  Model model;
  model.parts = {{"wall", "wall", kNoParent},
                 {"no data 1", "no_data", 0},
                 {"no data 2", "no_data", 0},
                 {"ground", "ground", kNoParent}};
  for (const auto& [part, area_m2] : {std::pair{0u, 54.0}, {0u, 30.0}, {1u, 16.0}, {3u, 200.0}}) {
    Face face;
    face.part = part;
    face.area_m2 = area_m2;
    model.faces.push_back(face);
  }
  const NoData told = no_data_of(model);
  CHECK(told.count == 2);  // one is filled and has no face
  CHECK(told.area_m2 == 16);
  CHECK(told.wall_area_m2 == 84);
  CHECK(told.share() == 0.16);
  CHECK(no_data_of(Model{}).share() == 0);
}
