// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/visibility.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "unit/compare/lattice.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Visibility label(const Cloud& reference, const Vec3& p, const DepthSettings& settings = {}) {
  Task task;
  return VisibilityTest(reference, settings, task).label(p);
}

DepthMap map_of(const Cloud& cloud, const DepthSettings& settings = {}) {
  Task task;
  return DepthMap::build(cloud, cloud.stations[0], {}, settings, task);
}

Cloud shuffled(const Cloud& cloud) {
  std::vector<uint64_t> order(cloud.size());
  RandomStream random(3, 4);
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  Task task;
  Cloud out = select(cloud, order, task);
  out.stations = cloud.stations;
  return out;
}

/// A screen of 1 x 1 m at y = 3 before a wall at y = 10.
double screen_before_wall(const Vec3& d) {
  if (d.y > 0 && std::abs(d.x / d.y * 3) <= 0.5 && std::abs(d.z / d.y * 3) <= 0.5) return 3 / d.y;
  return wall_at(10)(d);
}

}  // namespace

TEST_CASE("visibility__arc_tangent_equals_the_librarys") {
  double worst = 0;
  RandomStream random(1, 1);
  for (int i = 0; i < 100000; ++i) {
    const double x = 2 * random.uniform() - 1, y = 2 * random.uniform() - 1;
    worst = std::max(worst, std::abs(arc_tangent2(y, x) - std::atan2(y, x)));
  }
  CHECK(worst < 1e-10);
  for (const double a : {0.0, 1.0, -1.0})
    for (const double b : {0.0, 1.0, -1.0})
      CHECK(std::abs(arc_tangent2(a, b) - std::atan2(a, b)) < 1e-10);
}

TEST_CASE("visibility__steps_are_found_whatever_the_order_of_the_points") {
  Look look;
  for (const auto& [h, v] : {std::pair{0.01, 0.01}, {0.005, 0.02}, {0.02, 0.004}}) {
    look.horizontal_step = h;
    look.vertical_step = v;
    look.angle_noise = 2e-5;
    const Cloud cloud = lattice(look, {}, wall_at(10));
    for (const Cloud& c : {cloud, shuffled(cloud)}) {
      DepthSettings settings;
      settings.cell_factor = 1;
      const AngularGrid grid = map_of(c, settings).grid();
      CHECK(grid.horizontal_step_rad == doctest::Approx(h).epsilon(0.02).scale(0));
      CHECK(grid.vertical_step_rad == doctest::Approx(v).epsilon(0.02).scale(0));
    }
  }
}

TEST_CASE("visibility__a_station_sees_its_own_points") {
  const Cloud cloud = lattice({}, {}, screen_before_wall);
  Task task;
  for (const CellRule rule : {CellRule::kNearest, CellRule::kFarthest, CellRule::kMean}) {
    DepthSettings settings;
    settings.rule = rule;
    size_t lost = 0;
    for (const uint8_t l : visibility_labels(VisibilityTest(cloud, settings, task), cloud, task))
      lost += l != 0;
    // At the screen's edge a cell holds points of both.
    CHECK(lost <= (rule == CellRule::kFarthest ? 0 : 80));
  }
}

TEST_CASE("visibility__labels_before_and_behind_what_was_seen") {
  const Cloud cloud = lattice({}, {}, screen_before_wall);
  CHECK(label(cloud, {0, 2, 0}) == Visibility::kVisible);
  CHECK(label(cloud, {0, 3.05, 0}) == Visibility::kVisible);  // within the margin
  CHECK(label(cloud, {0, 3.3, 0}) == Visibility::kHidden);
  CHECK(label(cloud, {0, 10, 0}) == Visibility::kHidden);
  CHECK(label(cloud, {2.5, 10, 0}) == Visibility::kVisible);
  CHECK(label(cloud, {2.5, 10.5, 0}) == Visibility::kHidden);
  CHECK(label(cloud, {10, 10, 0}) == Visibility::kOutOfField);
  CHECK(label(cloud, {0, -10, 0}) == Visibility::kOutOfField);
  CHECK(label(cloud, {0, 10, 8}) == Visibility::kOutOfField);
  DepthSettings settings;
  settings.max_range_m = 5;
  CHECK(label(cloud, {2.5, 10, 0}, settings) == Visibility::kOutOfRange);
  CHECK(label(cloud, {10, 10, 0}, settings) == Visibility::kOutOfField);
  settings.max_range_m = 0;
  settings.margin_factor = 1.2;
  CHECK(label(cloud, {0, 3.6, 0}, settings) == Visibility::kVisible);
  CHECK(label(cloud, {0, 3.8, 0}, settings) == Visibility::kHidden);
}

