// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/cloud.h"

#include <doctest/doctest.h>

#include <atomic>
#include <numeric>
#include <thread>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

Cloud two_stations() {
  Cloud cloud = cloud_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}});
  cloud.stations.resize(2);
  cloud.stations[0] = {"A", true, Transform(), 0, 2};
  cloud.stations[1] = {"B", true, Transform{{1, 0, 0, 10, 0, 1, 0, 20, 0, 0, 1, 30}}, 2, 4};
  cloud.fields.set(make_column<float>({"intensity", ElementType::kFloat32, 1, "", ""},
                                      std::vector<float>{0, 10, 20, 30, 40, 50}));
  cloud.crs = "EPSG:2154";
  return cloud;
}

TEST_CASE("require_finite__names_the_first_bad_coordinate") {
  std::vector<double> xyz(30000, 1.0);
  require_finite(xyz);
  xyz[3 * 7000 + 1] = NAN;
  xyz[3 * 9000] = INFINITY;
  try {
    require_finite(xyz);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kInvalidArgument);
    CHECK(std::string(error.what()) == "point 7000: y is nan, not a finite number");
  }
}

TEST_CASE("bounds__of_none_is_empty_else_tight") {
  Task task;
  CHECK(bounds(Cloud(), task).empty());
  const Box3 box = bounds(cloud_of({{1, 5, -2}, {3, 2, 7}}), task);
  CHECK(box.min == Vec3{1, 2, -2});
  CHECK(box.max == Vec3{3, 5, 7});
}

TEST_CASE("station_of__finds_the_station_or_none") {
  Cloud cloud = two_stations();
  CHECK(station_of(cloud, 1)->name == "A");
  CHECK(station_of(cloud, 2)->name == "B");
  CHECK(station_of(cloud, 5)->name == "B");
  CHECK(station_of(cloud, 6) == nullptr);
  cloud.stations.insert(cloud.stations.begin() + 1, Station{"empty", false, Transform(), 2, 0});
  CHECK(station_of(cloud, 1)->name == "A");
  CHECK(station_of(cloud, 2)->name == "B");
  cloud.stations.erase(cloud.stations.begin());
  CHECK(station_of(cloud, 1) == nullptr);
}

TEST_CASE("select__points_fields_and_whole_stations_follow") {
  Task task;
  const Cloud cloud = two_stations();
  const Cloud some = select(cloud, std::vector<uint64_t>{0, 3, 5, 4}, task);
  REQUIRE(some.size() == 4);
  CHECK(some.point(3) == Vec3{4, 0, 0});
  CHECK(some.fields.require("intensity").number(2) == 50);
  REQUIRE(some.stations.size() == 2);
  CHECK(some.stations[1].first == 1);
  CHECK(some.stations[1].count == 3);
  CHECK(some.crs == "EPSG:2154");
  // B A B: B is torn apart and goes, A stays.
  const Cloud torn = select(cloud, std::vector<uint64_t>{2, 0, 3}, task);
  REQUIRE(torn.stations.size() == 1);
  CHECK(torn.stations[0].name == "A");
  CHECK(torn.stations[0].first == 1);
  CHECK(select(cloud, {}, task).size() == 0);
  CHECK(status_of([&] {
          select(cloud, std::vector<uint64_t>{1, 6}, task);
        }) == Status::kInvalidArgument);
}

TEST_CASE("select_mask__both_parts_make_up_the_cloud_and_all_shares_it") {
  Task task;
  const Cloud cloud = two_stations();
  const std::vector<uint8_t> mask{1, 0, 1, 0, 0, 1}, all(6, 1);
  CHECK(select_mask(cloud, mask, 1, task).size() == 3);
  CHECK(select_mask(cloud, mask, 0, task).size() == 3);
  CHECK(select_mask(cloud, all, 1, task).xyz_buffer == cloud.xyz_buffer);
  CHECK(select_mask(cloud, all, 0, task).size() == 0);
}

TEST_CASE("append__fills_missing_fields_shifts_stations_and_checks_the_crs") {
  Task task;
  const Cloud a = two_stations();
  Cloud b = cloud_of({{9, 9, 9}});
  b.fields.set(
      make_column<uint8_t>({"class", ElementType::kUint8, 1, "", ""}, std::vector<uint8_t>{7}));
  b.stations.push_back({"C", false, Transform(), 0, 1});
  const Cloud both = append(a, b, task);
  REQUIRE(both.size() == 7);
  CHECK(both.point(6) == Vec3{9, 9, 9});
  CHECK(std::isnan(both.fields.require("intensity").number(6)));
  CHECK(both.fields.require("class").number(0) == 0);
  CHECK(both.fields.require("class").number(6) == 7);
  CHECK(both.stations[2].first == 6);
  CHECK(both.crs == "EPSG:2154");
  b.crs = "EPSG:32631";
  CHECK(status_of([&] { append(a, b, task); }) == Status::kInvalidArgument);
}

