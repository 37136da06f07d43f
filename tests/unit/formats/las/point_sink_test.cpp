// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/point_sink.h"

#include <doctest/doctest.h>

#include "formats/files/endian.h"

using namespace jalon;
using namespace jalon::las;

namespace {

Header header_of_format_0() {
  Header header;
  header.format = 0;
  header.record_bytes = 20;
  header.scale = {0.5, 0.25, 2};
  header.offset = {100, 200, 300};
  return header;
}

std::vector<std::byte> record_of_point(int32_t x, int32_t y, int32_t z, uint16_t intensity,
                                       unsigned returns) {
  std::vector<std::byte> record(20);
  store<int32_t>(record.data(), x);
  store<int32_t>(record.data() + 4, y);
  store<int32_t>(record.data() + 8, z);
  store<uint16_t>(record.data() + 12, intensity);
  store<uint8_t>(record.data() + 14, static_cast<uint8_t>(returns));
  return record;
}

}  // namespace

TEST_CASE("point_sink__a_record_lies_at_its_steps_in_metres") {
  const Header header = header_of_format_0();
  const auto record = record_of_point(3, -4, 5, 0, 0);
  CHECK(place_of(header, {1, 1, 1}, record.data()) == Vec3{101.5, 199, 310});
  CHECK(place_of(header, {2, 2, 0.5}, record.data()) == Vec3{203, 398, 155});
}

TEST_CASE("point_sink__records_that_come_in_any_order_stand_at_their_numbers") {
  const Header header = header_of_format_0();
  PointSink sink(header, {1, 1, 1}, dimensions(0), {}, 2);
  sink.put(record_of_point(2, 0, 0, 70, 0x12).data(), 1, 1);
  sink.put(record_of_point(1, 0, 0, 60, 0x09).data(), 1, 0);
  const Cloud cloud = sink.cloud();
  REQUIRE(cloud.size() == 2);
  CHECK(cloud.point(0) == Vec3{100.5, 200, 300});
  CHECK(cloud.point(1) == Vec3{101, 200, 300});
  const auto intensity = cloud.fields.require("intensity").values<uint16_t>();
  CHECK(intensity[0] == 60);
  CHECK(intensity[1] == 70);
  const auto returns = cloud.fields.require("return_number").values<uint8_t>();
  CHECK(returns[0] == 1);
  CHECK(returns[1] == 2);
}
