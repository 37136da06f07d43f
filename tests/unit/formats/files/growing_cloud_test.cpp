// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/growing_cloud.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "geometry/rotation.h"

using namespace jalon;

TEST_CASE("growing_cloud__points_over_several_blocks_keep_order_fields_and_stations") {
  constexpr size_t kPoints = 70000;  // more than two blocks of 32768 points
  GrowingCloud grown;
  Transform pose;
  pose.m[3] = 5;
  grown.begin_station("a", &pose);
  const size_t row = grown.field({"row", ElementType::kUint32, 1, "", ""});
  size_t late = 0;
  for (size_t i = 0; i < kPoints; ++i) {
    if (i == 40000) {
      late = grown.field({"late", ElementType::kFloat32, 1, "", ""});
      grown.begin_station("b", nullptr);
    }
    const auto number = static_cast<double>(i);
    const size_t numbers[] = {row, late};
    const double values[] = {number, number / 2};
    const size_t used = i < 40000 || i % 2 == 1 ? 1 : 2;
    grown.add({number, -number, 0.1}, std::span(numbers).first(used),
              std::span(values).first(used));
  }
  CHECK(grown.field({"row", ElementType::kFloat64, 1, "", ""}) == row);
  Task task;
  const Cloud cloud = grown.finish(task);
  REQUIRE(cloud.size() == kPoints);
  REQUIRE(cloud.stations.size() == 2);
  CHECK(cloud.stations[0].has_pose);
  CHECK(cloud.stations[0].pose.m[3] == 5);
  CHECK(cloud.stations[1].first == 40000);
  CHECK(cloud.stations[1].count == kPoints - 40000);
  CHECK_FALSE(cloud.stations[1].has_pose);
  size_t wrong = 0;
  const auto rows = cloud.fields.require("row").values<uint32_t>();
  const auto lates = cloud.fields.require("late").values<float>();
  for (size_t i = 0; i < kPoints; ++i) {
    const auto number = static_cast<double>(i);
    const bool has_late = i >= 40000 && i % 2 == 0;
    wrong += cloud.point(i) == Vec3{number, -number, 0.1} && rows[i] == i &&
                     (has_late ? lates[i] == static_cast<float>(number / 2) : std::isnan(lates[i]))
                 ? 0
                 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("growing_cloud__points_put_in_any_order_stand_where_they_were_put") {
  constexpr size_t kPoints = 70000;
  GrowingCloud grown;
  const size_t early = grown.field({"early", ElementType::kFloat32, 1, "", ""});
  const size_t row = grown.field({"row", ElementType::kInt16, 1, "", ""});
  const size_t both[] = {early, row};
  const double values[] = {1, 2};
  grown.add({-1, -2, -3}, both, values);
  grown.begin_station("a", nullptr);
  REQUIRE(grown.extend(kPoints, std::span(both).last(1)) == 1);
  for (const size_t begin : {size_t{33000}, size_t{0}}) {
    const size_t end = begin == 0 ? 33000 : kPoints;
    std::vector<double> xyz, rows;
    for (size_t i = begin; i < end; ++i) {
      for (int k = 0; k < 3; ++k) xyz.push_back(static_cast<double>(3 * i) + k);
      rows.push_back(static_cast<double>(i));
    }
    grown.put(1 + begin, xyz);
    grown.put_field(row, 1 + begin, rows);
  }
  Task task;
  const Cloud cloud = grown.finish(task);
  REQUIRE(cloud.size() == kPoints + 1);
  CHECK(cloud.stations[0].first == 1);
  CHECK(cloud.stations[0].count == kPoints);
  CHECK(cloud.point(0) == Vec3{-1, -2, -3});
  const auto rows = cloud.fields.require("row").values<int16_t>();
  const auto earlies = cloud.fields.require("early").values<float>();
  CHECK(earlies[0] == 1);
  size_t wrong = 0;
  for (size_t i = 0; i < kPoints; ++i) {
    const auto x = static_cast<double>(3 * i);
    wrong += cloud.point(i + 1) == Vec3{x, x + 1, x + 2} && std::isnan(earlies[i + 1]) &&
                     rows[i + 1] == static_cast<int>(std::min<size_t>(i, 32767))
                 ? 0
                 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("growing_cloud__integers_take_the_nearest_number_that_they_hold") {
  GrowingColumn column({"a", ElementType::kUint8, 1, "", ""}, 1);
  for (const double value : {-3.0, 2.4, 254.6, 1e9, std::nan("")}) column.add(value);
  GrowingColumn large({"b", ElementType::kInt64, 1, "", ""}, 0);
  for (const double value : {-1e30, 1e30, -7.0}) large.add(value);
  uint8_t bytes[6];
  int64_t numbers[3];
  Task task;
  column.move_to(bytes, task);
  large.move_to(numbers, task);
  CHECK(std::vector<uint8_t>(bytes, bytes + 6) == std::vector<uint8_t>{0, 0, 2, 255, 255, 0});
  CHECK(numbers[0] == std::numeric_limits<int64_t>::min());
  CHECK(numbers[1] == std::numeric_limits<int64_t>::max());
  CHECK(numbers[2] == -7);
}

TEST_CASE("growing_cloud__a_pose_of_few_digits_becomes_the_rotation_beside_it_and_a_scale_none") {
  const Matrix3 turn = rotation_zyx({0.3, -0.7, 2.1});
  Transform pose;
  for (size_t i = 0; i < 9; ++i) pose.m[4 * (i / 3) + i % 3] = std::round(turn.m[i] * 1e6) / 1e6;
  pose.m[7] = 1234567.25;
  REQUIRE(make_rigid(pose, 1e-3));
  CHECK(pose.m[7] == 1234567.25);
  for (size_t i = 0; i < 9; ++i) CHECK(std::fabs(pose.m[4 * (i / 3) + i % 3] - turn.m[i]) < 2e-6);
  CHECK(std::fabs(pose.determinant() - 1) < 1e-12);
  Transform scaled;
  scaled.m[0] = scaled.m[5] = scaled.m[10] = 1.01;
  CHECK_FALSE(make_rigid(scaled, 1e-3));
  Transform mirrored;
  mirrored.m[10] = -1;
  CHECK_FALSE(make_rigid(mirrored, 1e-3));
  Transform none;
  none.m[0] = std::nan("");
  CHECK_FALSE(make_rigid(none, 1e-3));
}
