// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What was seen in the holes of walls.
#include <doctest/doctest.h>

#include <algorithm>

#include "modelling/walls/survey.h"
#include "unit/modelling/plane_rings.h"
#include "unit/modelling/walls.h"

using namespace walls;

namespace {

const VectorRing kWindow = rings::rectangle({1, 1}, {2, 2});

std::vector<Vec3> wall_points() {
  std::vector<Vec3> out;
  for (double u = 0.05; u < 4; u += 0.1)
    for (double v = 0.05; v < 3; v += 0.1)
      if (!(u > 1 && u < 2 && v > 1 && v < 2)) out.push_back({u, 0, v});
  return out;
}

/// A patch 1 x height m in the window's place, this far behind the wall (negative: before it).
std::vector<Vec3> seen_patch(double y, double height = 1) {
  std::vector<Vec3> out;
  for (double u = 1.05; u < 2; u += 0.1)
    for (double v = 1.05; v < 1 + height; v += 0.1) out.push_back({u, y, v});
  return out;
}

WallSurvey survey_of(const Segmentation& segmentation, unsigned threads = 1) {
  const VectorPlane wall = rings::wall_of({{rings::rectangle({0, 0}, {4, 3}), {}}}, 0.1);
  std::vector<WallHole> holes(1);
  holes[0].outline = kWindow;
  const SurveyedWall walls[] = {{&wall, holes, 0.002}};
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  auto out = survey_walls(segmentation, walls, {}, task);
  REQUIRE(out.size() == 1);
  REQUIRE(out[0].holes.size() == 1);
  return out[0];
}

Segmentation seen_from(const std::vector<std::vector<Vec3>>& parts, const Vec3& eye) {
  Segmentation out = segmentation_of(parts);
  Cloud cloud = *out.cloud;
  Station station;
  station.has_pose = true;
  station.pose.m = {1, 0, 0, eye.x, 0, 1, 0, eye.y, 0, 0, 1, eye.z};
  station.count = cloud.size();
  cloud.stations = {station};
  out.cloud = std::make_shared<Cloud>(cloud);
  return out;
}

}  // namespace

TEST_CASE("wall_survey__without_stations_points_behind_and_before_tell_what_was_seen") {
  const WallSurvey open = survey_of(segmentation_of({wall_points(), seen_patch(0.2, 0.5)}));
  CHECK(open.holes[0].cells == 100);
  CHECK(open.holes[0].through == 50);
  CHECK(open.holes[0].hidden == 0);
  CHECK(open.map.at({1.55, 1.25}) == WallCell::kThrough);
  CHECK(open.map.at({1.55, 1.75}) == WallCell::kUnknown);
  CHECK(open.map.at({0.55, 0.55}) == WallCell::kSolid);
  CHECK(open.tolerance_m == doctest::Approx(0.03));
  const WallSurvey hidden = survey_of(segmentation_of({wall_points(), seen_patch(-2, 0.5)}));
  CHECK(hidden.holes[0].through == 0);
  CHECK(hidden.holes[0].hidden == 50);
  CHECK(hidden.map.at({1.55, 1.25}) == WallCell::kHidden);
  // Too far behind to be joinery, and on the wall: neither.
  for (const double y : {1.5, 0.01}) {
    const WallSurvey none = survey_of(segmentation_of({wall_points(), seen_patch(y)}));
    CHECK(none.holes[0].through + none.holes[0].hidden == 0);
  }
}

TEST_CASE("wall_survey__from_a_station_rays_through_the_wall_count_however_far_they_go") {
  // The eye is 4 m before the window's middle, the patch 4 m behind: it shows at half its size.
  const Vec3 eye{1.5, -4, 1.5};
  const WallSurvey through = survey_of(seen_from({wall_points(), seen_patch(4)}, eye));
  CHECK(through.holes[0].through >= 16);
  CHECK(through.holes[0].through <= 36);
  CHECK(through.map.at({1.55, 1.55}) == WallCell::kThrough);
  CHECK(through.map.at({1.05, 1.05}) == WallCell::kUnknown);
  // Half way before the wall it hides twice its size; what it leaves free is not told.
  const WallSurvey before = survey_of(seen_from({wall_points(), seen_patch(-2)}, eye));
  CHECK(before.holes[0].hidden >= 20);
  CHECK(before.holes[0].through == 0);
  // Seen from behind nothing is told by rays.
  const WallSurvey behind = survey_of(seen_from({wall_points(), seen_patch(-2)}, {1.5, 4, 1.5}));
  CHECK(behind.holes[0].hidden + behind.holes[0].through == 0);
}

TEST_CASE("wall_survey__takes_the_points_in_and_beside_a_hole_the_same_for_any_threads") {
  const Segmentation s =
      segmentation_of({wall_points(), seen_patch(0.2), seen_patch(-0.2), seen_patch(1.2)});
  const WallSurvey one = survey_of(s), many = survey_of(s, 4);
  size_t own = 0, pane = 0, before = 0;
  for (const HolePoint& p : one.holes[0].points) {
    CHECK(p.u > 0.7f);
    CHECK(p.u < 2.3f);
    own += p.label == 1;
    pane += p.label == 2;
    before += p.label == 3;
    CHECK(p.label != 4);  // beyond 1 m
    if (p.label == 2) CHECK(p.w == doctest::Approx(-0.2));
  }
  CHECK(pane == 100);
  CHECK(before == 100);
  CHECK(own >= 40);  // the border of the window
  REQUIRE(many.holes[0].points.size() == one.holes[0].points.size());
  for (size_t i = 0; i < one.holes[0].points.size(); ++i) {
    CHECK(many.holes[0].points[i].u == one.holes[0].points[i].u);
    CHECK(many.holes[0].points[i].label == one.holes[0].points[i].label);
  }
  CHECK(many.map.cells == one.map.cells);
}
