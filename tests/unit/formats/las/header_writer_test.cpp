// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/header_writer.h"

#include <doctest/doctest.h>

#include "unit/formats/fixtures.h"
#include "unit/formats/las/las_bytes.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("las_header__tells_place_size_and_extent_of_what_was_written") {
  Task task;
  const Cloud cloud = random_points(7, 1);
  const las::Plan plan = las::make_plan(cloud, "a.las", {}, task);
  las::Written written{{}, 7 * plan.record_bytes};
  written.tally.min = {-3, -2, -1};
  written.tally.max = {1, 2, 3};
  written.tally.by_return[2] = 5;
  const auto header = las::header_bytes(plan, written, 7, false);
  const std::string bytes(reinterpret_cast<const char*>(header.data()), header.size());
  REQUIRE(bytes.size() == las::header_size(plan));
  CHECK(get_at<uint32_t>(bytes, 96) == las::point_offset_of(plan));
  CHECK(get_at<uint16_t>(bytes, 105) == plan.record_bytes);
  CHECK(get_at<uint32_t>(bytes, 107) == 7);
  CHECK(get_at<uint32_t>(bytes, 115) == 5);  // of second returns
  CHECK(get_at<double>(bytes, 179) == plan.offset.x + 1 * plan.scale.x);
  CHECK(get_at<double>(bytes, 187) == plan.offset.x - 3 * plan.scale.x);
  CHECK(static_cast<unsigned char>(las::header_bytes(plan, written, 7, true)[104]) ==
        (plan.format | 0x80u));
}
