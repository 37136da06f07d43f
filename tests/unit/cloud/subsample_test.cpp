// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <chrono>
#include <map>
#include <set>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

SubsampleSettings sampling(const char* method) {
  return settings_by<SubsampleSettings>(subsample_rows(), {{"method", method}});
}

/// A cloud whose field "number" tells which point is which.
Cloud numbered(const std::vector<Vec3>& points) {
  Cloud cloud = cloud_of(points);
  std::vector<uint32_t> numbers(points.size());
  for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<uint32_t>(i);
  cloud.fields.set(make_column<uint32_t>({"number", ElementType::kUint32, 1, "", ""}, numbers));
  return cloud;
}

using Cell = std::array<int64_t, 3>;
Cell cell_of(const Vec3& p, double size) {
  return {static_cast<int64_t>(std::floor(p.x / size)),
          static_cast<int64_t>(std::floor(p.y / size)),
          static_cast<int64_t>(std::floor(p.z / size))};
}

TEST_CASE("subsample__voxel__one_centroid_a_cell_with_the_fields_of_a_point_of_the_cell") {
  const auto points = random_points(20000, 8, 61);  // the cube's origin is 0
  const Cloud cloud = numbered(points);
  SubsampleSettings set = sampling("voxel");
  set.cell_m = 0.7;
  Task task;
  const Cloud out = subsampled(cloud, set, task);
  std::map<Cell, std::pair<Vec3, int>> truth;
  for (const Vec3& p : points) {
    auto& [sum, n] = truth[cell_of(p, 0.7)];
    sum += p;
    ++n;
  }
  REQUIRE(out.size() == truth.size());
  const auto number = out.fields.require("number").values<uint32_t>();
  for (size_t i = 0; i < out.size(); ++i) {
    const auto& [sum, n] = truth.at(cell_of(points[number[i]], 0.7));
    CHECK(norm(out.point(i) - sum / n) < 1e-9);
    if (i > 0) CHECK(number[i - 1] < number[i]);
  }
}

TEST_CASE("subsample__voxel__a_cloud_without_fields_gives_the_same_centroids") {
  const auto points = random_points(20000, 8, 61);
  SubsampleSettings set = sampling("voxel");
  set.cell_m = 0.7;
  Task task;
  const auto sorted = [](const Cloud& cloud) {
    std::set<std::array<double, 3>> out;
    for (size_t i = 0; i < cloud.size(); ++i)
      out.insert({cloud.point(i).x, cloud.point(i).y, cloud.point(i).z});
    return out;
  };
  const Cloud bare = subsampled(cloud_of(points), set, task);
  CHECK(bare.fields.size() == 0);
  CHECK(sorted(bare) == sorted(subsampled(numbered(points), set, task)));
  set.cell_m = 1e-5;  // every point alone: the same points, not copies of them
  const Cloud all = cloud_of(points);
  CHECK(subsampled(all, set, task).xyz_buffer == all.xyz_buffer);
}

TEST_CASE("subsample__nearest__gives_original_points_nearest_to_the_cell_centres") {
  const auto points = random_points(5000, 8, 62);
  Task task;
  for (const char* method : {"voxel", "octree"}) {
    SubsampleSettings set = sampling(method);
    set.keep = Keep::kNearest;
    set.cell_m = 1;
    set.level = 3;  // a cube of 8 m: cells of 1 m
    const Cloud out = subsampled(numbered(points), set, task);
    const auto number = out.fields.require("number").values<uint32_t>();
    std::set<Cell> cells;
    for (size_t i = 0; i < out.size(); ++i) {
      CHECK(out.point(i) == points[number[i]]);
      const Cell cell = cell_of(out.point(i), 1);
      cells.insert(cell);
      const Vec3 centre{double(cell[0]) + 0.5, double(cell[1]) + 0.5, double(cell[2]) + 0.5};
      for (const Vec3& p : points)
        if (cell_of(p, 1) == cell) CHECK(norm(p - centre) >= norm(out.point(i) - centre));
    }
    CHECK(cells.size() == out.size());
  }
}

TEST_CASE("subsample__octree__the_deepest_level_within_the_budget") {
  const Cloud cloud = cloud_of(random_points(20000, 8, 63));
  Task task;
  SubsampleSettings set = sampling("octree");
  for (const int64_t budget : {1, 7, 500, 1000000}) {
    set.max_points = budget;
    const Cloud out = subsampled(cloud, set, task);
    CHECK(out.size() <= static_cast<size_t>(budget));
    CHECK(out.size() >= 1);
  }
  set.max_points = 1000000;
  CHECK(subsampled(cloud, set, task).size() > 19900);
}

