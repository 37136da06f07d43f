// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Descriptors of extra bytes (ASPRS LAS 1.4 R15, tables 24 and 25): there and back, and as other programs write them.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "formats/las/layout.h"
#include "unit/formats/kept_log.h"
#include "unit/formats/las/las_bytes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Descriptor = std::vector<std::byte>;

Descriptor one_float(const std::string& name) {
  return las::descriptor_of({name, ElementType::kFloat32, 1, "", ""}, name);
}

std::vector<las::ExtraDimension> described(const std::vector<Descriptor>& descriptors, size_t bytes,
                                           KeptLog& log) {
  return las::extra_dimensions({extra_bytes_record(descriptors)}, {}, bytes, log.task());
}

// A descriptor of an int32 with these options, scale and shift.
Descriptor scaled_int(uint8_t options, double scale, double shift) {
  Descriptor out = las::descriptor_of({"h", ElementType::kInt32, 1, "", ""}, "h");
  out[3] = std::byte{options};
  store<double>(out.data() + 112, scale);
  store<double>(out.data() + 136, shift);
  return out;
}

}  // namespace

TEST_CASE(
    "las_extra__every_type_and_number_of_components_comes_back_at_the_place_behind_the_last") {
  // Table 25: 1 = unsigned char ... 10 = double; 11-20 pairs and 21-30 triples of them.
  constexpr ElementType kTable[] = {
      ElementType::kUint8,   ElementType::kInt8,   ElementType::kUint16, ElementType::kInt16,
      ElementType::kUint32,  ElementType::kInt32,  ElementType::kUint64, ElementType::kInt64,
      ElementType::kFloat32, ElementType::kFloat64};
  std::vector<Descriptor> descriptors;
  size_t bytes = 0;
  for (uint32_t components = 1; components <= 3; ++components)
    for (size_t t = 0; t < 10; ++t) {
      const std::string name = "d" + std::to_string(descriptors.size());
      descriptors.push_back(
          las::descriptor_of({"", kTable[t], components, "", "of " + name}, name));
      CHECK(static_cast<size_t>(descriptors.back()[2]) == descriptors.size());
      bytes += size_of(kTable[t]) * components;
    }
  KeptLog log;
  const auto back = described(descriptors, bytes, log);
  REQUIRE(back.size() == 30);
  size_t at = 0;
  for (size_t i = 0; i < back.size(); ++i) {
    CAPTURE(i);
    CHECK(back[i].field.name == "d" + std::to_string(i));
    CHECK(back[i].field.meaning == "of d" + std::to_string(i));
    CHECK(back[i].field.type == kTable[i % 10]);
    CHECK(back[i].field.components == i / 10 + 1);
    CHECK(back[i].offset == at);
    CHECK_FALSE(back[i].scaled);
    CHECK(back[i].descriptor == descriptors[i]);
    at += back[i].bytes();
  }
  CHECK(at == bytes);
  CHECK(log.warnings().empty());
}

TEST_CASE("las_extra__scale_and_shift_count_where_their_bits_say_so_and_they_are_usable") {
  KeptLog log;
  const auto first = [&](uint8_t options, double scale, double shift) {
    return described({scaled_int(options, scale, shift)}, 4, log)[0];
  };
  const las::ExtraDimension both = first(8 | 16, 0.001, 100);
  CHECK(both.scaled);
  CHECK(both.field.type == ElementType::kFloat64);
  CHECK(both.raw_type == ElementType::kInt32);
  CHECK(both.scale[0] == 0.001);
  CHECK(both.shift[0] == 100);
  CHECK(first(8, 0.001, 100).shift[0] == 0);
  CHECK(first(16, 0.001, 100).scale[0] == 1);
  CHECK_FALSE(first(1 | 2 | 4, 0.001, 100).scaled);  // no-data, least, greatest value
  for (const double scale : {0.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    const las::ExtraDimension raw = first(8, scale, 0);
    CHECK_FALSE(raw.scaled);
    CHECK(raw.field.type == ElementType::kInt32);
  }
}

TEST_CASE("las_extra__what_is_not_described_or_does_not_fit_becomes_plain_bytes") {
  KeptLog log;
  auto found = described({one_float("a")}, 9, log);
  REQUIRE(found.size() == 2);
  CHECK(found[1].field.name == "extra_bytes");
  CHECK(found[1].field.components == 5);
  CHECK(found[1].offset == 4);
  CHECK(found[1].descriptor.empty());
  CHECK(log.warnings().empty());

  found = described({one_float("a"), one_float("b"), one_float("c")}, 7, log);
  REQUIRE(found.size() == 2);  // a, and three bytes that b does not fit in
  CHECK(found[1].field.components == 3);
  REQUIRE(log.warnings().size() == 1);
  CHECK(log.warnings()[0].find("more than the 7 extra bytes") != std::string::npos);

  Descriptor plain = one_float("plain");  // type 0: as many bytes as the options say
  plain[2] = std::byte{0};
  plain[3] = std::byte{6};
  found = described({plain, one_float("behind")}, 10, log);
  REQUIRE(found.size() == 2);
  CHECK(found[0].field.type == ElementType::kUint8);
  CHECK(found[0].field.components == 6);
  CHECK(found[1].offset == 6);

  Descriptor reserved =
      one_float("reserved");  // its length is not known: all from there on is plain
  reserved[2] = std::byte{31};
  found = described({reserved, one_float("behind")}, 8, log);
  REQUIRE(found.size() == 1);
  CHECK(found[0].field.name == "extra_bytes");
  CHECK(found[0].field.components == 8);
}

TEST_CASE("las_extra__names_are_told_apart_and_three_normals_side_by_side_are_one_field") {
  KeptLog log;
  auto found = described({one_float("a"), one_float("a"), one_float(""), one_float("a")}, 16, log);
  REQUIRE(found.size() == 4);
  CHECK(found[1].field.name == "a_2");
  CHECK(found[2].field.name == "extra_3");
  CHECK(found[3].field.name == "a_3");

  const std::vector<Descriptor> normals{one_float("NormalX"), one_float("NormalY"),
                                        one_float("NormalZ")};
  found = described({one_float("a"), normals[0], normals[1], normals[2], one_float("b")}, 20, log);
  REQUIRE(found.size() == 3);
  CHECK(found[1].field.name == "normal");
  CHECK(found[1].field.components == 3);
  CHECK(found[1].offset == 4);
  CHECK(found[1].descriptor.size() == 3 * las::kDescriptorBytes);
  CHECK(found[2].offset == 16);
  CHECK(described({normals[0], normals[2], normals[1]}, 12, log).size() == 3);
  CHECK(described({normals[0], one_float("a"), normals[1], normals[2]}, 16, log).size() == 4);
}
