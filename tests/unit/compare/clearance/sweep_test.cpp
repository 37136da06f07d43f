// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The tables of a ball that is driven past points and a wall, against closed forms.
#include <doctest/doctest.h>

#include "compare/clearance/clearance.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kBall_m = 0.5;
constexpr double kSwept_m = 1e-6;  // what sweep_gauge promises

Transform at(double x) {
  Transform pose;
  pose.m[3] = x;
  return pose;
}

/// A square of 2 m in the plane x = 11, and as part 1 a floor far below.
Model wall_ahead() {
  Model model;
  model.parts = {Part{"floor", "w"}, Part{"wall", "w"}};
  Face face;
  face.part = 0;
  face.plane = {{0, 0, 1}, -50};
  model.add_face(face, {{{0, 0, -50}, {1, 0, -50}, {1, 1, -50}, {0, 1, -50}}});
  face.part = 1;
  face.plane = {{-1, 0, 0}, -11};
  model.add_face(face, {{{11, -1, -1}, {11, -1, 1}, {11, 1, 1}, {11, 1, -1}}});
  return model;
}

struct Drive {
  std::vector<Transform> poses = {at(0), at(4), at(10)};
  ClearanceSettings settings{};

  SweepTables past(const Cloud* cloud, const Model* model) const {
    const ConvexPiece ball = ConvexPiece::sphere({0, 0, 0}, kBall_m);
    Task task;
    return sweep_tables({&ball, 1}, poses, cloud, model, settings, task);
  }
};

double sweep_number(const FieldTable& table, const char* name, size_t row, uint32_t component = 0) {
  return table.require(name).number(row, component);
}

}  // namespace

TEST_CASE("sweep_tables__order_the_places_along_the_way_with_parameter_clearance_and_foot") {
  // Beside x = 7, half a way of 6 m; inside at x = 1, a quarter of 4 m; not within 0.3 m; inside at x = 8.5.
  const Cloud cloud = cloud_of({{7, 0.75, 0}, {1, 0, 0.25}, {5, 0, 0.875}, {8.5, -0.375, 0}});
  Drive drive;
  drive.settings.margin_m = 0.3;
  const SweepTables found = drive.past(&cloud, nullptr);
  const FieldTable& places = found.places;
  REQUIRE(places.require("point").count() == 3);
  const double points[] = {1, 0, 3}, parameters[] = {0.25, 1.5, 1.75},
               clearances[] = {-0.25, 0.25, -0.125};
  for (size_t row = 0; row < 3; ++row) {
    CHECK(sweep_number(places, "point", row) == points[row]);
    CHECK(sweep_number(places, "kind", row) == 1);
    CHECK(sweep_number(places, "clearance", row) ==
          doctest::Approx(clearances[row]).epsilon(kSwept_m));
    // Clearance grows by the square of the way beside it: that of 1e-6 m is seen from 1 mm on.
    CHECK(sweep_number(places, "parameter", row) ==
          doctest::Approx(parameters[row]).epsilon(0.001));
    CHECK(sweep_number(places, "face", row) == static_cast<double>(kNoRow));
  }
  CHECK(sweep_number(places, "xyz", 1, 1) == 0.75);
  CHECK(sweep_number(places, "gauge_xyz", 1, 1) == doctest::Approx(kBall_m).epsilon(kSwept_m));
  CHECK(sweep_number(found.intervals, "near", 0) == 1);
  CHECK(sweep_number(found.intervals, "near", 1) == 2);
  CHECK(sweep_number(found.intervals, "point", 1) == 3);
  CHECK(sweep_number(found.intervals, "interval", 1) == 1);
}

TEST_CASE("sweep_tables__name_faces_of_a_model_beside_points_of_a_cloud") {
  const Cloud cloud = cloud_of({{2, 1.25, 0}});
  const Model model = wall_ahead();
  Drive drive;
  drive.settings.margin_m = 0.625;
  const SweepTables found = drive.past(&cloud, &model);
  const FieldTable& intervals = found.intervals;
  CHECK(sweep_number(intervals, "kind", 0) == 1);
  CHECK(sweep_number(intervals, "clearance", 0) == doctest::Approx(0.75).epsilon(kSwept_m));
  CHECK(sweep_number(intervals, "part", 0) == static_cast<double>(kNoRow));
  CHECK(sweep_number(intervals, "kind", 1) == 2);
  CHECK(sweep_number(intervals, "clearance", 1) == doctest::Approx(0.5).epsilon(kSwept_m));
  CHECK(sweep_number(intervals, "parameter", 1) == doctest::Approx(2).epsilon(kSwept_m));
  CHECK(sweep_number(intervals, "part", 1) == 1);
  CHECK(sweep_number(intervals, "face", 1) == 1);
  CHECK(sweep_number(intervals, "triangle", 1) == static_cast<double>(kNoRow));
  CHECK(sweep_number(intervals, "point", 1) == static_cast<double>(kNoRow));
  for (size_t row = 0; row < found.places.require("kind").count(); ++row)
    CHECK(sweep_number(found.places, "kind", row) == 2);  // the point is 0.75 m off
}

TEST_CASE("sweep_tables__say_nothing_where_nothing_is_within_reach") {
  const Cloud cloud = cloud_of({{2, 0, 1.75}});
  Drive drive;  // reach 1 m: 1.25 m is beyond it
  const SweepTables found = drive.past(&cloud, nullptr);
  CHECK(found.places.require("kind").count() == 0);
  REQUIRE(found.intervals.require("kind").count() == 2);
  for (size_t row = 0; row < 2; ++row) {
    CHECK(sweep_number(found.intervals, "kind", row) == 0);
    CHECK(sweep_number(found.intervals, "interval", row) == static_cast<double>(row));
    CHECK(sweep_number(found.intervals, "piece", row) == static_cast<double>(~uint32_t{0}));
    for (const char* name : {"clearance", "parameter", "xyz", "gauge_xyz"})
      CHECK(std::isnan(sweep_number(found.intervals, name, row)));
  }
  drive.settings.reach_m = 1.5;
  const SweepTables further = drive.past(&cloud, nullptr);
  CHECK(sweep_number(further.intervals, "clearance", 0) == doctest::Approx(1.25).epsilon(kSwept_m));
  const Cloud empty = cloud_of({});
  CHECK(sweep_number(drive.past(&empty, nullptr).intervals, "kind", 0) == 0);
}

TEST_CASE("sweep_tables__refuse_a_pose_that_is_not_rigid_and_two_reference_systems") {
  Drive drive;
  drive.poses[1].m[0] = 1.01;
  Cloud cloud = cloud_of({{0, 0, 0}});
  CHECK(refuses([&] { drive.past(&cloud, nullptr); }, Status::kInvalidArgument, "pose 1"));
  drive.poses[1].m[0] = 1;
  Model model = wall_ahead();
  model.crs = "EPSG:2154";
  CHECK_NOTHROW(drive.past(&cloud, &model));
  cloud.crs = "EPSG:25832";
  CHECK(refuses([&] { drive.past(&cloud, &model); }, Status::kInvalidArgument,
                "EPSG:25832 and EPSG:2154"));
  const Model nothing;
  CHECK(refuses([&] { drive.past(&cloud, &nothing); }, Status::kInsufficientData, "no surface"));
}
