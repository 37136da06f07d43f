// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <limits>

#include "unit/formats/las/copc_files.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::optional<las::CopcInfo> info_of(const std::vector<std::byte>& data) {
  const OpenedFile file("LASF");
  return las::copc_info(file, {las::make_record("copc", 1, "", data.data(), data.size()),
                               las::make_record("copc", 1, "", data.data(), 0)});
}

constexpr las::CopcInfo kInfo = {{1, -2, 3}, 8, 0.5, 600, 64, -1, 9};

}  // namespace

TEST_CASE("copc_info__comes_back_as_it_was_written_from_the_first_record_alone") {
  const std::vector<std::byte> data = las::info_bytes(kInfo);
  REQUIRE(data.size() == 160);
  const auto back = info_of(data);
  REQUIRE(back.has_value());
  CHECK(las::info_bytes(*back) == data);
  const OpenedFile file("LASF");
  CHECK_FALSE(las::copc_info(file, {}).has_value());
  CHECK_FALSE(las::copc_info(file, {las::make_record("other", 1, "", data.data(), data.size()),
                                    las::make_record("copc", 1, "", data.data(), data.size())})
                  .has_value());
}

TEST_CASE("copc_info__cubes_and_spacings_that_cannot_be_are_refused") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const size_t at : {0u, 8u, 16u, 24u, 32u})
    for (const double bad : {kNan, kInfinite, 0.0, -1.0}) {
      if (at < 24 && std::isfinite(bad)) continue;  // a centre may be anywhere
      std::vector<std::byte> data = las::info_bytes(kInfo);
      store<double>(data.data() + at, bad);
      const Failure failure = failure_of([&] { info_of(data); });
      CHECK(failure.status == Status::kFormat);
      CHECK(has_text(failure.text, at < 32 ? "offset 429: the cube" : "offset 461: the spacing"));
    }
  const Failure failure = failure_of([&] { info_of(std::vector<std::byte>(159)); });
  CHECK(has_text(failure.text, "has 159 bytes; it needs 160"));
}

TEST_CASE("copc_info__the_level_is_the_coarsest_whose_points_stand_no_wider_apart") {
  CHECK(las::level_of(kInfo, 1) == 0);
  CHECK(las::level_of(kInfo, 0.5) == 0);
  CHECK(las::level_of(kInfo, 0.49) == 1);
  CHECK(las::level_of(kInfo, 0.125) == 2);
  CHECK(las::level_of(kInfo, 1e-300) == las::kMostCopcLevel);
}
