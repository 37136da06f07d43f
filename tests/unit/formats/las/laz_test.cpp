// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Compressed points against the same points as they are, and files that lie about their chunks.
#include "formats/las/laz.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/random.h"
#include "formats/codecs/codecs.h"
#include "formats/files/endian.h"
#include "formats/las/las.h"
#include "formats/las/point_sink.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// The bytes of a shared LAZ file; "" after saying why not.
std::string laz_bytes(const std::string& name) {
  if (!has_codecs()) {
    MESSAGE("skipped: built without JALON_WITH_RUST_FORMATS");
    return "";
  }
  const std::string path = shared("las/" + name);
  return path.empty() ? "" : slurp(path);
}

std::string refused_laz(const std::string& bytes) {
  const OpenedFile file(bytes, "a.laz");
  Task task;
  const Failure failure = failure_of([&] { read_las(file, {}, task); });
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

size_t points_at(const std::string& bytes) { return load<uint32_t>(bytes.data() + 96); }

template <class T>
std::string with(std::string bytes, size_t at, T value) {
  store<T>(bytes.data() + at, value);
  return bytes;
}

}  // namespace

TEST_CASE("laz__gives_the_points_of_the_same_las_in_every_bit") {
  const std::string packed = shared("las/autzen_trim.laz"), plain = shared("las/autzen_trim.las");
  if (!has_codecs() || packed.empty() || plain.empty()) return;
  const Cloud a = read(packed), b = read(plain);
  REQUIRE(a.size() == 110000);
  REQUIRE(b.size() == a.size());
  CHECK(std::memcmp(a.xyz().data(), b.xyz().data(), a.xyz().size_bytes()) == 0);
  REQUIRE(a.fields.size() == b.fields.size());
  for (const ColumnPtr& column : b.fields) {
    CAPTURE(column->info().name);
    const Column& other = a.fields.require(column->info().name);
    CHECK(other.info().type == column->info().type);
    CHECK(std::memcmp(other.raw(), column->raw(), column->bytes()) == 0);
  }
  CHECK(std::string(a.crs) == std::string(b.crs));
}

TEST_CASE("laz__is_known_by_its_point_format_whatever_the_name") {
  const std::string bytes = laz_bytes("simple.laz");
  if (bytes.empty()) return;
  const OpenedFile file(bytes, "a.las");
  CHECK(is_laz(file));
  CHECK(read(file.path()).size() == 1065);
  const OpenedFile plain(with<uint8_t>(bytes, 104, 3));
  CHECK_FALSE(is_laz(plain));
}

TEST_CASE("laz__counts_and_places_that_lie_are_refused_with_what_is_wrong") {
  const std::string bytes = laz_bytes("simple.laz");
  if (bytes.empty()) return;
  const size_t points = points_at(bytes);
  const auto table = static_cast<size_t>(load<int64_t>(bytes.data() + points));
  CHECK(has_text(refused_laz(with<uint32_t>(bytes, 107, 4000000000u)),
                 "of the 4000000000 points promised"));
  CHECK(has_text(refused_laz(with<uint32_t>(bytes, 107, 60000)), "of the 60000 points promised"));
  CHECK(has_text(refused_laz(with<int64_t>(bytes, points, int64_t{1} << 60)),
                 "the chunk table would lie"));
  CHECK(has_text(refused_laz(with<uint32_t>(bytes, table + 4, 0xFFFFFFFFu)), "4294967295 chunks"));
  CHECK(has_text(refused_laz(with<uint16_t>(bytes, 105, 40)), "those of the compressor"));
  CHECK(has_text(refused_laz(with<uint16_t>(bytes, 227 + 18, 1)), "tells how"));
  CHECK(has_text(refused_laz(bytes.substr(0, table)), "the chunk table would lie"));
  CHECK(has_text(refused_laz(bytes.substr(0, points + 20)), "chunk table"));
}

TEST_CASE("laz__damaged_bytes_end_in_an_error_or_in_points_and_never_elsewhere") {
  const std::string bytes = laz_bytes("simple.laz");
  if (bytes.empty()) return;
  Task task;
  size_t refused = 0;
  for (size_t at = 227; at < bytes.size(); at += at < 700 ? 3 : 211)
    for (const char bad : {'\0', '\xff'}) {
      std::string damaged = bytes;
      damaged[at] = bad;
      const OpenedFile file(damaged, "a.laz");
      const Failure failure = failure_of([&] { read_las(file, {}, task); });
      CHECK((failure.status == Status::kOk || failure.status == Status::kFormat ||
             failure.status == Status::kUnsupported));
      refused += failure.status == Status::kOk ? 0 : 1;
    }
  CHECK(refused > 20);
}

TEST_CASE("laz__steps_of_a_box_hold_all_its_points") {
  RandomStream random(3, 1);
  for (int round = 0; round < 2000; ++round) {
    las::Header header;
    Vec3 metres{0.3048, 0.3048, 1};
    for (int k = 0; k < 3; ++k) {
      header.scale[k] = std::pow(10, -5 * random.uniform()) * (round % 7 == 0 ? -1 : 1);
      header.offset[k] = 1e7 * random.uniform() * (round % 3);
    }
    const auto point = [&](std::array<int32_t, 3> steps) {
      std::byte record[12];
      for (size_t k = 0; k < 3; ++k) store<int32_t>(record + 4 * k, steps[k]);
      return las::place_of(header, metres, record);
    };
    const auto drawn = [&] {
      std::array<int32_t, 3> steps{};
      for (int32_t& step : steps) step = static_cast<int32_t>(random.bits() >> random.below(32));
      return steps;
    };
    const auto a = drawn(), b = drawn();
    Box3 box;
    box.add(point(a));
    box.add(point(b));
    const las::StepBox steps = las::step_box(header, metres, box);
    for (const auto& corner : {a, b})
      for (size_t k = 0; k < 3; ++k) {
        CHECK(steps.least[k] <= corner[k]);
        CHECK(steps.most[k] >= corner[k]);
      }
  }
}

TEST_CASE("laz__steps_of_a_box_are_few_beyond_it_and_all_where_it_has_no_end_or_places_are_none") {
  las::Header header;
  header.scale = {0.001, 0.001, 0.001};
  header.offset = {0, 0, 0};
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  const las::StepBox steps =
      las::step_box(header, {1, 1, 1}, {{1, -2, -kEndless}, {2, -1, kEndless}});
  CHECK((steps.least[0] >= 998 && steps.most[0] <= 2002));
  CHECK((steps.least[1] >= -2002 && steps.most[1] <= -998));
  CHECK((steps.least[2] == INT32_MIN && steps.most[2] == INT32_MAX));
  header.scale.z = 1e300;
  const las::StepBox all = las::step_box(header, {1, 1, 1}, {{0, 0, 0}, {1, 1, 1}});
  CHECK((all.least[0] == INT32_MIN && all.most[0] == INT32_MAX));
}