TEST_CASE("visibility__ground_under_grazing_rays_does_not_hide_itself") {
  // From 2 m high one step of 0.01 rad spans 9 m at 40 m.
  const auto ground = [](const Vec3& d) { return d.z < -0.04 ? -2 / d.z : 0; };
  Look look;
  look.high = 0;
  const Cloud cloud = lattice(look, {}, ground);
  DepthSettings settings;
  Task task;
  const VisibilityTest test(cloud, settings, task);
  size_t n = 0, lost = 0;
  for (double y = 5; y < 38; y += 0.13)
    for (double x = -0.3 * y; x < 0.3 * y; x += 0.21) {
      ++n;
      lost += test.label({x, y, -2}) != Visibility::kVisible;
    }
  MESSAGE("FIGURE ground points lost: " << lost << " of " << n);
  CHECK(lost * 100 <= n);
  CHECK(test.label({0, 20, -2.5}) == Visibility::kHidden);
}

TEST_CASE("visibility__holes_are_filled_and_the_sky_is_not") {
  Look look;
  RandomStream random(7, 1);
  // One pulse in five is lost; above 0.2 rad there is nothing, but for a mast that keeps the field high.
  const Cloud cloud = lattice(look, {}, [&](const Vec3& d) {
    if (d.z > 0.2) return std::abs(d.x) < 0.02 && d.y > 0 ? 4 / d.y : 0.0;
    return random.uniform() < 0.2 ? 0.0 : wall_at(10)(d);
  });
  DepthSettings settings;
  settings.cell_factor = 1;
  const DepthMap map = map_of(cloud, settings);
  size_t filled = 0, low_empty = 0, low = 0, high_empty = 0, high = 0;
  for (size_t c = 0; c < map.grid().size(); ++c) {
    const auto column = static_cast<uint32_t>(c % map.grid().columns),
               row = static_cast<uint32_t>(c / map.grid().columns);
    const double v = map.grid().vertical_of(row);
    filled += map.fill(column, row) == DepthMap::Fill::kFilled;
    if (v < 0.18) ++low, low_empty += map.fill(column, row) == DepthMap::Fill::kEmpty;
    if (v > 0.25) ++high, high_empty += map.fill(column, row) == DepthMap::Fill::kEmpty;
  }
  CHECK(filled > 500);
  CHECK(low_empty * 500 <= low);
  CHECK(high_empty > high * 9 / 10);
  // What an empty cell says.
  CHECK(label(cloud, direction_of(0.3, 0.3) * 8, settings) == Visibility::kHidden);
  settings.empty = EmptyCell::kFree;
  CHECK(label(cloud, direction_of(0.3, 0.3) * 8, settings) == Visibility::kVisible);
}

TEST_CASE("visibility__a_full_circle_has_neither_seam_nor_poles") {
  const double turn = 2 * std::numbers::pi;
  for (const double start : {-1.0, 0.3, 3.1}) {
    Look look{start, start + turn - 0.01, -std::numbers::pi / 2, std::numbers::pi / 2, 0.02, 0.02,
              0};
    const Cloud cloud = lattice(look, {}, [](const Vec3&) { return 5.0; });
    Task task;
    const VisibilityTest test(cloud, {}, task);
    CHECK(test.maps()[0].grid().is_closed);
    for (double h = -std::numbers::pi; h <= std::numbers::pi; h += 0.013)
      for (const double v : {-1.57, -1.5, -0.7, 0.0, 0.7, 1.5, 1.57}) {
        REQUIRE(test.label(direction_of(h, v) * 4.9) == Visibility::kVisible);
        REQUIRE(test.label(direction_of(h, v) * 5.3) == Visibility::kHidden);
      }
    CHECK(test.label({0, 0, 4.9}) == Visibility::kVisible);
    CHECK(test.label({0, 0, -5.3}) == Visibility::kHidden);
  }
}

TEST_CASE("visibility__a_field_over_the_back_of_the_scanner_stays_one_field") {
  Look look;
  look.left = std::numbers::pi - 0.5;
  look.right = std::numbers::pi + 0.5;
  const Cloud cloud = lattice(look, {}, [](const Vec3&) { return 5.0; });
  CHECK(label(cloud, {0, -4, 0}) == Visibility::kVisible);
  CHECK(label(cloud, {0, -6, 0}) == Visibility::kHidden);
  CHECK(label(cloud, {0, 4, 0}) == Visibility::kOutOfField);
}

