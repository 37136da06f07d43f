// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/records.h"

#include <doctest/doctest.h>

#include "formats/files/endian.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("las_records__any_part_of_a_cloud_is_told_like_the_whole_and_tallies_add_up") {
  constexpr size_t kPoints = 1000, kCut = 333;
  Cloud cloud = random_points(kPoints, 9);
  RandomStream random(9, 2);
  cloud.fields.set(random_column("intensity", ElementType::kUint16, 1, kPoints, random));
  Task task;
  const las::Plan plan = las::make_plan(cloud, "a.las", {}, task);
  const auto told = [&](size_t first, size_t n, las::Tally& tally) {
    std::vector<std::byte> records(n * plan.record_bytes);
    tally += las::put_points(plan, cloud, records.data(), first, n);
    return records;
  };
  las::Tally whole, parts;
  const std::vector<std::byte> all = told(0, kPoints, whole);
  std::vector<std::byte> joined = told(0, kCut, parts);
  const std::vector<std::byte> rest = told(kCut, kPoints - kCut, parts);
  joined.insert(joined.end(), rest.begin(), rest.end());
  CHECK(joined == all);
  CHECK(parts.min == whole.min);
  CHECK(parts.max == whole.max);
  CHECK(parts.by_return == whole.by_return);
  CHECK(whole.by_return[0] == kPoints);
  const auto intensity = cloud.fields.require("intensity").values<uint16_t>();
  for (size_t i = 0; i < kPoints; ++i) {
    const std::byte* record = all.data() + i * plan.record_bytes;
    CHECK(load<uint16_t>(record + 12) == intensity[i]);
    CHECK(std::fabs(load<int32_t>(record) * plan.scale.x + plan.offset.x - cloud.point(i).x) <=
          0.50001 * plan.scale.x);
  }
}
