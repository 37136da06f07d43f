// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Segments picked by hand on hand-labelled facades: what an operator gets from one pick.
#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "segment/picks/picks.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr int kWall = 1;

struct Facade {
  const char* file;
  double depth_m;       ///< of the recess behind the wall
  size_t wall, recess;  ///< wall points that one pick should gather there
};
// Counts of the labels: street_test.cpp tells the same of the planes that ransac finds.
constexpr Facade kFacades[] = {{"street_1.txt", 0.22, 22700, 950},
                               {"street_3.txt", 0.14, 19200, 400}};

PickSettings pick_params(const char* json) {
  ParamSet params("pick", pick_rows());
  params.from_json(json);
  return settings_from<PickSettings>(params);
}

// Where an operator would pick: the labelled wall point nearest to the middle of a segment of the automatic method
// that has no other points around it.
Vec3 place_on(const Scene& scene, const Segmentation& s, const Segment& segment) {
  constexpr double kAround_m = 0.2;
  const auto labels = s.labels->values<uint32_t>();
  std::vector<std::pair<double, size_t>> own;
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == segment.label && scene.faces[i] == kWall)
      own.emplace_back(squared_norm(scene.points[i] - segment.fit.centroid), i);
  std::sort(own.begin(), own.end());
  for (const auto& [distance, at] : own) {
    size_t foreign = 0;
    for (size_t i = 0; i < labels.size() && foreign == 0; ++i)
      foreign += labels[i] != segment.label && norm(scene.points[i] - scene.points[at]) < kAround_m;
    if (foreign == 0) return scene.points[at];
  }
  FAIL("no clear place to pick");
  return {};
}

const Segment* recess_of(const Scene& scene, const Segmentation& s, double depth_m) {
  const Segment& wall = s.segments[0];
  for (const Segment& segment : s.segments) {
    const double depth = -wall.fit.plane.distance(segment.fit.centroid);
    if (segment.label == 1 ||
        std::fabs(dot(wall.fit.plane.normal, segment.fit.plane.normal)) < 0.998)
      continue;
    const bool is_wall = 2 * overlap(scene, s, kWall, segment.label) > segment.fit.n;
    if (std::fabs(depth - depth_m) < 0.05 && is_wall) return &segment;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("with_pick__real_facades__one_pick_gives_the_wall_another_the_recess_behind_it") {
  const PickSettings settings =
      pick_params("{\"tolerance_m\": 0.025, \"gap_m\": 0.5, \"min_area_m2\": 0.05}");
  for (const Facade& facade : kFacades) {
    CAPTURE(facade.file);
    const Scene scene = street(facade.file);
    if (scene.points.empty()) {
      MESSAGE("skipped: the real scans are not on this machine");
      if (std::getenv("CI") != nullptr) FAIL("JALON_SHARED_DATA holds no facades");
      return;
    }
    const CloudPtr cloud = cloud_of(scene.points);
    const Segmentation automatic = run(cloud, ransac_params());
    const Segment* behind = recess_of(scene, automatic, facade.depth_m);
    REQUIRE(behind != nullptr);
    Task task;
    const Segmentation start = empty_segmentation(cloud, task);
    const Vec3 on_wall[] = {place_on(scene, automatic, automatic.segments[0])};
    const Segmentation one = with_pick(start, PrimitiveType::kPlane, on_wall, settings, task);
    const Vec3 on_recess[] = {place_on(scene, automatic, *behind)};
    const Segmentation two = with_pick(one, PrimitiveType::kPlane, on_recess, settings, task);
    const size_t wall = overlap(scene, two, kWall, 1), recess = overlap(scene, two, kWall, 2);
    const Segment &w = two.segments[0], &r = two.segments[1];
    const double depth =
        std::fabs(w.fit.plane.distance(r.fit.centroid));  // without a station no side is the front
    MESSAGE("FIGURE " << std::string(facade.file) << ": wall " << wall << " of its " << w.fit.n
                      << " points labelled wall (sigma " << 1e3 * w.fit.sigma << " mm), recess "
                      << recess << " of its " << r.fit.n << ", " << depth << " m behind; "
                      << remaining_points(two, task).size() << " points remain");
    const auto labelled = static_cast<double>(facade.wall);
    CHECK(std::fabs(static_cast<double>(wall) - labelled) <= 0.02 * labelled);
    CHECK(static_cast<double>(wall) >=
          0.9 * static_cast<double>(w.fit.n));  // doors lie within the tolerance as well
    CHECK(recess >= facade.recess);
    CHECK(2 * recess > r.fit.n);
    CHECK(std::fabs(depth - facade.depth_m) < 0.05);
    CHECK(w.orientation == Orientation::kParallel);
    CHECK(std::fabs(dot(w.fit.plane.normal, r.fit.plane.normal)) > 0.998);
    CHECK(one.segments.size() == 1);  // the undo
    CHECK(remaining_points(two, task).size() == cloud->size() - w.fit.n - r.fit.n);
    // A pick on the wall once it is taken, and one in the air.
    for (const Vec3& place : {on_wall[0], on_wall[0] + 30 * w.fit.plane.normal})
      CHECK_THROWS_AS(with_pick(two, PrimitiveType::kPlane, {&place, 1}, settings, task), Error);
  }
}
