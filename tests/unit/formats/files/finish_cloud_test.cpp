// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What readers do last, against points of which it is known which are not finite.
#include "formats/files/finish_cloud.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "unit/formats/fixtures.h"
#include "unit/formats/kept_log.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Point i has the coordinates i, i + 1/4, i + 1/2 and the field i, but for what is replaced: coordinate, value.
Cloud counted(size_t n, const std::vector<std::pair<size_t, double>>& replaced) {
  Buffer<double> xyz(3 * n);
  std::vector<uint32_t> number(n);
  for (size_t i = 0; i < n; ++i) {
    number[i] = static_cast<uint32_t>(i);
    for (size_t k = 0; k < 3; ++k)
      xyz[3 * i + k] = static_cast<double>(i) + 0.25 * static_cast<double>(k);
  }
  for (const auto& [coordinate, value] : replaced) xyz[coordinate] = value;
  Cloud cloud = make_cloud(std::move(xyz));
  cloud.fields.set(make_column<uint32_t>({"number"}, number));
  return cloud;
}

/// A file that the points are said to come from.
class NamedSource {
 public:
  NamedSource() { spill(folder_.file("points.bin"), ""); }
  ByteSource open() const { return ByteSource(folder_.file("points.bin")); }

 private:
  Folder folder_;
};

}  // namespace

TEST_CASE("finish_cloud__a_finite_cloud_passes_whether_or_not_points_may_be_dropped") {
  const NamedSource file;
  const ByteSource source = file.open();
  for (const bool drop_invalid : {false, true}) {
    KeptLog log;
    const Cloud cloud =
        counted(1000, {{5, 1e308}, {6, -std::numeric_limits<double>::denorm_min()}});
    const Cloud out = finish_cloud(cloud, source, drop_invalid, log.task());
    CHECK(out.xyz_buffer.get() == cloud.xyz_buffer.get());  // shared, not copied
    CHECK(finish_cloud(Cloud{}, source, drop_invalid, log.task()).size() == 0);
    CHECK(log.warnings().empty());
  }
}

TEST_CASE("finish_cloud__drops_the_points_with_any_coordinate_that_is_not_finite") {
  const NamedSource file;
  const ByteSource source = file.open();
  constexpr size_t kPoints = 200000;  // more than one thread takes at a time
  RandomStream random(1, 1);
  std::vector<std::pair<size_t, double>> replaced{{0, NAN}, {3 * kPoints - 1, -kInfinity}};
  for (int i = 0; i < 500; ++i)
    replaced.emplace_back(random.below(3 * kPoints), i % 2 == 0 ? NAN : kInfinity);
  std::vector<uint8_t> bad(kPoints, 0);
  for (const auto& [coordinate, value] : replaced) bad[coordinate / 3] = 1;
  KeptLog log;
  const Cloud out = finish_cloud(counted(kPoints, replaced), source, true, log.task());
  const std::span<const uint32_t> number = out.fields.require("number").values<uint32_t>();
  REQUIRE(number.size() == out.size());
  size_t at = 0, wrong = 0;
  for (uint32_t i = 0; i < kPoints; ++i) {
    if (bad[i] != 0 || at >= out.size()) continue;
    wrong += number[at] != i || out.point(at) != Vec3{i + 0.0, i + 0.25, i + 0.5} ? 1 : 0;
    ++at;
  }
  CHECK(wrong == 0);
  CHECK(at == out.size());
  CHECK(static_cast<std::ptrdiff_t>(at) == std::count(bad.begin(), bad.end(), 0));
  REQUIRE(log.warnings().size() == 1);
  CHECK(log.warnings()[0] == source.path() + ": " + std::to_string(kPoints - at) +
                                 " points with coordinates that are not finite left out");
}

TEST_CASE("finish_cloud__names_the_first_bad_point_and_how_many_there_are") {
  const NamedSource file;
  const ByteSource source = file.open();
  KeptLog log;
  const Failure failure = failure_of([&] {
    finish_cloud(counted(50, {{3 * 40, NAN}, {3 * 7 + 2, kInfinity}, {3 * 40 + 1, NAN}}), source,
                 false, log.task());
  });
  CHECK(failure.status == Status::kFormat);
  CHECK(failure.text.starts_with(source.path() + ": point 7 "));
  CHECK(failure.text.find("(2 of 50 have)") != std::string::npos);
  CHECK(failure.text.find("drop_invalid") != std::string::npos);
  const Cloud none = finish_cloud(counted(2, {{1, NAN}, {4, NAN}}), source, true, log.task());
  CHECK(none.size() == 0);
  CHECK(none.fields.require("number").count() == 0);
}
