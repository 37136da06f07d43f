// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Two real facades with hand labels: how planes and classes of the hand labels agree.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "unit/segment/labelled.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr int kWall = 1, kDoor = 2, kWindow = 3;
constexpr double kBehind_m =
    0.05;  // doors and windows this far behind the wall's plane are no part of the wall
constexpr double kSamePlane_m = 0.025;     // the segmenter's tolerance
constexpr double kSameDirection = 0.9998;  // cosine of 1 degree

// True when the folder with the real scans is there; else says so.
bool have(const Scene& scene) {
  if (!scene.points.empty()) return true;
  MESSAGE("skipped: the real scans are not on this machine");
  return false;
}

// Row s: points of segment s (0 = noise) by class.
std::vector<std::array<size_t, 4>> confusion(const Scene& scene, const Segmentation& s) {
  std::vector<std::array<size_t, 4>> out(s.segments.size() + 1, std::array<size_t, 4>{});
  const auto labels = s.labels->values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i)
    ++out[labels[i]][static_cast<size_t>(std::clamp(scene.faces[i], 0, 3))];
  return out;
}

std::string table(const std::vector<std::array<size_t, 4>>& rows, const Segmentation& s) {
  constexpr size_t kShown = 15;
  const Plane& wall = s.segments[0].fit.plane;
  std::ostringstream out;
  out << "\n  segment    wall    door  window   depth m";
  const auto line = [&](const std::string& name, const std::array<size_t, 4>& row) {
    out << "\n  " << std::setw(7) << name;
    for (const int c : {kWall, kDoor, kWindow}) out << std::setw(8) << row[static_cast<size_t>(c)];
  };
  std::array<size_t, 4> rest{};
  for (size_t r = 1; r < rows.size(); ++r) {
    if (r > kShown) {
      for (size_t c = 0; c < 4; ++c) rest[c] += rows[r][c];
      continue;
    }
    line(std::to_string(r), rows[r]);
    out << std::setw(10) << std::fixed << std::setprecision(3)
        << -wall.distance(s.segments[r - 1].fit.centroid);
  }
  line("others", rest);
  line("noise", rows[0]);
  return out.str();
}

// The wall, however many pieces it has: segments in the plane of the largest one that are wall for the most part.
std::vector<bool> wall_segments(const Segmentation& s,
                                const std::vector<std::array<size_t, 4>>& rows) {
  const Plane& wall = s.segments[0].fit.plane;
  std::vector<bool> out(rows.size(), false);
  for (const Segment& segment : s.segments) {
    const auto& row = rows[segment.label];
    out[segment.label] = std::max_element(row.begin(), row.end()) - row.begin() == kWall &&
                         std::fabs(dot(wall.normal, segment.fit.plane.normal)) > kSameDirection &&
                         std::fabs(wall.distance(segment.fit.centroid)) < kSamePlane_m;
  }
  return out;
}

// Share of the points whose class is that of most points of their segment; noise counts as wrong.
double purity(const std::vector<std::array<size_t, 4>>& rows, size_t points) {
  size_t right = 0;
  for (size_t r = 1; r < rows.size(); ++r)
    right += *std::max_element(rows[r].begin(), rows[r].end());
  return static_cast<double>(right) / static_cast<double>(points);
}

Segmentation segmented(const Scene& scene, const std::string& method, Task& task) {
  const CloudPtr cloud = cloud_of(scene.points);
  return method == "ransac" ? segment_ransac(cloud, RansacSettings{}, task)
                            : segment_region_growing(cloud, GrowingSettings{}, task);
}

void check_street(const std::string& file, const std::string& method) {
  const Scene scene = street(file.c_str());
  if (!have(scene)) return;
  CAPTURE(file);
  CAPTURE(method);
  Task task;
  const Segmentation s = segmented(scene, method, task);
  REQUIRE(s.segments.size() > 3);
  const auto rows = confusion(scene, s);
  const std::vector<bool> is_wall = wall_segments(s, rows);
  const Plane& wall = s.segments[0].fit.plane;
  const auto labels = s.labels->values<uint32_t>();
  size_t behind = 0, shared = 0, wall_near = 0, wall_found = 0;
  for (size_t i = 0; i < labels.size(); ++i) {
    const double depth = -wall.distance(scene.points[i]);
    if (scene.faces[i] == kWall && std::fabs(depth) <= kSamePlane_m) {
      ++wall_near;
      wall_found += is_wall[labels[i]];
    }
    if (scene.faces[i] == kWall || depth < kBehind_m) continue;
    ++behind;
    shared += is_wall[labels[i]];
  }
  MESSAGE("FIGURE " << file << ", " << method << ": " << behind
                    << " door and window points 5 cm and more behind the wall, " << shared
                    << " of them in its segment; " << wall_found << " of " << wall_near
                    << " wall points of its plane in it; points in segments of their class: "
                    << purity(rows, labels.size()) << table(rows, s));
  CHECK(behind > 1000);
  CHECK(shared == 0);
  CHECK(static_cast<double>(wall_found) > 0.95 * static_cast<double>(wall_near));
  CHECK(purity(rows, labels.size()) > 0.75);
}

}  // namespace

TEST_CASE("ransac keeps doors and windows of street 1 out of the wall") {
  check_street("street_1.txt", "ransac");
}
TEST_CASE("ransac keeps doors and windows of street 3 out of the wall") {
  check_street("street_3.txt", "ransac");
}
TEST_CASE("region_growing keeps doors and windows of both streets out of the wall") {
  check_street("street_1.txt", "region_growing");
  check_street("street_3.txt", "region_growing");
}
