// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "scan/scanner.h"
#include "unit/scan/fixture.h"
#include "unit/scan/plates.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// 2 m2 and 6 m2 one above the other, and 0.01 m2 apart.
Model plates() {
  Model model;
  model.parts = {{"all", "wall"}};
  add_plate(model, 0, 2, 0, 1, 0);
  add_plate(model, 0, 2, 0, 3, 5);
  add_plate(model, 7, 7.1, 0, 0.1, 2);
  return model;
}

FieldTable planes_of(const Model& model, const Cloud* cloud, double least_m2,
                     std::vector<double> offset_m = {0, 0, 0}) {
  Task task;
  return true_planes(model, cloud, least_m2, offset_m, task);
}

Cloud labelled(const std::vector<uint32_t>& labels) {
  Cloud cloud = make_cloud(Buffer<double>(3 * labels.size()));
  cloud.fields.set(
      make_column<uint32_t>({"segment", ElementType::kUint32, 1, "", ""}, std::span(labels)));
  return cloud;
}

}  // namespace

TEST_CASE("true_planes__have_a_row_each_from_the_least_area_on") {
  const FieldTable table = planes_of(plates(), nullptr, 0.05);
  const auto area = table.require("area").values<double>();
  REQUIRE(area.size() == 2);
  CHECK(area[0] == doctest::Approx(2));
  CHECK(area[1] == doctest::Approx(6));
  CHECK(table.require("segment").values<uint32_t>()[1] == 2);
  CHECK(planes_of(plates(), nullptr, 0.005).require("area").count() == 3);
  CHECK(planes_of(plates(), nullptr, 100).require("area").count() == 0);
}

TEST_CASE("true_planes__are_shifted_with_the_points") {
  const FieldTable here = planes_of(plates(), nullptr, 0.05),
                   there = planes_of(plates(), nullptr, 0.05, {1000, 2000, 300});
  for (size_t i = 0; i < 2; ++i) {
    const double side = here.require("normal").values<double>()[3 * i + 2];
    CHECK(std::abs(side) == doctest::Approx(1));
    CHECK(there.require("offset").values<double>()[i] -
              here.require("offset").values<double>()[i] ==
          doctest::Approx(300 * side));
  }
}

TEST_CASE("true_planes__count_the_points_of_a_cloud") {
  const Cloud cloud = labelled({2, 0, 2, 1, 2, 0, 9});
  const FieldTable table = planes_of(plates(), &cloud, 0.05);
  CHECK(table.require("count").values<uint64_t>()[0] == 1);
  CHECK(table.require("count").values<uint64_t>()[1] == 3);
}

TEST_CASE("true_planes__refuse_a_cloud_without_labels_and_a_short_offset") {
  const Cloud bare = make_cloud(Buffer<double>(3));
  CHECK_THROWS_AS(planes_of(plates(), &bare, 0.05), Error);
  Cloud odd = make_cloud(Buffer<double>(3));
  const std::vector<float> numbers{1};
  odd.fields.set(
      make_column<float>({"segment", ElementType::kFloat32, 1, "", ""}, std::span(numbers)));
  CHECK_THROWS_AS(planes_of(plates(), &odd, 0.05), Error);
  CHECK_THROWS_AS(planes_of(plates(), nullptr, 0.05, {1, 2}), Error);
}
