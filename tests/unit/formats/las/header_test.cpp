// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Headers and records of LAS files against files laid out by hand after ASPRS LAS 1.4 R15.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "formats/las/layout.h"
#include "unit/formats/kept_log.h"
#include "unit/formats/las/las_bytes.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

LasBytes two_points(unsigned minor, unsigned format) {
  LasBytes file;
  file.minor = minor;
  file.format = format;
  file.record_bytes = las::point_format(format)->bytes;
  file.add_point(1, 2, 3);
  file.add_point(4, 5, 6);
  return file;
}

// The refusal of a header of LAS 1.2 in which one number is another one.
template <class T>
Failure refusal_with(size_t offset, T value) {
  std::string bytes = two_points(2, 0).bytes();
  put_at(bytes, offset, value);
  const OpenedFile file(bytes);
  return failure_of([&] { las::read_header(file); });
}

las::Record text_record(const char* user, uint16_t id, const std::string& text) {
  return las::make_record(user, id, "made", text.data(), text.size());
}

}  // namespace

TEST_CASE("las_header__each_version_gives_its_numbers_and_the_wider_count_of_1_4_goes_first") {
  for (unsigned minor = 0; minor <= 4; ++minor) {
    CAPTURE(minor);
    LasBytes made = two_points(minor, minor == 4 ? 6 : 1);
    made.scale = 0.25;
    made.offset = -1e6;
    const std::string bytes = made.bytes();
    const OpenedFile file(bytes);
    const las::Header header = las::read_header(file);
    CHECK(header.version_minor == minor);
    CHECK(header.count == 2);
    CHECK(header.record_bytes == made.record_bytes);
    CHECK(header.point_offset == made.header_size());
    CHECK(header.scale == Vec3{0.25, 0.25, 0.25});
    CHECK(header.offset == Vec3{-1e6, -1e6, -1e6});
    REQUIRE(header.raw.size() == made.header_size());
    CHECK(std::memcmp(header.raw.data(), bytes.data(), header.raw.size()) == 0);
  }
  std::string both = two_points(4, 1).bytes();  // the old count and the new one may differ
  put_at(both, 107, uint32_t{1});
  const OpenedFile two(both);
  CHECK(las::read_header(two).count == 2);
  put_at(both, 247, uint64_t{0});
  const OpenedFile one(both);
  CHECK(las::read_header(one).count == 1);
}

TEST_CASE("las_header__impossible_numbers_are_refused_at_their_offset") {
  const auto says = [](const Failure& failure, const std::string& words) {
    CHECK(failure.status == Status::kFormat);
    CHECK_MESSAGE(has_text(failure.text, words), failure.text);
  };
  says(refusal_with(24, uint8_t{2}), "offset 24: LAS 2.2 ");
  says(refusal_with(25, uint8_t{5}), "offset 24: LAS 1.5 ");
  says(refusal_with(94, uint16_t{226}), "offset 94: a header of 226 bytes is too short");
  says(refusal_with(94, uint16_t{60000}), "offset 94: the header of 60000 bytes is longer");
  says(refusal_with(96, uint32_t{226}), "offset 96: the points would start inside the header");
  says(refusal_with(96, uint32_t{268}), "offset 96: the points would start at offset 268");
  says(refusal_with(104, uint8_t{11}), "offset 104: point format 11 ");
  says(refusal_with(105, uint16_t{19}), "offset 105: point records of 19 bytes");
  says(refusal_with(107, uint32_t{3}), "promises 3 points of 20 bytes");
  says(refusal_with(139, 0.0), "offset 139: the scale of axis 2 ");
  says(refusal_with(163, std::numeric_limits<double>::infinity()), "the offset of axis 2 ");
  const OpenedFile cut(two_points(2, 0).bytes().substr(0, 226));
  says(failure_of([&] { las::read_header(cut); }), "offset 226: the file ends inside");
}

TEST_CASE("las_header__records_come_back_whole_and_a_broken_one_ends_the_list_with_a_warning") {
  LasBytes made = two_points(4, 6);
  made.vlrs = {text_record("one", 7, "first"), text_record("two", 65535, "")};
  made.evlrs = {extended_record("three", 1, std::string(70000, 'x'))};
  std::string bytes = made.bytes();
  for (const bool broken : {false, true}) {
    CAPTURE(broken);
    if (broken) {  // the second states more bytes than there are before the points, the third more than the file has
      put_at(bytes, 375 + las::kVlrHeader + 5 + 20, uint16_t{1});
      put_at(bytes, get_at<uint64_t>(bytes, 235) + 20, uint64_t{70001});
    }
    const OpenedFile file(bytes);
    KeptLog log;
    const las::Header header = las::read_header(file);
    const auto vlrs = las::read_vlrs(file, header, log.task());
    const auto evlrs = las::read_evlrs(file, header, log.task());
    REQUIRE(vlrs.size() == (broken ? 1 : 2));
    CHECK(vlrs[0].bytes == made.vlrs[0].bytes);
    CHECK(vlrs[0].is("one", 7));
    CHECK(vlrs[0].text() == "first");
    REQUIRE(evlrs.size() == (broken ? 0 : 1));
    if (!broken) CHECK(evlrs[0].size() == 70000);
    REQUIRE(log.warnings().size() == (broken ? 2 : 0));
    if (broken) CHECK(has_text(log.warnings()[0], "offset 434: VLR 2 of 2 is broken"));
    if (broken) CHECK(has_text(log.warnings()[1], ": EVLR 1 of 1 is broken"));
  }
  put_at(bytes, 235, uint64_t{100});
  const OpenedFile inside(bytes);
  KeptLog log;
  CHECK(las::read_evlrs(inside, las::read_header(inside), log.task()).empty());
  REQUIRE(log.warnings().size() == 1);
  CHECK(has_text(log.warnings()[0], "inside the header"));
}

TEST_CASE("las_header__a_record_takes_the_long_header_where_16_bits_cannot_count_its_bytes") {
  for (const size_t size : {size_t{0}, size_t{1}, size_t{65535}, size_t{65536}}) {
    CAPTURE(size);
    const las::Record record = text_record("sixteen letters and more", 9, std::string(size, 'y'));
    CHECK(record.header_bytes == (size <= 65535 ? 54 : 60));
    CHECK(record.user == "sixteen letters");  // 16 bytes, and the blank at the end is off
    CHECK(record.id == 9);
    CHECK(record.text() == std::string(size, 'y'));
    CHECK(las::record_of(record.bytes, record.header_bytes).is("sixteen letters", 9));
  }
  CHECK(las::record_of(std::vector<std::byte>(53), las::kVlrHeader).user.empty());
  CHECK(las::point_format(11) == nullptr);
}
