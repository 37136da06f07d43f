// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/ending.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Scene wall_and_floor() {
  Scene out;
  RandomStream random(1, 7);
  out.rectangle(1, {0, 0, 0.05}, {3, 0, 0}, {0, 0, 2}, 2000, 0.004, random);
  out.rectangle(2, {0, -3, 0}, {3, 0, 0}, {0, 2.9, 0}, 3000, 0.004, random);
  out.points.push_back({1, -1, 1});
  out.faces.push_back(0);
  return out;
}

}  // namespace

TEST_CASE("ending__require_area_tells_too_few_points_from_points_on_a_line") {
  const auto status_of = [](const std::vector<Vec3>& points) {
    Task task;
    try {
      require_area(*cloud_of(points), task);
    } catch (const Error& error) {
      return error.status();
    }
    return Status::kOk;
  };
  CHECK(status_of({}) == Status::kInsufficientData);
  CHECK(status_of({{1, 2, 3}, {4, 5, 6}}) == Status::kInsufficientData);
  CHECK(status_of({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}) == Status::kDegenerate);
  CHECK(status_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == Status::kOk);
}

TEST_CASE("ending__finish_sorts_by_points_and_labels_each_of_them") {
  const Scene scene = wall_and_floor();
  MadeScene made(scene.points);
  auto surfaces = made.surfaces(scene.faces, 2);
  const Segmentation s = finish_segmentation(made.cloud, made.scene, surfaces, made.task);
  REQUIRE(s.segments.size() == 2);
  const auto labels = s.labels->values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i)  // the floor has more points
    CHECK(labels[i] == (scene.faces[i] == 2 ? 1u : scene.faces[i] == 1 ? 2u : 0u));
  CHECK(s.segments[0].orientation == Orientation::kHorizontal);
  CHECK(s.segments[0].fit.plane.normal.z > 0.999);
  CHECK(s.segments[1].orientation == Orientation::kParallel);
  CHECK(s.segments[1].fit.n == 2000);
  CHECK(s.segments[1].length_u_m == doctest::Approx(3).epsilon(0.06));
  CHECK(s.segments[1].length_v_m == doctest::Approx(2).epsilon(0.06));
  for (const Segment& segment : s.segments)  // in world coordinates
    CHECK(segment.fit.plane.distance(segment.fit.centroid) == doctest::Approx(0).scale(1));
  const auto residuals = s.residuals->values<float>();
  CHECK(std::isnan(residuals[scene.points.size() - 1]));
  for (size_t i = 0; i < 100; ++i)
    CHECK(static_cast<double>(residuals[i]) ==
          doctest::Approx(s.segments[1].distance(scene.points[i])).epsilon(1e-3).scale(0.01));
}

TEST_CASE("ending__share_out_leaves_surfaces_alone_when_told_to") {
  const Scene scene = wall_and_floor();
  for (const bool reassign : {false, true}) {
    SurfaceSettings settings;
    settings.reassign = reassign;
    MadeScene made(scene.points, settings);
    auto surfaces = made.surfaces(scene.faces, 2);
    auto& floor = surfaces[1].positions;  // a few points were not found
    for (size_t i = 0; i < 100; ++i) made.scene.owner[floor.back()] = 0, floor.pop_back();
    share_out_points(made.scene, surfaces, made.task);
    REQUIRE(surfaces.size() == 2);
    if (reassign) CHECK(surfaces[1].positions.size() > 2950);
    else CHECK(surfaces[1].positions.size() == 2900);
  }
}
