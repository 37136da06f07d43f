// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/given_segment.h"

#include <doctest/doctest.h>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<uint32_t> all_of(const Cloud& cloud) {
  std::vector<uint32_t> out(cloud.size());
  for (uint32_t i = 0; i < out.size(); ++i) out[i] = i;
  return out;
}

// A grid of spacing 0.1 m over 6 x 3 m at z = 2, of whose middle 2 x 1 m are left out.
std::vector<Vec3> plate_with_hole() {
  std::vector<Vec3> out;
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 30; ++k)
      if (i < 20 || i >= 40 || k < 10 || k >= 20)
        out.push_back({0.1 * i + 0.05, 0.1 * k + 0.05, 2});
  return out;
}

}  // namespace

TEST_CASE("describe_given__plane_extents_and_area_of_a_plate_with_a_hole") {
  const Vec3 origin{652000, 6861000, 0};
  const auto cloud = cloud_of(plate_with_hole(), origin);
  const auto all = all_of(*cloud);
  for (const unsigned threads : {1u, 3u}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    for (const double pixel_m : {0.0, 0.2}) {
      const Segment s = describe_given({*cloud, all, origin}, pixel_m, task);
      CHECK(s.has_plane());
      CHECK(s.fit.n == cloud->size());
      CHECK(std::fabs(s.fit.plane.normal.z) == doctest::Approx(1));
      CHECK(std::fabs(s.fit.plane.offset) == doctest::Approx(2));  // about the origin
      CHECK(s.length_u_m == doctest::Approx(5.9));
      CHECK(s.length_v_m == doctest::Approx(2.9));
      CHECK(s.area_m2 == doctest::Approx(16).epsilon(0.1));  // the hole does not count
    }
  }
}

TEST_CASE("describe_given__only_the_points_named") {
  auto points = plate_with_hole();
  const size_t plate = points.size();
  points.push_back({100, 100, 100});
  const auto cloud = cloud_of(points);
  auto indices = all_of(*cloud);
  indices.resize(plate);
  Task task;
  const Segment s = describe_given({*cloud, indices, {}}, 0, task);
  CHECK(s.fit.sigma < 1e-9);
  CHECK(s.fit.n == plate);
}

TEST_CASE("describe_given__without_a_plane_everything_but_the_number_is_NaN") {
  Task task;
  const std::vector<Vec3> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  for (const size_t n : {size_t{0}, size_t{1}, size_t{2}, size_t{4}}) {
    const auto cloud = cloud_of({line.begin(), line.begin() + static_cast<ptrdiff_t>(n)});
    const Segment s = describe_given({*cloud, all_of(*cloud), {}}, 0, task);
    CHECK_FALSE(s.has_plane());
    CHECK(s.fit.n == n);
    for (const double x : {s.area_m2, s.length_u_m, s.length_v_m, s.fit.sigma, s.fit.plane.normal.x,
                           s.fit.centroid.z, s.fit.covariance[15]})
      CHECK(std::isnan(x));
  }
}
