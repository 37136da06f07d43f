// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// PTX put together by hand: two scans of a grid with their poses.
#include "formats/ptx/ptx.h"

#include <doctest/doctest.h>

#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// A quarter turn about z, x to y; the rows of the matrix stand for columns.
const std::string kTurned =
    "100 200 10\n0 1 0\n-1 0 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n100 200 10 1\n";
const std::string kUnmoved = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";

Cloud ptx_cloud(const std::string& text) {
  const OpenedFile file(text, "a.ptx");
  Task task;
  return read_ptx(file, {}, task);
}

std::string refused_ptx(const std::string& text) {
  const Failure failure = failure_of([&] { ptx_cloud(text); });
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

}  // namespace

TEST_CASE("ptx__scans_are_stations_and_empty_returns_keep_the_grid") {
  const Cloud cloud = ptx_cloud("2\r\n3\r\n" + kTurned +
                                "1 0 0 0.25 10 20 30\r\n0 0 0 0.5 0 0 0\r\n0 0 2 1 255 0 7\r\n"
                                "0 0 0 0.5 0 0 0\r\n0 3 0 0 1 2 3\r\n0 0 0 0.5 0 0 0\r\n" +
                                "1\n2\n" + kUnmoved + "4 5 6 0.75\n7 8 9 0.5");
  REQUIRE(cloud.size() == 5);
  CHECK(cloud.point(0) == Vec3{100, 201, 10});
  CHECK(cloud.point(1) == Vec3{100, 200, 12});
  CHECK(cloud.point(2) == Vec3{97, 200, 10});
  CHECK(cloud.point(4) == Vec3{7, 8, 9});
  const auto rows = cloud.fields.require("row").values<uint32_t>();
  const auto columns = cloud.fields.require("column").values<uint32_t>();
  CHECK(std::vector<uint32_t>(rows.begin(), rows.end()) == std::vector<uint32_t>{0, 2, 1, 0, 1});
  CHECK(std::vector<uint32_t>(columns.begin(), columns.end()) ==
        std::vector<uint32_t>{0, 0, 1, 0, 0});
  CHECK(cloud.fields.require("intensity").number(3) == 0.75);
  CHECK(cloud.fields.require("red").number(1) == 255);
  CHECK(cloud.fields.require("blue").number(2) == 3);
  CHECK(cloud.fields.require("blue").number(3) == 0);
  REQUIRE(cloud.stations.size() == 2);
  CHECK(cloud.stations[0].count == 3);
  CHECK(cloud.stations[0].has_pose);
  CHECK(cloud.stations[0].pose.translation() == Vec3{100, 200, 10});
  CHECK(norm(cloud.stations[0].pose.direction({1, 0, 0}) - Vec3{0, 1, 0}) < 1e-15);
  CHECK(cloud.stations[1].first == 3);
  CHECK(cloud.stations[1].count == 2);
}

TEST_CASE("ptx__a_matrix_that_scales_moves_the_points_and_is_no_pose") {
  std::string scaled = kUnmoved;
  scaled.replace(scaled.find("1 0 0 0"), 7, "2 0 0 0");
  const Cloud cloud = ptx_cloud("1\n1\n" + scaled + "1 1 1 0\n");
  CHECK(cloud.point(0) == Vec3{2, 1, 1});
  CHECK_FALSE(cloud.stations[0].has_pose);
}

TEST_CASE("ptx__what_is_wrong_is_named_with_its_line") {
  CHECK(has_text(refused_ptx("1\n2\n" + kUnmoved + "1 2 3 0\n"),
                 "line 11: the file ends after 1 of the 2 lines of scan 1"));
  CHECK(has_text(refused_ptx("1\n1\n" + kUnmoved + "1 2 x 0\n"), "line 11: this is no number"));
  CHECK(has_text(refused_ptx("1\n1\n" + kUnmoved + "1 2 3 0 256 0 0\n"), "colour"));
  CHECK(has_text(refused_ptx("1\n1\n" + kUnmoved + "1 2\n"), "a point needs 3, 4 or 7 numbers"));
  CHECK(has_text(refused_ptx("4000000000\n4000000000\n" + kUnmoved), "more cells than the file"));
  CHECK(has_text(refused_ptx("1.5\n1\n" + kUnmoved), "line 1: a count"));
  CHECK(has_text(refused_ptx("1\n1\n0 0 0\n"), "the file ends inside the header"));
  CHECK(has_text(refused_ptx("1 2 3\n"), "line 1: the number of columns"));
  CHECK(has_text(refused_ptx("\n\n"), "there is no scan"));
}
