// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

/// A wall of n points and m isolated ones, in turn; "isolated" marks the latter.
Cloud wall_with_outliers(size_t n, size_t m) {
  RandomStream random(51, 0);
  std::vector<Vec3> points;
  std::vector<uint8_t> isolated;
  for (size_t i = 0; i < n; ++i) {
    points.push_back({10 * random.uniform(), 0.003 * random.normal(), 6 * random.uniform()});
    isolated.push_back(0);
    if (i % (n / m) != 0) continue;
    points.push_back({10 * random.uniform(), 1 + 8 * random.uniform(), 6 * random.uniform()});
    isolated.push_back(1);
  }
  Cloud cloud = cloud_of(points);
  cloud.fields.set(make_column<uint8_t>({"isolated", ElementType::kUint8, 1, "", ""}, isolated));
  return cloud;
}

struct Outcome {
  double kept_wall, removed_isolated;
};
Outcome outcome(const Cloud& in, const Cloud& out) {
  const auto count = [](const Cloud& cloud, uint8_t value) {
    const auto values = cloud.fields.require("isolated").values<uint8_t>();
    return static_cast<double>(std::count(values.begin(), values.end(), value));
  };
  return {count(out, 0) / count(in, 0), 1 - count(out, 1) / count(in, 1)};
}

TEST_CASE("outliers__both_methods__drop_isolated_points_and_keep_the_wall") {
  const Cloud cloud = wall_with_outliers(60000, 300);
  Task task;
  for (const char* method : {"statistical", "radius"}) {
    const auto set = settings_by<OutliersSettings>(outliers_rows(), {{"method", method}});
    const Outcome o = outcome(cloud, without_outliers(cloud, set, task));
    MESSAGE(std::string(method), ": wall kept ", o.kept_wall, ", isolated removed ",
            o.removed_isolated);
    CHECK(o.kept_wall > 0.995);
    CHECK(o.removed_isolated > 0.95);
  }
}

TEST_CASE("outliers__radius__counts_the_others_in_the_closed_ball") {
  Task task;
  OutliersSettings set;
  set.method = OutliersSettings::Method::kRadius;
  set.radius_m = 1;
  set.neighbours = 2;
  // Points at 0, 1, 2, 10 on a line: only the one at 1 has two others within 1 m.
  const Cloud cloud = cloud_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {10, 0, 0}});
  const Cloud out = without_outliers(cloud, set, task);
  REQUIRE(out.size() == 1);
  CHECK(out.point(0).x == 1);
  set.neighbours = 200;
  CHECK(without_outliers(cloud, set, task).size() == 0);
}

TEST_CASE("outliers__few_or_equal_points__stay") {
  Task task;
  const OutliersSettings set{};
  CHECK(without_outliers(cloud_of({{1, 2, 3}}), set, task).size() == 1);
  CHECK(without_outliers(cloud_of(std::vector<Vec3>(40, Vec3{1, 2, 3})), set, task).size() == 40);
}

TEST_CASE("outliers__threads_and_shift__the_same_choice") {
  const auto points = random_points(30000, 5, 52);
  Task one(threads(1)), seven(threads(7));
  const OutliersSettings set{};
  const Cloud near = without_outliers(cloud_of(points), set, one);
  CHECK(same_bits(near, without_outliers(cloud_of(points), set, seven)));
  CHECK(same_bits(cloud_of([&] {
                    std::vector<Vec3> moved;
                    for (size_t i = 0; i < near.size(); ++i) moved.push_back(near.point(i) + kFar);
                    return moved;
                  }()),
                  without_outliers(cloud_of(shifted(points, kFar)), set, seven)));
}

}  // namespace
}  // namespace jalon
