// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What points on, behind and before a plane make of its cells.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "base/random.h"
#include "modelling/evidence/wall_cells.h"
#include "modelling/plane/segment_frame.h"
#include "modelling/plane/spacing.h"
#include "unit/modelling/walls.h"

using namespace jalon;

namespace {

constexpr double kPitch_m = 0.03;

// Points of a patch parallel to the wall y = 0, at a depth behind it (negative: before it).
std::vector<Vec3> patch_at(double left, double foot, double width, double height, double depth_m) {
  std::vector<Vec3> out;
  for (double u = left + kPitch_m / 2; u < left + width; u += kPitch_m)
    for (double v = foot + kPitch_m / 2; v < foot + height; v += kPitch_m)
      out.push_back({u, depth_m, v});
  return out;
}

// Hole k of the wall: 60 cm wide, about x = k + 1.
bool in_a_hole(double u, double v) {
  return v > 1 && v < 1.6 && std::fabs(u - std::round(u)) < 0.3 && u > 0.5 && u < 8.5;
}
std::vector<Vec3> holed_wall() {
  std::vector<Vec3> out;
  for (const Vec3& p : patch_at(0, 0, 9, 3, 0))
    if (!in_a_hole(p.x, p.z)) out.push_back(p);
  return out;
}
std::vector<Vec3> hole_filled(int k, double depth_m) {
  return patch_at(k + 0.7, 1, 0.6, 0.6, depth_m);
}

// The cells of segment 1, seen from an eye before the wall or from nowhere.
WallCells cells_from(const std::vector<std::vector<Vec3>>& parts, const Vec3* eye = nullptr,
                     unsigned threads = 1) {
  Segmentation segmentation = walls::segmentation_of(parts);
  if (eye != nullptr) {
    Cloud cloud = *segmentation.cloud;
    Station station;
    station.has_pose = true;
    station.pose.m[3] = eye->x, station.pose.m[7] = eye->y, station.pose.m[11] = eye->z;
    station.count = cloud.size();
    cloud.stations = {station};
    segmentation.cloud = std::make_shared<Cloud>(cloud);
  }
  std::vector<uint32_t> points(parts[0].size());
  std::iota(points.begin(), points.end(), 0u);
  const Segment& wall = segmentation.segments[0];
  const CellSource source{segment_frame(segmentation, wall, points), points, wall.fit.sigma, 1};
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return wall_cells(segmentation, {&source, 1}, {}, task).at(0);
}

WallState state_at(const WallCells& cells, double x, double z) {
  const Vec2 p = (cells.frame.project({x, 0, z}) - cells.origin) * (1 / cells.cell_m);
  return cells.at(static_cast<uint32_t>(p.u), static_cast<uint32_t>(p.v));
}

}  // namespace

TEST_CASE("wall_cells__a_blind_stands_back_whether_its_points_are_the_walls_or_nobodys") {
  for (const uint32_t label : {1u, 0u}) {
    CAPTURE(label);
    const std::vector<Vec3> own = holed_wall(), blind = hole_filled(1, 0.02);
    Segmentation segmentation = walls::segmentation_of({own, hole_filled(0, 0.2), blind});
    const auto before = segmentation.labels->values<uint32_t>();
    auto labels = std::make_shared<Column>(segmentation.labels->info(), before.size());
    std::vector<uint32_t> points;
    for (uint32_t i = 0; i < before.size(); ++i) {
      const uint32_t now = i < before.size() - blind.size() ? before[i] : label;
      labels->values<uint32_t>()[i] = now;
      if (now == 1) points.push_back(i);
    }
    segmentation.labels = std::move(labels);
    const CellSource source{
        segment_frame(segmentation, segmentation.segments[0], std::span(points).first(own.size())),
        points, 0.002, 1};
    Task task;
    const WallCells cells = wall_cells(segmentation, {&source, 1}, {}, task).at(0);
    CHECK(cells.set_back.size() == 1);
    CHECK(state_at(cells, 2, 1.3) == WallState::kThrough);
  }
}

TEST_CASE("wall_cells__without_stations_points_lie_straight_behind_and_before_their_cells") {
  const WallCells cells = cells_from(
      {holed_wall(), hole_filled(0, 0.2), hole_filled(1, 3), hole_filled(2, -0.06),
       hole_filled(3, -0.2), hole_filled(4, -2), hole_filled(5, 0.015), hole_filled(6, 0.005)});
  const WallState truth[] = {WallState::kThrough, WallState::kDeep,   WallState::kRelief,
                             WallState::kProud,   WallState::kHidden, WallState::kThrough,
                             WallState::kStrip,   WallState::kEmpty};
  for (int k = 0; k < 8; ++k) {
    CAPTURE(k);
    for (const double du : {-0.15, 0.0, 0.15}) CHECK(state_at(cells, k + 1 + du, 1.3) == truth[k]);
    CHECK(state_at(cells, k + 0.5, 1.3) == WallState::kOn);
  }
  CHECK(cells.spacing_m == doctest::Approx(kPitch_m).epsilon(0.15).scale(0));
  CHECK(cells.cell_m == doctest::Approx(2.2 * stepped_length(cells.spacing_m)));
  CHECK(cells.at(0, 0) == WallState::kOutside);  // its margin
}

