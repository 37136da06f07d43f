// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/surface_sample.h"

#include <doctest/doctest.h>

#include "unit/registration/verdict/judged_rooms.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("surface_sample__holds_flat_places_of_the_surface_no_more_than_three_a_cell") {
  Task task;
  const auto scan = judged_scan(furnished(8, 8), 0, 1);
  for (const size_t most : {100, 1000}) {
    const std::vector<Surfel> surfels = sample_surface(scan->surface, most, task);
    CHECK(surfels.size() > most / 10);
    CHECK(surfels.size() <= 3 * most);
    for (const Surfel& s : surfels) {
      CHECK(scan->surface.flat(s.position));
      CHECK(norm(s.place - scan->surface.place(s.position)) == 0);
      CHECK(norm(s.normal) == doctest::Approx(1).epsilon(1e-6));
      CHECK(s.radius_m > 0);
      CHECK(s.sight == -1);
    }
  }
}