TEST_CASE("subsample__minimum_distance__no_two_kept_closer_and_every_removed_one_within_it") {
  const auto points = random_points(6000, 3, 64);
  const double d = 0.2;
  SubsampleSettings set = sampling("minimum_distance");
  set.distance_m = d;
  Task task;
  const Cloud out = subsampled(numbered(points), set, task);
  std::vector<uint8_t> kept(points.size(), 0);
  for (const uint32_t i : out.fields.require("number").values<uint32_t>()) kept[i] = 1;
  CHECK(kept[0] == 1);
  size_t closer = 0, uncovered = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    bool covered = false;
    for (size_t j = 0; j < points.size(); ++j) {
      if (i == j || !kept[j] || norm(points[i] - points[j]) > d) continue;
      covered = true;
      closer += kept[i];
    }
    uncovered += !kept[i] && !covered;
  }
  CHECK(closer == 0);
  CHECK(uncovered == 0);
  CHECK(out.size() < points.size());
}

TEST_CASE("subsample__random__exact_number_in_order_by_seed_and_even") {
  const Cloud cloud = numbered(random_points(100000, 5, 65));
  Task task;
  SubsampleSettings set = sampling("random");
  set.fraction = 0.25;
  const Cloud quarter = subsampled(cloud, set, task);
  CHECK(quarter.size() == 25000);
  const auto number = quarter.fields.require("number").values<uint32_t>();
  CHECK(std::is_sorted(number.begin(), number.end()));
  // Each tenth of the cloud gives a tenth of the choice, within five standard deviations.
  std::vector<double> tenths(10, 0);
  for (const uint32_t i : number) ++tenths[i / 10000];
  for (const double n : tenths) CHECK(std::fabs(n - 2500) < 5 * std::sqrt(2500 * 0.75));
  CHECK(same_bits(subsampled(cloud, set, task), quarter));
  set.seed = 2;
  CHECK_FALSE(same_bits(subsampled(cloud, set, task), quarter));
  set.count = 7;
  CHECK(subsampled(cloud, set, task).size() == 7);
  set.count = 100001;
  CHECK(subsampled(cloud, set, task).size() == 100000);
  set.count = 0;
  set.fraction = 0;
  CHECK(subsampled(cloud, set, task).size() == 0);
}

TEST_CASE("subsample__threads_and_shift__the_same_choice") {
  const auto points = random_points(40000, 6, 66);
  Task one(threads(1)), seven(threads(7));
  for (const char* method : {"voxel", "minimum_distance", "random", "octree"}) {
    CAPTURE(method);
    SubsampleSettings set = sampling(method);
    set.cell_m = 0.25;
    set.distance_m = 0.25;
    set.max_points = 5000;
    const Cloud near = subsampled(numbered(points), set, one);
    CHECK(same_bits(near, subsampled(numbered(points), set, seven)));
    const Cloud far = subsampled(numbered(shifted(points, kFar)), set, one);
    CHECK(same_fields(near, far));
    for (size_t i = 0; i < near.size(); i += 101)
      CHECK(norm(near.point(i) + kFar - far.point(i)) < 1e-8);
  }
}

TEST_CASE("subsample__stations_stay") {
  auto points = random_points(20000, 6, 67);
  Cloud cloud = cloud_of(points);
  cloud.stations = {{"A", true, Transform(), 0, 10000}, {"B", true, Transform(), 10000, 10000}};
  Task task;
  SubsampleSettings set = sampling("voxel");
  set.cell_m = 0.5;
  const Cloud out = subsampled(cloud, set, task);
  REQUIRE(out.stations.size() == 2);
  CHECK(out.stations[0].count + out.stations[1].count == out.size());
}

TEST_CASE("subsample__a_million_points__figures") {
  const Cloud cloud = cloud_of(random_points(1000000, 20, 68));
  for (const char* method : {"voxel", "minimum_distance", "random", "octree"}) {
    Task task;
    const auto start = std::chrono::steady_clock::now();
    const Cloud out = subsampled(cloud, sampling(method), task);
    MESSAGE(std::string(method), ": 1 M points -> ", out.size(), " in ",
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), " s");
    CHECK(out.size() > 0);
  }
}

}  // namespace
}  // namespace jalon
