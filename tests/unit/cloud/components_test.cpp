// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/voxels/components.h"

#include <doctest/doctest.h>

#include <chrono>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

std::vector<uint32_t> labels_of(const std::vector<Vec3>& points, double cell_m,
                                Connectivity3 connectivity, uint64_t min_points = 1) {
  Task task;
  const Cloud cloud = cloud_of(points);
  return connected_components(cloud.xyz(), {0, 0, 0}, cell_m, connectivity, min_points, task)
      .labels;
}

TEST_CASE("components__face_edge_and_corner_neighbours__join_by_6_18_26") {
  const std::vector<Vec3> face{{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}},
      edge{{0.5, 0.5, 0.5}, {1.5, 1.5, 0.5}}, corner{{0.5, 1.5, 0.5}, {1.5, 0.5, 1.5}};
  const std::vector<uint32_t> one{1, 1}, two{1, 2};
  CHECK(labels_of(face, 1, Connectivity3::k6) == one);
  CHECK(labels_of(edge, 1, Connectivity3::k6) == two);
  CHECK(labels_of(edge, 1, Connectivity3::k18) == one);
  CHECK(labels_of(corner, 1, Connectivity3::k18) == two);
  CHECK(labels_of(corner, 1, Connectivity3::k26) == one);
}

TEST_CASE("components__equal_a_flood_of_the_cells") {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    const auto points = random_points(600, 12, seed);
    for (const auto connectivity : {Connectivity3::k6, Connectivity3::k18, Connectivity3::k26}) {
      const auto labels = labels_of(points, 1, connectivity);
      const int most = connectivity == Connectivity3::k6    ? 1
                       : connectivity == Connectivity3::k18 ? 2
                                                            : 3;
      // Brute force: grow sets of points whose cells touch, until nothing changes.
      std::vector<size_t> root(points.size());
      for (size_t i = 0; i < root.size(); ++i) root[i] = i;
      for (bool changed = true; changed;) {
        changed = false;
        for (size_t i = 0; i < points.size(); ++i)
          for (size_t j = 0; j < i; ++j) {
            int apart = 0, far = 0;
            for (int c = 0; c < 3; ++c) {
              const int d = std::abs(int(std::floor(points[i][c])) - int(std::floor(points[j][c])));
              apart += d;
              far = std::max(far, d);
            }
            if (far > 1 || apart > most || root[i] == root[j]) continue;
            root[i] = root[j] = std::min(root[i], root[j]);
            changed = true;
          }
      }
      for (size_t i = 0; i < points.size(); ++i)
        for (size_t j = 0; j < i; ++j) CHECK((labels[i] == labels[j]) == (root[i] == root[j]));
    }
  }
}

TEST_CASE("components__numbered_by_size_ties_by_first_point_small_ones_0") {
  std::vector<Vec3> points;
  const auto blob = [&](double x, size_t n) {
    for (size_t i = 0; i < n; ++i) points.push_back({x + 0.01 * static_cast<double>(i), 0.5, 0.5});
  };
  blob(50, 5);
  blob(10, 20);
  blob(30, 5);
  blob(70, 2);
  const auto labels = labels_of(points, 1, Connectivity3::k26, 3);
  CHECK(labels[0] == 2);
  CHECK(labels[5] == 1);
  CHECK(labels[25] == 3);
  CHECK(labels[30] == 0);
}

TEST_CASE("components__a_million_points_of_a_street__figures") {
  // Facades, ground and isolated points: cells of 0.1 m.
  RandomStream random(1, 0);
  std::vector<Vec3> points;
  for (size_t i = 0; i < 1000000; ++i) {
    const double u = 60 * random.uniform(), v = 12 * random.uniform();
    if (i % 20 == 0) points.push_back({u, v, 12 * random.uniform()});
    else if (i % 2 == 0) points.push_back({u, 0.003 * random.normal(), v});
    else points.push_back({u, v, 0.003 * random.normal()});
  }
  Cloud cloud = cloud_of(points);
  ComponentsSettings set;
  uint64_t count = 0;
  double best = 1e9;
  for (int run = 0; run < 3; ++run) {
    Task task;
    const auto start = std::chrono::steady_clock::now();
    const Cloud out = with_components(cloud, set, task, count);
    best = std::min(
        best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  MESSAGE("FIGURE components of 1 M points, 0.1 m, 26: ", best, " s, ", count,
          " components (goal 0.2 s)");
  CHECK(count == 1);  // facade and ground meet; isolated points are too few each
}

TEST_CASE("components__of_the_points_with_a_value__the_others_0_and_no_bridge") {
  // Two blobs, and a string of points of another value between them.
  std::vector<Vec3> points;
  std::vector<uint8_t> changed;
  for (int i = 0; i < 60; ++i) {
    points.push_back({0.5 * i, 0.5, 0.5});
    changed.push_back(i < 20 || i >= 45);
  }
  Cloud cloud = cloud_of(points);
  cloud.fields.set(make_column<uint8_t>({"changed", ElementType::kUint8, 1, "", ""}, changed));
  ComponentsSettings set;
  set.cell_m = 1;
  Task task;
  uint64_t count = 0;
  CHECK(with_components(cloud, set, task, count).size() == 60);
  CHECK(count == 1);
  set.field = "changed";
  const Cloud out = with_components(cloud, set, task, count);
  CHECK(count == 2);
  const auto labels = out.fields.require("component").values<uint32_t>();
  CHECK(labels[0] == 1);
  CHECK(labels[30] == 0);
  CHECK(labels[59] == 2);
  set.value = 7;
  CHECK(with_components(cloud, set, task, count).size() == 60);
  CHECK(count == 0);
  set.field = "no such";
  CHECK(status_of([&] { with_components(cloud, set, task, count); }) == Status::kNotFound);
}

TEST_CASE("components__by_level_threads_and_shift__the_same_labels") {
  const auto points = random_points(50000, 20, 9);
  ComponentsSettings set;
  Task one(threads(1)), seven(threads(7));
  uint64_t a = 0, b = 0, c = 0;
  for (const int level : {-1, 5, 7}) {
    set.level = level;
    set.cell_m = 0.4;
    const Cloud near = with_components(cloud_of(points), set, one, a);
    CHECK(same_bits(near, with_components(cloud_of(points), set, seven, b)));
    CHECK(same_fields(near, with_components(cloud_of(shifted(points, kFar)), set, one, c)));
    CHECK(a == b);
    CHECK(a == c);
  }
}

}  // namespace
}  // namespace jalon