TEST_CASE("append__fields_of_other_type_widen_of_other_shape_are_refused") {
  Task task;
  Cloud a = cloud_of({{0, 0, 0}}), b = cloud_of({{1, 1, 1}});
  a.fields.set(
      make_column<uint8_t>({"f", ElementType::kUint8, 1, "", ""}, std::vector<uint8_t>{200}));
  b.fields.set(
      make_column<int16_t>({"f", ElementType::kInt16, 1, "", ""}, std::vector<int16_t>{-5}));
  const Cloud both = append(a, b, task);
  CHECK(both.fields.require("f").number(0) == 200);
  CHECK(both.fields.require("f").number(1) == -5);
  b.fields.set(
      make_column<int16_t>({"f", ElementType::kInt16, 2, "", ""}, std::vector<int16_t>{1, 2}));
  CHECK(status_of([&] { append(a, b, task); }) == Status::kInvalidArgument);
}

TEST_CASE("transformed__and_back__is_the_same_within_rounding_and_moves_poses_and_normals") {
  Task task;
  Cloud cloud = two_stations();
  cloud.fields.set(
      make_column<float>({"normal", ElementType::kFloat32, 3, "", ""},
                         std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0}));
  const double c = std::cos(0.3), s = std::sin(0.3);
  const Transform turn{{c, -s, 0, 100, s, c, 0, 200, 0, 0, 1, 5}};
  const Cloud moved = transformed(cloud, turn, task);
  CHECK(moved.fields.require("normal").number(0, 1) == doctest::Approx(s));
  CHECK(moved.stations[1].pose.translation().x == doctest::Approx(turn.point({10, 20, 30}).x));
  const Cloud back = transformed(moved, inverse(turn), task);
  for (size_t i = 0; i < cloud.size(); ++i) CHECK(norm(back.point(i) - cloud.point(i)) < 1e-12);
  CHECK(status_of([&] {
          transformed(cloud, Transform{{1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}}, task);
        }) == Status::kInvalidArgument);
}

TEST_CASE("index__many_threads_at_once__one_tree") {
  const Cloud cloud = cloud_of(random_points(200000, 10, 3));
  std::vector<std::shared_ptr<const Octree>> trees(8);
  std::vector<std::thread> threads;
  for (auto& tree : trees)
    threads.emplace_back([&] {
      Task task(test::threads(2));
      tree = cloud.octree(task);
    });
  for (auto& thread : threads) thread.join();
  for (const auto& tree : trees) CHECK(tree == trees[0]);
  CHECK(trees[0]->size() == cloud.size());
}

TEST_CASE("index__builder_cancelled__a_waiting_thread_takes_over") {
  const Cloud cloud = cloud_of(random_points(500000, 10, 4));
  std::atomic<bool> cancel{true};
  std::atomic<int> failed{0}, built{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 6; ++i)
    threads.emplace_back([&, i] {
      Task::Hooks hooks;
      hooks.threads = 1;
      if (i % 2 == 0) hooks.cancel = &cancel;
      Task task(hooks);
      try {
        cloud.octree(task);
        ++built;
      } catch (const Error&) {
        ++failed;
      }
    });
  for (auto& thread : threads) thread.join();
  CHECK(built + failed == 6);
  CHECK(built >= 3);
}

TEST_CASE("index__get_on_another_cube__replaces_the_tree") {
  Task task;
  const Cloud cloud = cloud_of(random_points(1000, 10, 5));
  const auto first = cloud.octree(task);
  CHECK(cloud.index->get_on(cloud.xyz(), first->cube(), task) == first);
  const Cube larger{{-32, -32, -32}, 64};
  const auto second = cloud.index->get_on(cloud.xyz(), larger, task);
  CHECK(second->cube() == larger);
  CHECK(cloud.octree(task) == second);
  CHECK(first->size() == 1000);  // still usable
}

TEST_CASE("empty_cloud__every_operation_gives_its_documented_answer") {
  Task task;
  const Cloud empty;
  CHECK(with_normals(empty, NormalsSettings{}, task).fields.size() == 1);
  CHECK(with_features(empty, FeaturesSettings{}, task).fields.require("density").count() == 0);
  uint64_t count = 9;
  with_components(empty, ComponentsSettings{}, task, count);
  CHECK(count == 0);
  CHECK(without_duplicates(empty, 1e-4, task).size() == 0);
  CHECK(without_outliers(empty, OutliersSettings{}, task).size() == 0);
  CHECK(subsampled(empty, SubsampleSettings{}, task).size() == 0);
  CHECK(append(empty, empty, task).size() == 0);
  CHECK(transformed(empty, Transform(), task).size() == 0);
  CHECK(status_of([&] { points_of_interest(empty, InterestSettings{}, task); }) ==
        Status::kInsufficientData);
}

}  // namespace
}  // namespace jalon
