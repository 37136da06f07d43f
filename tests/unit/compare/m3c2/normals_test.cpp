// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Directions at core points, on planes whose normals are known.
#include "compare/m3c2/normals.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/numbers.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Modes = M3c2Settings::Normals;

CoreNormals::Normal core_normal(const M3c2Settings& settings, const Cloud& source, const Vec3& core,
                                const std::vector<double>& given = {}) {
  Task task;
  Cloud points = cloud_of({core});
  if (!given.empty())
    points.fields.set(make_column<double>(
        {"normal", ElementType::kFloat64, static_cast<uint32_t>(given.size()), "", ""},
        std::span<const double>(given)));
  const CoreNormals normals(settings, std::make_shared<const Cloud>(source),
                            std::make_shared<const Cloud>(points), task);
  CoreNormals::Work work = normals.work();
  return normals.at(0, work);
}

/// Points of a plane in a square of 1 m about the middle.
std::vector<Vec3> square_of_plane(const Vec3& normal, const Vec3& middle, size_t n = 400) {
  RandomStream random(11, 3);
  const Vec3 u = normalized(cross(normal, {0.3, 1, 0.2})), v = cross(normal, u);
  std::vector<Vec3> out;
  for (size_t i = 0; i < n; ++i) {
    const double a = random.uniform() - 0.5, b = random.uniform() - 0.5;
    out.push_back(middle + u * a + v * b);
  }
  return out;
}

}  // namespace

TEST_CASE("core_normals__are_those_of_the_plane_within_the_radius") {
  const Vec3 slope = normalized({0.6, -0.2, 0.7});
  auto points = square_of_plane(slope, {});
  // A wall just beyond the ball.
  for (const Vec3& p : square_of_plane({1, 0, 0}, {0.26, 0, 0})) points.push_back(p);
  const Cloud cloud = cloud_of(points);
  M3c2Settings settings;
  const CoreNormals::Normal found = core_normal(settings, cloud, {});
  CHECK(found.known);
  CHECK(found.radius_m == 0.25);
  CHECK(norm(found.direction - slope) < 1e-12);  // exact points: rounding alone
  // Of a larger radius too the smaller one looks no farther than itself.
  settings.normal_radii_m = {0.6, 0.25};
  CHECK(core_normal(settings, cloud, {}).radius_m == 0.25);
  CHECK(norm(core_normal(settings, cloud, {}).direction - slope) < 1e-12);
  settings.orientation_direction = {0, 0, -1};
  CHECK(norm(core_normal(settings, cloud, {}).direction + slope) < 1e-12);
  settings.normals = Modes::kHorizontal;
  const Vec3 level = normalized({slope.x, slope.y, 0});
  CHECK(norm(cross(core_normal(settings, cloud, {}).direction, level)) < 1e-12);
}

TEST_CASE("core_normals__are_unknown_where_points_fix_none") {
  M3c2Settings settings;
  CHECK_FALSE(core_normal(settings, cloud_of({{0, 0, 0}, {0.1, 0, 0}}), {}).known);
  std::vector<Vec3> line;
  for (int i = 0; i < 20; ++i) line.push_back(Vec3{0.01, 0.005, 0.002} * i);
  CHECK_FALSE(core_normal(settings, cloud_of(line), {}).known);
  line.push_back({0, 0.01, 0});
  CHECK(core_normal(settings, cloud_of(line), {}).known);
  CHECK_FALSE(core_normal(settings, cloud_of(line), {9, 9, 9}).known);
  // A floor has no horizontal normal.
  settings.normals = Modes::kHorizontal;
  CHECK_FALSE(core_normal(settings, cloud_of(square_of_plane({0, 0, 1}, {})), {}).known);
  settings.normals = Modes::kVertical;
  CHECK(core_normal(settings, Cloud{}, {}).direction == Vec3{0, 0, 1});
}