TEST_CASE("visibility__the_best_of_several_stations_counts") {
  Task task;
  const Cloud front = lattice({}, {}, screen_before_wall);
  // A second one looks at the wall from behind the screen.
  Transform pose;
  pose.m[7] = 5;
  const Cloud both = append(front, lattice({}, pose, wall_at(5)), task);
  REQUIRE(both.stations.size() == 2);
  CHECK(label(front, {0, 10, 0}) == Visibility::kHidden);
  CHECK(label(both, {0, 10, 0}) == Visibility::kVisible);
  CHECK(label(both, {0, 4, 0}) ==
        Visibility::kHidden);  // before the second one: only hidden from the first
  CHECK(label(both, {0, 11, 0}) == Visibility::kHidden);
  CHECK(label(both, {40, 5, 0}) == Visibility::kOutOfField);
}

TEST_CASE("visibility__a_triangulation_scanner_must_see_with_both_eyes") {
  const Cloud cloud = lattice({}, {}, screen_before_wall);
  DepthSettings settings;
  settings.second_centre_m = {1, 0, 0};
  // Just beside the screen for the emitter, behind it for the receiver.
  const Vec3 p{-2.2, 10, 0};
  CHECK(label(cloud, p) == Visibility::kVisible);
  CHECK(label(cloud, p, settings) == Visibility::kHidden);
  CHECK(label(cloud, {-4.6, 10, 0}, settings) == Visibility::kVisible);
}

TEST_CASE("visibility__needs_stations_with_poses") {
  Task task;
  Cloud cloud = lattice({}, {}, wall_at(10));
  cloud.stations[0].has_pose = false;
  CHECK_THROWS_AS(VisibilityTest(cloud, {}, task), Error);
  cloud.stations.clear();
  CHECK_THROWS_AS(VisibilityTest(cloud, {}, task), Error);
  CHECK(label(Cloud{}, {1, 2, 3}) == Visibility::kOutOfField);
  DepthSettings fine;
  fine.horizontal_step_rad = fine.vertical_step_rad = 1e-7;
  CHECK_THROWS_AS(label(lattice({}, {}, wall_at(10)), {0, 1, 0}, fine), Error);
}

TEST_CASE("visibility__one_point_and_a_point_in_the_scanner_are_no_trouble") {
  Look one{0, 0, 0, 0, 1, 1, 0};
  const Cloud cloud = lattice(one, {}, wall_at(10));
  REQUIRE(cloud.size() == 1);
  CHECK(label(cloud, {0, 9, 0}) == Visibility::kVisible);
  CHECK(label(cloud, {0, 11, 0}) == Visibility::kHidden);
  CHECK(label(cloud, {0, 0, 0}) == Visibility::kVisible);
}

TEST_CASE("visibility__same_labels_for_any_threads_and_any_grid") {
  const Vec3 shift{652000, 6861000, 35};
  Transform here, there;
  for (size_t a = 0; a < 3; ++a) there.m[4 * a + 3] = shift[static_cast<int>(a)];
  Look look;
  look.angle_noise = 1e-4;
  // Coordinates on a grid of 2^-13 m are exact in both places.
  const auto snapped = [](Cloud cloud) {
    Buffer<double> xyz(3 * cloud.size());
    for (size_t i = 0; i < xyz.size(); ++i)
      xyz.data()[i] = std::nearbyint(cloud.xyz()[i] * 8192) / 8192;
    cloud.xyz_buffer = std::make_shared<const Buffer<double>>(std::move(xyz));
    return cloud;
  };
  const Cloud reference = snapped(lattice(look, here, screen_before_wall));
  look.angle_noise = 3e-4;
  const Cloud compared = snapped(lattice(look, here, wall_at(10)));
  Task one;
  const Cloud far_reference = transformed(reference, there, one),
              far = transformed(compared, there, one);
  const auto expected = visibility_labels(VisibilityTest(reference, {}, one), compared, one);
  Task::Hooks hooks;
  for (const unsigned threads : {1u, 2u, 5u}) {
    hooks.threads = threads;
    Task task(hooks);
    CHECK(visibility_labels(VisibilityTest(reference, {}, task), compared, task) == expected);
    CHECK(visibility_labels(VisibilityTest(far_reference, {}, task), far, task) == expected);
  }
}
