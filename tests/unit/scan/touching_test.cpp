// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/touching.h"

#include <doctest/doctest.h>

#include "scan/shared_edges.h"
#include "unit/scan/plates.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<uint32_t> roots(const Model& model, unsigned threads = 1) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  const FlatTriangles flats(model, task);
  UnionFind groups(flats.size());
  const std::vector<uint8_t> inner = join_by_edges(flats, groups, task);
  join_touching(flats, inner, groups, task);
  std::vector<uint32_t> out;
  for (uint32_t t = 0; t < flats.size(); ++t) out.push_back(groups.find(t));
  return out;
}

bool are_joined(double x0, double x1, double y0, double y1, double height = 0) {
  Model model;
  add_plate(model, 0, 4, 0, 3);
  add_plate(model, x0, x1, y0, y1, height);
  return roots(model)[2] == 0;
}

}  // namespace

TEST_CASE("touching__joins_plates_that_come_within_a_tenth_of_a_millimetre") {
  CHECK(are_joined(4 + 0.9e-4, 6, 1, 2));        // a narrow joint beside
  CHECK_FALSE(are_joined(4 + 1.2e-4, 6, 1, 2));  // a wider one
  CHECK(are_joined(4, 6, 3, 5));                 // a corner
  CHECK(are_joined(3, 5, 2, 5));                 // overlapping borders
  CHECK(are_joined(1, 2, 1, 2));                 // inside
  CHECK(are_joined(-1, 9, -1, 9));               // around
  CHECK(are_joined(1, 2, 1, 2, 0.9e-4));         // a little above
  CHECK_FALSE(are_joined(1, 2, 1, 2, 1.2e-4));
  CHECK_FALSE(are_joined(7, 8, 0, 3));
}

TEST_CASE("touching__does_not_join_what_lies_in_the_hole_of_a_frame") {
  Model model;
  add_plate(model, 0, 6, 0, 1);
  add_plate(model, 0, 6, 5, 6);
  add_plate(model, 0, 1, 1, 5);
  add_plate(model, 5, 6, 1, 5);
  add_plate(model, 2, 4, 2, 4);
  CHECK(roots(model) == std::vector<uint32_t>{0, 0, 0, 0, 0, 0, 0, 0, 8, 8});
}

TEST_CASE("touching__gives_the_same_groups_on_any_number_of_threads_and_for_none") {
  Model model;
  // Rows of bricks with joints of 0.05 mm in a row and 1 mm between the rows: a group a row.
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 30; ++i) add_plate(model, i, i + 1 - 5e-5, j, j + 0.999);
  const std::vector<uint32_t> one = roots(model, 1);
  for (uint32_t t = 0; t < one.size(); ++t) CHECK(one[t] == t / 60 * 60);
  CHECK(roots(model, 4) == one);
  CHECK(roots(Model{}).empty());
}