TEST_CASE("wall_cells__points_of_another_segment_in_its_thickness_are_told_by_their_side") {
  const WallCells cells = cells_from({holed_wall(), hole_filled(0, -0.015), {}});
  CHECK(state_at(cells, 1, 1.3) == WallState::kRelief);
  // An upright plane across it: the reveal of a deep window.
  std::vector<Vec3> reveal;
  for (double y = -0.02; y < 0.3; y += 0.01)
    for (double z = 1; z < 1.6; z += 0.02) reveal.push_back({1.02, y, z});
  CHECK(state_at(cells_from({holed_wall(), reveal}), 1.02, 1.3) == WallState::kThrough);
  std::erase_if(reveal, [](const Vec3& p) { return p.y > 0.028; });
  CHECK(state_at(cells_from({holed_wall(), reveal}), 1.02, 1.3) == WallState::kStrip);
}

TEST_CASE("wall_cells__a_roof_that_meets_the_wall_is_no_relief_of_it") {
  std::vector<Vec3> eaves;
  for (double u = 0.7; u < 1.3; u += 0.02)
    for (double out = 0.035; out < 0.095; out += 0.005) eaves.push_back({u, -out, 1.35 - out});
  CHECK(!is_wall(state_at(cells_from({holed_wall(), eaves}), 1, 1.29)));
  for (Vec3& p : eaves) p.y = -0.06;
  CHECK(state_at(cells_from({holed_wall(), eaves}), 1, 1.29) == WallState::kRelief);
}

TEST_CASE("wall_cells__rays_from_stations_say_which_cell_they_passed") {
  const Vec3 eye{4, -6, 1.5};
  // Along the rays through hole k: once as far again behind the wall, half-way before it.
  const auto along = [&](int k, double times) {
    std::vector<Vec3> out;
    for (const Vec3& p : hole_filled(k, 0)) out.push_back(eye + (p - eye) * times);
    return out;
  };
  const std::vector<std::vector<Vec3>> parts{holed_wall(), along(1, 2), along(5, 0.5),
                                             along(6, 1.1)};
  const WallCells seen = cells_from(parts, &eye);
  CHECK(state_at(seen, 2, 1.3) == WallState::kThrough);
  CHECK(state_at(seen, 6, 1.3) == WallState::kHidden);
  CHECK(state_at(seen, 7, 1.3) == WallState::kThrough);
  CHECK(state_at(seen, 4, 1.3) == WallState::kEmpty);
  const WallCells unknown = cells_from(parts);
  CHECK(state_at(unknown, 2, 1.3) == WallState::kEmpty);
  CHECK(state_at(unknown, 6, 1.3) == WallState::kEmpty);
}

TEST_CASE("wall_cells__a_station_behind_the_plane_tells_nothing_of_what_is_before_it") {
  const Vec3 eye{4, 3, 1.3};
  const WallCells cells = cells_from({holed_wall(), hole_filled(3, 0.2), hole_filled(2, -2)}, &eye);
  CHECK(state_at(cells, 4, 1.3) == WallState::kEmpty);
  CHECK(state_at(cells, 3, 1.3) == WallState::kEmpty);
}

TEST_CASE("wall_cells__a_stray_point_tells_nothing_and_two_beside_each_other_do") {
  const auto state_with = [](const std::vector<Vec3>& unlabelled) {
    Segmentation segmentation = walls::segmentation_of({holed_wall(), unlabelled});
    const auto given = segmentation.labels->values<uint32_t>();
    const auto labels = std::make_shared<Column>(segmentation.labels->info(), given.size());
    for (size_t i = 0; i < given.size(); ++i) labels->values<uint32_t>()[i] = given[i] == 1 ? 1 : 0;
    segmentation.labels = labels;
    segmentation.segments.resize(1);
    std::vector<uint32_t> points(holed_wall().size());
    std::iota(points.begin(), points.end(), 0u);
    const Segment& wall = segmentation.segments[0];
    const CellSource source{segment_frame(segmentation, wall, points), points, wall.fit.sigma, 1};
    Task task;
    return state_at(wall_cells(segmentation, {&source, 1}, {}, task).at(0), 2, 1.3);
  };
  CHECK(state_with({{2, 0.8, 1.3}}) == WallState::kEmpty);
  CHECK(state_with({{2, 0.8, 1.3}, {5, 0.8, 1.3}}) == WallState::kEmpty);
  CHECK(state_with({{2, 0.8, 1.3}, {2.1, 0.8, 1.3}}) == WallState::kThrough);
}

TEST_CASE("wall_cells__are_the_same_with_one_thread_and_four") {
  RandomStream random(4, 40);
  std::vector<Vec3> clutter;
  for (int k = 0; k < 60000; ++k)
    clutter.push_back({9 * random.uniform(), 6 * random.uniform() - 3, 3 * random.uniform()});
  const Vec3 eye{4, -6, 1.5};
  for (const Vec3* from : {static_cast<const Vec3*>(nullptr), &eye}) {
    const WallCells one = cells_from({holed_wall(), clutter}, from, 1),
                    four = cells_from({holed_wall(), clutter}, from, 4);
    CHECK(one.states == four.states);
    CHECK(one.origin == four.origin);
    CHECK(one.cell_m == four.cell_m);
  }
}

TEST_CASE("wall_cells__of_a_source_of_fewer_than_nine_points_are_empty") {
  const std::vector<Vec3> few{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
  CHECK(cells_from({few, hole_filled(0, 1)}).empty());
}
