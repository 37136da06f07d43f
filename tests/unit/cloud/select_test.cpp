// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/select.h"

#include <doctest/doctest.h>

#include <numeric>
#include <vector>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

/// n points along x with a field of every element size that has a path of its own.
Cloud numbered(size_t n) {
  std::vector<Vec3> points;
  for (size_t i = 0; i < n; ++i) points.push_back({static_cast<double>(i), 1, 2});
  Cloud cloud = cloud_of(points);
  const auto add = [&](auto zero, const char* name, uint32_t components) {
    using T = decltype(zero);
    std::vector<T> values(n * components);
    for (size_t i = 0; i < values.size(); ++i) values[i] = static_cast<T>(i % 100);
    cloud.fields.set(make_column<T>({name, element_type_of<T>(), components, "", ""},
                                    std::span<const T>(values)));
  };
  add(uint8_t{}, "one", 1), add(int16_t{}, "two", 1), add(float{}, "four", 1);
  add(double{}, "eight", 1), add(float{}, "twelve", 3), add(double{}, "twenty-four", 3);
  add(int16_t{}, "ten", 5);
  return cloud;
}

TEST_CASE("select__every_field_follows_its_point_in_any_order_and_with_repeats") {
  const Cloud cloud = numbered(50);
  const std::vector<uint64_t> indices = {49, 0, 7, 7, 20};
  Task task;
  const Cloud out = select_unchecked(cloud, indices, task);
  REQUIRE(out.size() == 5);
  REQUIRE(out.fields.size() == cloud.fields.size());
  for (size_t i = 0; i < indices.size(); ++i) {
    CHECK(out.point(i) == cloud.point(indices[i]));
    for (const ColumnPtr& column : cloud.fields)
      for (uint32_t c = 0; c < column->info().components; ++c)
        CHECK(out.fields.require(column->info().name).number(i, c) ==
              column->number(indices[i], c));
  }
}

TEST_CASE("select__stations_stay_only_where_their_points_stay_together") {
  Cloud cloud = numbered(9);
  cloud.stations = {{"A", true, Transform(), 0, 3},
                    {"B", true, Transform(), 3, 3},
                    {"C", true, Transform(), 6, 3}};
  Task task;
  const auto kept = [&](const std::vector<uint64_t>& indices) {
    return select_unchecked(cloud, indices, task).stations;
  };
  const auto torn = kept({0, 3, 1, 8});  // A is torn apart by a point of B
  REQUIRE(torn.size() == 2);
  CHECK(torn[0].name == "B");
  CHECK(torn[0].first == 1);
  CHECK(torn[0].count == 1);
  CHECK(torn[1].name == "C");
  const auto turned = kept({7, 6, 4, 5});
  REQUIRE(turned.size() == 2);
  CHECK(turned[0].name == "C");
  CHECK(turned[0].count == 2);
  CHECK(turned[1].name == "B");
  CHECK(turned[1].first == 2);
}

TEST_CASE("select_kept__of_all_points_shares_them_and_their_index") {
  const Cloud cloud = numbered(10);
  std::vector<uint64_t> all(10);
  std::iota(all.begin(), all.end(), uint64_t{0});
  Task task;
  const Cloud same = select_kept(cloud, all, task);
  CHECK(same.xyz_buffer == cloud.xyz_buffer);
  CHECK(same.index == cloud.index);
  all.pop_back();
  const Cloud fewer = select_kept(cloud, all, task);
  CHECK(fewer.size() == 9);
  CHECK(fewer.index != cloud.index);
}

TEST_CASE("indices_of__are_where_the_mask_has_the_value_over_many_chunks") {
  std::vector<uint8_t> mask(200000);
  RandomStream random(7, 0);
  for (uint8_t& byte : mask) byte = static_cast<uint8_t>(random.below(3));
  for (const uint8_t value : {uint8_t{0}, uint8_t{2}, uint8_t{9}}) {
    std::vector<uint64_t> expected;
    for (size_t i = 0; i < mask.size(); ++i)
      if (mask[i] == value) expected.push_back(i);
    Task one(threads(1)), four(threads(4));
    CHECK(indices_of(mask, value, one) == expected);
    CHECK(indices_of(mask, value, four) == expected);
  }
  Task task;
  CHECK(indices_of({}, 0, task).empty());
}

TEST_CASE("select__refuses_an_index_behind_the_end") {
  Task task;
  const std::vector<uint64_t> indices = {0, 10};
  CHECK(status_of([&] { select(numbered(10), indices, task); }) == Status::kInvalidArgument);
}

}  // namespace
}  // namespace jalon
