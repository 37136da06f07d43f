// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr int kStreetWall = 1;

// True when the folder with the real scans is there; else says so.
bool street_have(const Scene& scene) {
  if (!scene.points.empty()) return true;
  MESSAGE("skipped: the real scans are not on this machine");
  return false;
}

// Wall-labelled points within 3 cm of a segment's plane.
size_t wall_points_near(const Scene& scene, const Segment& segment, double reach_m) {
  size_t count = 0;
  for (size_t i = 0; i < scene.points.size(); ++i)
    count += scene.faces[i] == kStreetWall &&
             std::fabs(segment.fit.plane.distance(scene.points[i])) <= reach_m;
  return count;
}

struct Found {
  size_t near = 0, labelled = 0;
};
Found found(const Scene& scene, const Segmentation& s, const Segment& segment) {
  return {wall_points_near(scene, segment, 0.03), overlap(scene, s, kStreetWall, segment.label)};
}

// The largest segments of the wall that lie this far behind the main plane.
std::vector<const Segment*> recesses(const Scene& scene, const Segmentation& s, double depth_m) {
  std::vector<const Segment*> out;
  const Segment& wall = s.segments[0];
  for (const Segment& segment : s.segments) {
    const double depth = -wall.fit.plane.distance(segment.fit.centroid);
    if (segment.label == 1 ||
        std::fabs(dot(wall.fit.plane.normal, segment.fit.plane.normal)) < 0.998)
      continue;
    if (std::fabs(depth - depth_m) < 0.05 &&
        2 * overlap(scene, s, kStreetWall, segment.label) > segment.fit.n)
      out.push_back(&segment);
  }
  return out;
}

}  // namespace

TEST_CASE("ransac finds the wall of street 1 once and the recess behind it, whatever the seed") {
  const Scene scene = street("street_1.txt");
  if (!street_have(scene)) return;
  const CloudPtr cloud = cloud_of(scene.points);
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const Segmentation s = run(cloud, ransac_params("{}", seed));
    REQUIRE(s.segments.size() > 2);
    const Segment& wall = s.segments[0];
    const Found f = found(scene, s, wall);
    MESSAGE("seed " << seed << ": wall " << f.labelled << " labelled, " << f.near
                    << " within 3 cm, sigma " << wall.fit.sigma * 1e3 << " mm, "
                    << s.segments.size() << " planes");
    CHECK(std::fabs(static_cast<double>(f.near) - 22700) <= 0.02 * 22700);
    CHECK(std::fabs(static_cast<double>(f.labelled) - 22700) <= 0.02 * 22700);
    CHECK(std::fabs(wall.fit.sigma - 0.005) <= 0.001);
    CHECK(wall.orientation == Orientation::kParallel);
    // No second segment lies in the wall's plane.
    for (const Segment& other : s.segments)
      if (other.label != 1 &&
          std::fabs(dot(other.fit.plane.normal, wall.fit.plane.normal)) > 0.998 &&
          std::fabs(wall.fit.plane.distance(other.fit.centroid)) < 0.02)
        CHECK(overlap(scene, s, kStreetWall, other.label) < 220);  // 1 % of the wall
    const auto behind = recesses(scene, s, 0.22);
    REQUIRE(behind.size() >= 1);
    const Found r = found(scene, s, *behind[0]);
    MESSAGE("  recess " << r.labelled << " labelled, " << r.near << " within 3 cm, "
                        << -wall.fit.plane.distance(behind[0]->fit.centroid) << " m behind, sigma "
                        << behind[0]->fit.sigma * 1e3 << " mm");
    CHECK(std::fabs(static_cast<double>(r.near) - 1400) <= 0.1 * 1400);
    CHECK(r.labelled >=
          950);  // the panel itself; the rest of the 1 400 are edges of openings at the same depth
  }
}

TEST_CASE("ransac finds the wall of street 3 and the panels behind it, whatever the seed") {
  const Scene scene = street("street_3.txt");
  if (!street_have(scene)) return;
  const CloudPtr cloud = cloud_of(scene.points);
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const Segmentation s = run(cloud, ransac_params("{}", seed));
    REQUIRE(s.segments.size() > 2);
    const Found f = found(scene, s, s.segments[0]);
    const auto behind = recesses(scene, s, 0.14);
    size_t panels = 0;
    for (const Segment* panel : behind) panels += overlap(scene, s, kStreetWall, panel->label);
    MESSAGE("seed " << seed << ": wall " << f.labelled << " labelled, " << f.near
                    << " within 3 cm, sigma " << s.segments[0].fit.sigma * 1e3 << " mm; "
                    << behind.size() << " panels behind with " << panels);
    CHECK(std::fabs(static_cast<double>(f.near) - 19200) <= 0.02 * 19200);
    CHECK(std::fabs(static_cast<double>(f.labelled) - 19200) <= 0.02 * 19200);
    CHECK(s.segments[0].fit.sigma < 0.006);
    CHECK(std::fabs(static_cast<double>(panels) - 5100) <= 0.02 * 5100);
  }
}

TEST_CASE("ransac joins the panels of street 3 to one plane when the merge gap spans them") {
  const Scene scene = street("street_3.txt");
  if (!street_have(scene)) return;
  const Segmentation s = run(cloud_of(scene.points), ransac_params("{\"merge_gap_m\": 6}"));
  const size_t panels = overlap(scene, s, kStreetWall, 2);
  MESSAGE("second segment: " << panels << " wall points");
  CHECK(std::fabs(static_cast<double>(panels) - 5100) <= 0.02 * 5100);
}