TEST_CASE("core_normals__look_to_the_station_of_the_nearest_point_and_refuse_points_without_one") {
  // The left half of a floor was seen from above, the right half from the cellar.
  auto points = square_of_plane({0, 0, 1}, {0, 0, 0});
  const size_t left = points.size();
  for (const Vec3& p : square_of_plane({0, 0, 1}, {2, 0, 0})) points.push_back(p);
  Cloud cloud = cloud_of(points);
  Station above, below;
  above.has_pose = below.has_pose = true;
  above.pose.m[11] = 5;
  below.pose.m[11] = -5;
  above.count = below.count = below.first = left;
  cloud.stations = {above, below};
  M3c2Settings settings;
  settings.normal_radius_m = 1.5;  // over both halves
  CHECK(core_normal(settings, cloud, {0.4, 0, 0.01}).direction.z > 0.999);
  CHECK(core_normal(settings, cloud, {1.6, 0, 0.01}).direction.z < -0.999);
  settings.orientation = M3c2Settings::Orientation::kStation;
  cloud.stations[1].first += 1, cloud.stations[1].count -= 1;
  CHECK_THROWS_WITH_AS(core_normal(settings, cloud, {}), doctest::Contains("point 400 "), Error);
  cloud.stations = {above, below};
  cloud.stations[1].has_pose = false;
  CHECK(status_of([&] { core_normal(settings, cloud, {}); }) == Status::kInvalidArgument);
  CHECK_THROWS_WITH_AS(core_normal(settings, cloud, {}), doctest::Contains("point 400 "), Error);
}

TEST_CASE("core_normals__take_the_least_of_equally_flat_radii_and_the_field_when_given") {
  M3c2Settings settings;
  settings.normal_radii_m = {0.4, 0.2, 0.3};
  CHECK(core_normal(settings, cloud_of(square_of_plane({0, 0, 1}, {})), {}).radius_m == 0.2);
  settings.normals = Modes::kGiven;
  CHECK(norm(core_normal(settings, Cloud{}, {}, {0, 3, -4}).direction - Vec3{0, 0.6, -0.8}) <
        1e-15);
  CHECK_FALSE(core_normal(settings, Cloud{}, {}, {0, 0, 0}).known);
  CHECK_FALSE(core_normal(settings, Cloud{}, {}, {0, kNaN, 1}).known);
  CHECK(status_of([&] { core_normal(settings, Cloud{}, {}); }) == Status::kNotFound);
  CHECK_THROWS_WITH_AS(core_normal(settings, Cloud{}, {}, {1, 2}), doctest::Contains("\"normal\""),
                       Error);
}

TEST_CASE("core_normals__in_a_crowd_are_those_of_its_points_without_looking_at_each") {
  // Half of the points within a nanometre, the others about them, on a slope.
  const Vec3 slope = normalized({0.6, -0.2, 0.7}), middle{0.1, 0.2, 0.3};
  auto points = square_of_plane(slope, middle, 10000);
  const size_t n = points.size();
  for (size_t i = 0; i < n; ++i) points.push_back(middle + 1e-9 * (points[i] - middle));
  const auto cloud = std::make_shared<const Cloud>(cloud_of(points));
  M3c2Settings settings;
  settings.normal_radii_m = {0.05, 0.25};
  const auto core = std::make_shared<const Cloud>(cloud_of({middle, middle + Vec3{0, 0, 1e-10}}));
  Task task;
  const CoreNormals normals(settings, cloud, core, task);
  CoreNormals::Work work = normals.work();
  REQUIRE(work.balls.size() == 2);
  for (const size_t i : {size_t{0}, size_t{1}}) {
    const CoreNormals::Normal found = normals.at(i, work);
    REQUIRE(found.known);
    CHECK(norm(found.direction - slope) < 1e-9);
  }
  CHECK(work.balls[0].looked_at() < n);  // of the 2 n points, from either core point
  CHECK(work.squared_m2.empty());
}
