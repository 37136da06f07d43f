// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "triangle_growing": the study of its search distance; the scanner's grid as its network.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "unit/segment/lines/scanned.h"
#include "unit/segment/method_checks.h"
#include "unit/segment/plane_methods.h"
#include "unit/segment/ramp.h"
#include "unit/segment/same_bits.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr const char* kByGrid = "{\"network\": \"grid\"}";

// What one network makes of scans of the house: faces found, points of faces in their plane, largest miss of a wall.
struct HouseFigures {
  int found = 0;
  size_t planes = 0;
  double share = 0, miss_m = 0;
};
HouseFigures scan_houses(const char* json, uint64_t first_seed, uint64_t count) {
  HouseFigures out;
  for (uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    const Scanned scanned(scanned_house(), 0.005, 0.003, seed);
    const Segmentation s = segment_by("triangle_growing", scanned.cloud(true), json);
    out.planes += s.segments.size();
    for (int face = 1; face <= 6; ++face) {
      const BestMatch match = best_match(scanned.scene, s, face);
      out.share += match.share / (6 * static_cast<double>(count));
      if (match.label == 0 || match.share < 0.8) continue;
      ++out.found;
      const Plane& plane = s.segments[match.label - 1].fit.plane;
      for (const ScannedFace& f : {scanned_house()[static_cast<size_t>(face - 1)]})
        for (const Vec3& corner : {f.corner, f.corner + f.u, f.corner + f.v, f.corner + f.u + f.v})
          out.miss_m = std::max(out.miss_m, std::fabs(plane.distance(corner)));
    }
  }
  return out;
}

}  // namespace

TEST_CASE(
    "triangle_growing__a_smaller_search_distance_makes_smaller_segments_below_the_spacing_none") {
  const Scene scene = ramp(0.002, 3);
  size_t before = 0;
  for (const char* search : {"0.05", "0.1", "0.2", "0.4"}) {  // of a spacing of 0.2 m
    const Segmentation s =
        segment_by("triangle_growing", cloud_of(scene.points),
                   (std::string("{\"merge_gap_m\": 0, \"search_m\": ") + search + "}").c_str());
    const size_t largest = s.segments.empty() ? 0 : s.segments[0].fit.n;
    CHECK(largest >= before);
    if (std::string(search) == "0.1") CHECK(largest == 0);
    before = largest;
  }
  CHECK(before > 300);
}

TEST_CASE("triangle_growing__on_the_scanners_grid_finds_the_faces_that_local_triangles_find") {
  const uint64_t count = std::getenv("JALON_FULL") != nullptr ? 20 : 2;
  const HouseFigures grid = scan_houses(kByGrid, 101, count), local = scan_houses("{}", 101, count);
  for (const auto& [name, f] : {std::pair{"grid", &grid}, {"local", &local}})
    MESSAGE("FIGURE triangles, " << std::string(name) << ": " << f->found << " of " << 6 * count
                                 << " faces in " << f->planes << " planes, " << 100 * f->share
                                 << " % of their points, corners off by " << 1000 * f->miss_m
                                 << " mm at most");
  CHECK(grid.found == static_cast<int>(6 * count));
  CHECK(grid.planes <= 7 * count);
  CHECK(grid.share > 0.97);
  CHECK(grid.miss_m < 0.004);
}

TEST_CASE("triangle_growing__on_a_grid_splits_the_ramp_into_its_three_planes") {
  const Scene exact = ramp(0, 1);  // 51 rows of 16 points
  const RampResult r =
      judge_ramp(exact, segment_by("triangle_growing", in_rows(exact.points, 16), kByGrid));
  CHECK(r.angle_rad < 1e-6);
  CHECK(r.wrong == 0);
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Scene scene = ramp(0.005, seed);
    const RampResult noisy =
        judge_ramp(scene, segment_by("triangle_growing", in_rows(scene.points, 16), kByGrid));
    CHECK(noisy.angle_rad < 0.0035);
    CHECK(noisy.wrong <= 16);
  }
}

TEST_CASE(
    "triangle_growing__on_a_grid_gives_the_same_bits_for_any_threads_and_on_a_national_grid") {
  Scanned scanned(scanned_house(), 0.01, 0.003, 8);
  scanned.scene.points = snapped(scanned.scene.points);
  const auto by_grid = [&](unsigned threads, const Vec3& shift) {
    return segment_by("triangle_growing", scanned.cloud(true, shift), kByGrid, threads);
  };
  const Segmentation one = by_grid(1, {});
  CHECK(one.segments.size() >= 5);
  check_same(one, by_grid(2, {}), false);
  check_same(one, by_grid(7, {}), false);
  check_same(one, by_grid(2, {652000, 6861000, 35}), true);
}

TEST_CASE("triangle_growing__on_a_grid_takes_neighbours_from_the_fields_alone") {
  Scanned scanned(scanned_house(), 0.01, 0.003, 9);
  const char* const near = "{\"network\": \"grid\", \"search_m\": 0.2}";
  CHECK(segment_by("triangle_growing", scanned.cloud(true), near).segments.size() >= 5);
  // Points stay where they are, their places go to others far away.
  std::vector<uint32_t> rows = scanned.rows, columns = scanned.columns;
  for (size_t i = 0; i < rows.size(); ++i) {
    const size_t other = i * 7919 % rows.size();
    scanned.rows[i] = rows[other];
    scanned.columns[i] = columns[other];
  }
  CHECK(segment_by("triangle_growing", scanned.cloud(true), near).segments.empty());
  CHECK(segment_by("triangle_growing", scanned.cloud(true)).segments.size() >= 5);
}

TEST_CASE("triangle_growing__without_a_grid_is_by_local_triangles_whatever_was_asked") {
  const Scene scene = ramp(0.005, 4);
  Segmentation asked = segment_by("triangle_growing", cloud_of(scene.points), kByGrid);
  const Segmentation local = segment_by("triangle_growing", cloud_of(scene.points));
  asked.parameters_json = local.parameters_json;
  check_same(asked, local, false);
}

TEST_CASE("triangle_growing__on_a_grid_refuses_clouds_without_area_and_survives_repeated_points") {
  const auto in_grid = [](const CloudPtr& cloud) {
    std::vector<Vec3> points;
    for (size_t i = 0; i < cloud->size(); ++i) points.push_back(cloud->point(i));
    return segment_by("triangle_growing", in_rows(points, 50), kByGrid);
  };
  refuses_clouds_without_area([&](const CloudPtr& cloud) { in_grid(cloud); });
  survives_repeated_points(in_grid);
}
