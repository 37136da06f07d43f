// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/result/facade.h"

#include <doctest/doctest.h>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Segment plane(uint32_t label, const Vec3& normal, const Vec3& centroid, double area_m2) {
  Segment out;
  out.label = label;
  out.fit.plane.normal = normalized(normal);
  out.fit.plane.offset = dot(out.fit.plane.normal, centroid);
  out.fit.centroid = centroid;
  out.fit.axis_v = {0, 0, 1};
  out.fit.axis_u = cross(out.fit.axis_v, out.fit.plane.normal);
  out.area_m2 = area_m2;
  return out;
}

FacadeContext context_of(const Cloud& cloud) { return {cloud, {}, 0.0174533, true, nullptr}; }

}  // namespace

TEST_CASE("main_facade__the_largest_upright_plane") {
  std::vector<Segment> segments{plane(1, {0, 0, 1}, {}, 90), plane(2, {0, 1, 0}, {}, 30),
                                plane(3, {1, 0, 0.05}, {}, 40), plane(4, {0, 1, 0}, {}, 80)};
  segments[3].type = PrimitiveType::kCylinder;
  CHECK(main_facade(segments) == 2);
  segments.resize(1);
  CHECK(main_facade(segments) == -1);
  CHECK(main_facade({}) == -1);
}

TEST_CASE("turn_normals__toward_the_station_that_saw_most_of_the_points") {
  Cloud cloud = *cloud_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 5, 1}, {1, 5, 1}});
  const auto station = [](double y, uint64_t first, uint64_t count) {
    Station out;
    out.has_pose = true;
    out.pose.m[7] = y;
    out.first = first;
    out.count = count;
    return out;
  };
  cloud.stations = {station(-10, 0, 2), station(10, 2, 3)};
  const std::vector<uint32_t> labels{1, 1, 1, 2, 2};
  for (const double sense : {-1.0, 1.0}) {
    std::vector<Segment> segments{plane(1, {0, sense, 0}, {}, 1),
                                  plane(2, {0, sense, 0}, {0, 5, 1}, 1)};
    Task task;
    turn_normals(context_of(cloud), labels, segments, task);
    CHECK(segments[0].fit.plane.normal.y == -1);  // two points against one
    CHECK(segments[1].fit.plane.normal.y == 1);
    CHECK(segments[1].fit.plane.offset == doctest::Approx(5));
    CHECK(segments[0].front_source == FrontSource::kStation);
    CHECK(segments[0].front_confidence == doctest::Approx(2.0 / 3));
  }
}

TEST_CASE("turn_normals__without_stations_toward_the_likelier_viewer_of_the_wall") {
  // A wall of 10 x 10 m; panes of 1 x 1 m lie 0.2 m behind it.
  std::vector<Vec3> points;
  std::vector<uint32_t> labels;
  for (int i = 0; i < 200; ++i)
    for (int k = 0; k < 200; ++k) {
      const bool is_pane = i / 20 % 2 == 1 && k / 20 % 2 == 1 && i < 180 && k < 180;
      points.push_back({0.05 * i, is_pane ? 0.2 : 0, 0.05 * k});
      labels.push_back(is_pane ? 2 : 1);
    }
  const auto cloud = cloud_of(points);
  for (const double sense : {-1.0, 1.0}) {
    CAPTURE(sense);
    std::vector<Segment> segments{
        plane(1, {0, sense, 0}, {5, 0, 5}, 84), plane(2, {0, -sense, 0}, {5, 0.2, 5}, 16),
        plane(3, {0, 0, sense}, {5, -2, 0}, 10), plane(4, {sense, 0, 0}, {9, 0.1, 5}, 1)};
    for (Segment& s : segments) s.length_u_m = s.length_v_m = 10;
    segments[2].length_u_m = segments[3].length_u_m = 1;
    Task task;
    turn_normals(context_of(*cloud), labels, segments, task);
    for (const size_t s : {size_t{0}, size_t{1}}) {
      CHECK(segments[s].fit.plane.normal.y == -1);
      CHECK(segments[s].front_source == FrontSource::kEvidence);
      CHECK(segments[s].front_confidence > 0.9);
    }
    CHECK(segments[2].fit.plane.normal.z == 1);
    CHECK(segments[2].front_source == FrontSource::kNone);
    CHECK(std::isnan(segments[2].front_confidence));
    CHECK(segments[3].fit.plane.normal.x == -1);  // it is right of the wall's middle
  }
}

TEST_CASE("facade_transform__takes_the_facades_normal_to_minus_Y_and_keeps_Z") {
  const auto cloud = cloud_of({{0, 0, 0}});
  FacadeContext context = context_of(*cloud);
  context.origin = {652000, 6861000, 40};
  std::vector<Segment> segments{plane(1, {0.6, 0.8, 0}, {1.5, 2.5, 3.5}, 10),
                                plane(2, {0.8, -0.6, 0}, {}, 5), plane(3, {0, 0, 1}, {}, 50),
                                plane(4, {0, 0.7, 0.7}, {}, 2)};
  const Transform t = facade_transform(context, segments);
  CHECK(norm(t.direction({0.6, 0.8, 0}) - Vec3{0, -1, 0}) < 1e-12);
  CHECK(norm(t.direction({0, 0, 1}) - Vec3{0, 0, 1}) < 1e-12);
  CHECK(t.determinant() == doctest::Approx(1));
  CHECK(norm(t.point({652001, 6861002, 43})) < 1e-6);  // whole metres of the centroid
  classify(context, segments);
  CHECK(segments[0].orientation == Orientation::kParallel);
  CHECK(segments[1].orientation == Orientation::kVertical);
  CHECK(segments[2].orientation == Orientation::kHorizontal);
  CHECK(segments[3].orientation == Orientation::kInclined);
  context.facade_frame = false;
  CHECK(facade_transform(context, segments).m == Transform{}.m);
}
