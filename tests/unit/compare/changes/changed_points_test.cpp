// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Which points count as changed: each criterion against a handful of points with a known answer.
#include "compare/changes/changed_points.h"

#include <doctest/doctest.h>

#include "base/numbers.h"
#include "unit/compare/changes/epochs.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Criterion = RegionSettings::Criterion;
using Bytes = std::vector<uint8_t>;

Comparison with_distances(const std::vector<double>& distances) {
  return told(std::vector<Vec3>(distances.size()), distances);
}

Bytes changed_in(const Comparison& comparison, Criterion criterion, const char* field = "changed") {
  RegionSettings settings;
  settings.threshold_m = 0.25;
  settings.criterion = criterion;
  settings.field = field;
  Task task;
  return changed_points(comparison, settings, task);
}

}  // namespace

TEST_CASE("changed_points__are_beyond_the_threshold_on_either_side_and_have_a_distance") {
  const Comparison made = with_distances({0, 0.25, -0.25, 0.2500001, -0.2500001, kNaN, -7});
  const Bytes expected = {0, 0, 0, 1, 1, 0, 1};
  CHECK(changed_in(made, Criterion::kAutomatic) == expected);
  CHECK(changed_in(made, Criterion::kThreshold) == expected);
}

TEST_CASE("changed_points__have_to_go_beyond_a_share_of_the_spacing_where_it_is_known") {
  Comparison made = with_distances({0.45, 0.65, 0.45, -0.45, 0.2});
  // Share 0.5 of 0.5 m: beyond 0.5 m; where the spacing is not known or 0, beyond 0.25 m.
  set_column<float>(made.points, "reference_spacing", {0.5F, 0.5F, kFloatNaN, 0, 0});
  RegionSettings settings;
  settings.threshold_m = 0.25;
  settings.spacing_share = 0.5;
  Task task;
  CHECK(changed_points(made, settings, task) == Bytes{0, 1, 1, 1, 0});
  settings.spacing_share = 0;
  CHECK(changed_points(made, settings, task) == Bytes{1, 1, 1, 1, 0});
}

TEST_CASE("changed_points__follow_the_level_of_detection_unless_the_threshold_is_asked_for") {
  Comparison made = with_distances({9, 0.01, 9});
  CHECK(refuses([&] { changed_in(made, Criterion::kSignificance); }, Status::kInvalidArgument,
                "no level of detection"));
  set_column<uint8_t>(made.points, "significant", {0, 1, 1});
  CHECK(changed_in(made, Criterion::kAutomatic) == Bytes{0, 1, 1});
  CHECK(changed_in(made, Criterion::kSignificance) == Bytes{0, 1, 1});
  CHECK(changed_in(made, Criterion::kThreshold) == Bytes{1, 0, 1});
}

TEST_CASE("changed_points__are_those_whose_field_is_a_number_other_than_0") {
  Comparison made = with_distances({9, 9, 9, 9});
  Cloud cloud = *made.cloud;
  set_column<float>(cloud.fields, "mine", {0, -2, kFloatNaN, 0.5F});
  set_column<int32_t>(cloud.fields, "both", {1, 1, 1, 1});
  set_column<double>(cloud.fields, "arrow", {1, 2, 3, 4, 5, 6, 7, 8}, 2);
  made.cloud = std::make_shared<const Cloud>(cloud);
  set_column<uint8_t>(made.points, "both", {0, 0, 1, 0});
  CHECK(changed_in(made, Criterion::kField, "mine") == Bytes{0, 1, 0, 1});
  CHECK(changed_in(made, Criterion::kField, "both") == Bytes{0, 0, 1, 0});  // the comparison's
  CHECK(refuses([&] { changed_in(made, Criterion::kField, "arrow"); }, Status::kInvalidArgument,
                "\"arrow\" has 2 components"));
  CHECK(refuses([&] { changed_in(made, Criterion::kField, "none such"); }, Status::kNotFound,
                "none such"));
}
