// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "report/pages/change_places.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;

namespace {

// Points every 0.1 m, 50 a row: rows 0 ... 4 changed by 1 m in columns 10 ... 19, by 2 m in columns 30 ... 39.
Comparison changed_comparison() {
  std::vector<double> distances(500, 0.001);
  for (size_t i = 0; i < 250; ++i) {
    if (i % 50 / 10 == 1) distances[i] = 1;
    if (i % 50 / 10 == 3) distances[i] = 2;
  }
  return page_scenes::comparison_of(distances);
}

FieldTable boxes(const std::vector<Box3>& of) {
  FieldTable out;
  for (const bool is_max : {false, true})
    add_columns<double, 3>(out, of, is_max ? "box_max" : "box_min", "m", "",
                           [&](const Box3& box, double* o) {
                             for (int k = 0; k < 3; ++k) o[k] = is_max ? box.max[k] : box.min[k];
                           });
  return out;
}

}  // namespace

TEST_CASE("change_places__changed_points_belong_to_the_smallest_box_that_holds_them") {
  const Comparison forward = changed_comparison();
  const FieldTable changes =
      boxes({{{-1, -1, -1}, {6, 2, 1}}, {{2.8, -0.1, -0.1}, {4.2, 0.6, 0.1}}});
  Task task;
  const auto places = change_places(forward, &forward, changes, 0.5, 10, task);
  REQUIRE(places.size() == 2);
  CHECK(places[0].row == 0);
  CHECK(places[0].after.size() == 50);
  CHECK(places[0].before.size() == 50);
  CHECK(places[1].after.size() == 50);
  for (const Vec3& p : places[1].points(forward, nullptr)) CHECK((p.x > 2.9 && p.x < 4));
  CHECK(places[1].points(forward, &forward).size() == 100);
  CHECK(change_places(forward, nullptr, changes, 0.5, 1, task).size() == 1);
}

TEST_CASE("change_places__without_a_threshold_the_tests_of_the_comparison_tell") {
  Comparison forward = changed_comparison();
  const FieldTable changes = boxes({{{-1, -1, -1}, {6, 2, 1}}});
  Task task;
  CHECK(change_places(forward, nullptr, changes, 0, 10, task).at(0).after.empty());
  std::vector<uint8_t> significant(500, 0);
  significant[7] = significant[8] = 1;
  forward.points.set(make_column<uint8_t>({"significant"}, significant));
  CHECK(change_places(forward, nullptr, changes, 0, 10, task).at(0).after ==
        std::vector<uint64_t>{7, 8});
}

TEST_CASE("change_places__tables_without_boxes_have_none") {
  Task task;
  const Comparison forward = changed_comparison();
  CHECK(change_places(forward, nullptr, {}, 0.5, 10, task).empty());
  const double nan = std::nan("");
  CHECK(change_places(forward, nullptr, boxes({{{nan, 0, 0}, {1, 1, 1}}}), 0.5, 10, task).empty());
}
