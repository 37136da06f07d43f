// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The tables of a diagnosis, against one of four points an epoch made by hand.
#include <doctest/doctest.h>

#include "base/numbers.h"
#include "compare/changes/diagnosis.h"
#include "unit/compare/changes/epochs.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Far from the origin: one ulp of a northing of 6861000 m is 0.93e-9 m.
constexpr double kUlp_m = 1e-9;

ChangeRegion region_of(uint32_t label, double area_m2, double volume_m3,
                       std::vector<uint32_t> indices) {
  ChangeRegion region;
  region.label = label;
  region.area_m2 = area_m2;
  region.volume_m3 = volume_m3;
  region.indices = std::move(indices);
  return region;
}

/// An object of points 0 and 1 that moved, and another of point 3 that appeared as two regions.
struct HandMade {
  Comparison was, is;
  Diagnosis diagnosis;

  HandMade() {
    was = told(shifted({{0, 0, 0}, {2, 0, 0}, {4, 4, 4}, {5, 5, 5}}, kFar), {1, 0, 0, 0});
    is = told(shifted({{0, 1, 0}, {2, 1, 0}, {4, 4, 4}, {-3, 6, 5}}, kFar), {1, 0, 0, 2});
    Epoch &before = diagnosis.before, &after = diagnosis.after;
    before.comparison = &was;
    after.comparison = &is;
    before.origin = after.origin = kFar;
    before.regions.changed = {1, 0, 0, 0};
    before.regions.labels = {1, 0, 0, 0};
    before.regions.regions = {region_of(1, 0.5, 0.25, {0})};
    after.regions.changed = {1, 0, 0, 1};
    after.regions.labels = {2, 0, 0, 1};
    after.regions.regions = {region_of(1, 3, 0.75, {3}), region_of(2, 0.5, 0.125, {0})};
    Change moved, came;
    moved.change_class = ChangeClass::kDisplacementOverlap;
    moved.confidence = 0.875;
    moved.object = {{0, 1}, {0, 1}, {1}, {2}, {}};
    moved.match.found = true;
    moved.match.displacement = {0, 1, 0};
    moved.match.rotation = {0, 0, 0.5};
    for (size_t k = 0; k < 36; ++k) moved.match.covariance[k] = static_cast<double>(k);
    came.change_class = ChangeClass::kAppearance;
    came.object = {{}, {3}, {}, {1, 2}, {}};
    diagnosis.changes = {moved, came};
  }
  HandMade(const HandMade&) = delete;
  HandMade& operator=(const HandMade&) = delete;
};

Vec3 vector_in(const FieldTable& table, const char* name, size_t row) {
  const Column& column = table.require(name);
  return {column.number(row, 0), column.number(row, 1), column.number(row, 2)};
}

}  // namespace

TEST_CASE("changes_table__has_number_class_sums_and_boxes_of_each_change_on_a_national_grid") {
  const HandMade made;
  const FieldTable table = changes_table(made.diagnosis);
  const auto number = [&](const char* name, size_t row) { return table.require(name).number(row); };
  CHECK(number("change", 0) == 1);
  CHECK(number("change", 1) == 2);
  CHECK(number("class", 0) == 4);
  CHECK(number("class", 1) == 1);
  CHECK(number("confidence", 0) == 0.875);
  CHECK(number("points_before", 0) == 2);
  CHECK(number("points_before", 1) == 0);
  CHECK(number("points_after", 1) == 1);
  CHECK(number("area_before", 0) == 0.5);
  CHECK(number("area_before", 1) == 0);
  CHECK(number("area_after", 1) == 3.5);
  CHECK(number("volume_after", 1) == 0.875);
  CHECK(number("volume_before", 0) == 0.25);
  CHECK(norm(vector_in(table, "centroid_before", 0) - (kFar + Vec3{1, 0, 0})) < kUlp_m);
  CHECK(norm(vector_in(table, "centroid_after", 0) - (kFar + Vec3{1, 1, 0})) < kUlp_m);
  CHECK(vector_in(table, "box_min", 0) == kFar);
  CHECK(vector_in(table, "box_max", 0) == kFar + Vec3{2, 1, 0});
  CHECK(vector_in(table, "box_min", 1) == kFar + Vec3{-3, 6, 5});
}

TEST_CASE("changes_table__tells_motions_of_displacements_only_and_no_centroid_of_nothing") {
  HandMade made;
  const auto nan_row = [](const FieldTable& table, const char* name, size_t row) {
    const Column& column = table.require(name);
    for (uint32_t k = 0; k < column.info().components; ++k)
      if (!std::isnan(column.number(row, k))) return false;
    return true;
  };
  const FieldTable table = changes_table(made.diagnosis);
  CHECK(vector_in(table, "displacement", 0) == Vec3{0, 1, 0});
  CHECK(vector_in(table, "rotation", 0) == Vec3{0, 0, 0.5});
  for (uint32_t k = 0; k < 36; ++k) CHECK(table.require("covariance").number(0, k) == k);
  for (const char* name : {"displacement", "rotation", "covariance", "centroid_before"})
    CHECK(nan_row(table, name, 1));
  made.diagnosis.changes[0].change_class = ChangeClass::kDeformationOverlap;
  const FieldTable bent = changes_table(made.diagnosis);
  for (const char* name : {"displacement", "rotation", "covariance"}) CHECK(nan_row(bent, name, 0));
  made.diagnosis.changes.clear();
  CHECK(changes_table(made.diagnosis).require("change").count() == 0);
}

TEST_CASE("diagnosis_points_table__names_the_change_of_unchanged_parts_too") {
  const HandMade made;
  struct {
    bool is_after;
    uint32_t change[4], region[4];
  } const rows[] = {{false, {1, 1, 0, 0}, {1, 0, 0, 0}}, {true, {1, 1, 0, 2}, {2, 0, 0, 1}}};
  for (const auto& row : rows) {
    const FieldTable table = diagnosis_points_table(made.diagnosis, row.is_after);
    for (size_t i = 0; i < 4; ++i) {
      CHECK(table.require("change").number(i) == row.change[i]);
      CHECK(table.require("region").number(i) == row.region[i]);
      CHECK(table.require("changed").number(i) == (row.region[i] > 0 ? 1 : 0));
    }
  }
}
