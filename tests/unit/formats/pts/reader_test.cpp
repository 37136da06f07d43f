// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The layouts of PTS that programs write, and counts that lie.
#include <doctest/doctest.h>

#include "formats/pts/pts.h"
#include "unit/formats/kept_log.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Cloud pts_cloud(const std::string& text, bool drop_invalid = false) {
  const OpenedFile file(text, "a.pts");
  Task task;
  ReadSettings settings;
  settings.drop_invalid = drop_invalid;
  return read_pts(file, settings, task);
}

std::vector<std::string> names_of(const Cloud& cloud) {
  std::vector<std::string> names;
  for (const ColumnPtr& column : cloud.fields) names.push_back(column->info().name);
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("pts__columns_are_told_by_their_number") {
  CHECK(names_of(pts_cloud("1\n1 2 3\n")) == Names{});
  CHECK(names_of(pts_cloud("1\n1 2 3 -1204\n")) == Names{"intensity"});
  CHECK(names_of(pts_cloud("1\n1 2 3 10 20 30\n")) == Names{"red", "green", "blue"});
  const Cloud all = pts_cloud("2\r\n1 2 3 -2048 10 20 30\r\n1 2 4 2047 255 0 1\r\n");
  CHECK(names_of(all) == Names{"intensity", "red", "green", "blue"});
  CHECK(all.fields.require("intensity").number(0) == -2048);
  CHECK(all.fields.require("intensity").number(1) == 2047);
  CHECK(all.fields.require("red").info().type == ElementType::kUint8);
  CHECK(all.stations.empty());
}

TEST_CASE("pts__blocks_are_stations_whatever_their_counts_say") {
  const Cloud cloud =
      pts_cloud("2\n1 2 3 4\n5 6 7 8\n99999999999999999999\n9 9 9 9\n0\n3\n1 1 1 1\n");
  REQUIRE(cloud.size() == 4);
  REQUIRE(cloud.stations.size() == 3);
  CHECK(cloud.stations[0].count == 2);
  CHECK(cloud.stations[1].first == 2);
  CHECK(cloud.stations[1].count == 1);
  CHECK(cloud.stations[2].first == 3);
  CHECK_FALSE(cloud.stations[2].has_pose);
}

TEST_CASE("pts__a_count_that_lies_gives_a_warning_with_its_block") {
  const OpenedFile file("5\n1 2 3\n4 5 6\n1\n7 8 9\n", "a.pts");
  KeptLog log;
  CHECK(read_pts(file, {}, log.task()).size() == 3);
  REQUIRE(log.warnings().size() == 1);
  CHECK(has_text(log.warnings()[0], "block 1 holds 2 points, not as many as its count says"));
}

TEST_CASE("pts__points_that_are_dropped_leave_their_stations_right") {
  const Cloud cloud = pts_cloud("2\n1 2 3\nnan 6 7\n1\n9 9 9\n", true);
  REQUIRE(cloud.size() == 2);
  REQUIRE(cloud.stations.size() == 2);
  CHECK(cloud.stations[0].count == 1);
  CHECK(cloud.stations[1].first == 1);
}
