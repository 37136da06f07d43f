// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/section_planes.h"

#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

std::vector<double> places(const std::vector<SectionPlane>& planes) {
  std::vector<double> out;
  for (const SectionPlane& plane : planes) out.push_back(plane.at_m);
  return out;
}

TEST_CASE("section_planes__given_heights_and_multiples_of_the_step_each_once") {
  Task task;
  const Cloud cloud = cloud_of({{10, 20, 0.7}, {14, 20, 3.2}});
  SectionSettings settings;
  settings.at_m = {2, 1.25};
  settings.step_m = 1;
  const auto planes = planes_along_direction(cloud, settings, task);
  CHECK(places(planes) == std::vector<double>{1, 1.25, 2, 3});
  CHECK(places(planes_along_direction(cloud, {}, task)) == std::vector<double>{1, 2, 3});
  CHECK(planes[1].origin == Vec3{10, 20, 1.25});
  CHECK(planes[1].u == Vec3{1, 0, 0});  // seen from above, north up
  CHECK(planes[1].v == Vec3{0, 1, 0});
}

TEST_CASE("section_planes__upright_ones_look_along_the_direction") {
  Task task;
  SectionSettings settings;
  settings.direction = {0, 2, 0};
  settings.at_m = {5};
  const auto planes = planes_along_direction(cloud_of({{1, 4, 2}, {2, 6, 3}}), settings, task);
  CHECK(planes[0].u == Vec3{1, 0, 0});  // looking north, east is to the right
  CHECK(planes[0].v == Vec3{0, 0, 1});
  CHECK(planes[0].origin == Vec3{1, 5, 0});
}

TEST_CASE("section_planes__an_alignment_is_cut_square_at_its_stations") {
  SectionSettings settings;
  settings.step_m = 4;
  settings.at_m = {12};
  const std::vector<Vec3> bend{{0, 0, 3}, {0, 10, 5}, {0, 10, 6}, {6, 10, 0}};
  const auto planes = planes_along_alignment(bend, settings);
  CHECK(places(planes) == std::vector<double>{0, 4, 8, 12, 16});
  CHECK(planes[2].origin == Vec3{0, 8, 0});
  CHECK(planes[2].u == Vec3{1, 0, 0});
  CHECK(planes[3].origin == Vec3{2, 10, 0});
  CHECK(planes[3].u == Vec3{0, -1, 0});  // looking east, south is to the right
}

TEST_CASE("section_planes__no_place_and_too_many_are_refused") {
  Task task;
  const Cloud cloud = cloud_of({{0, 0, 0}, {1, 1, 1e9}});
  SectionSettings settings;
  const auto cut = [&] { planes_along_direction(cloud, settings, task); };
  settings.step_m = 1e-3;
  CHECK(status_of(cut) == Status::kLimit);
  settings.direction = {0, 0, 0};
  CHECK(status_of(cut) == Status::kInvalidArgument);
  settings.step_m = 0;
  settings.at_m = {11};
  const std::vector<Vec3> line{{0, 0, 0}, {0, 10, 0}}, point{{1, 1, 0}, {1, 1, 5}};
  CHECK(status_of([&] { planes_along_alignment(line, settings); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { planes_along_alignment(point, settings); }) == Status::kInvalidArgument);
}

TEST_CASE("section_planes__points_are_those_within_half_the_thickness") {
  Task task;
  SectionSettings settings;
  settings.direction = {1, 2, 2};
  settings.step_m = 0.3;
  const std::vector<Vec3> points = shifted(random_points(20000, 3, 5), kFar);
  const Cloud cloud = cloud_of(points);
  const auto planes = planes_along_direction(cloud, settings, task);
  // Thicker than the step: points are of several.
  const auto found = points_of_planes(cloud, planes, 0.4, 0, task);
  size_t shared = 0;
  for (size_t k = 0; k < planes.size(); ++k) {
    std::vector<uint32_t> expected;
    for (uint32_t i = 0; i < points.size(); ++i)
      if (std::fabs(dot(points[i] - planes[k].origin, planes[k].normal)) <= 0.2)
        expected.push_back(i);
    shared += expected.size();
    CHECK(found[k] == expected);
  }
  CHECK(shared > points.size());
}

TEST_CASE("section_planes__reach_ends_the_sections_of_an_alignment") {
  Task task;
  SectionSettings settings;
  settings.at_m = {1, 4};
  const std::vector<Vec3> bend{{0, 0, 0}, {0, 3, 0}, {3, 3, 0}};
  const auto planes = planes_along_alignment(bend, settings);
  const Cloud cloud =
      cloud_of({{0.5, 1, 7}, {2.5, 1.01, 0}, {-2, 0.99, 1}, {1, 2, 0}, {1, 4.9, 0}});
  const auto near = points_of_planes(cloud, planes, 0.1, 2, task);
  CHECK(near[0] == std::vector<uint32_t>{0, 2});
  CHECK(near[1] == std::vector<uint32_t>{3, 4});
  const auto all = points_of_planes(cloud, planes, 0.1, 0, task);
  CHECK(all[0] == std::vector<uint32_t>{0, 1, 2});
}

}  // namespace
}  // namespace jalon
