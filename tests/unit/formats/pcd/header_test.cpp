// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/pcd/header.h"

#include <doctest/doctest.h>

#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("pcd_header__the_oldest_files_name_columns_and_nothing_else") {
  const OpenedFile file("# .PCD v.5\nCOLUMNS x y z\r\nPOINTS 1\nDATA ascii\n1 2 3\n");
  const pcd::Header header = pcd::read_header(file);
  CHECK(header.members.size() == 3);
  CHECK(header.record_bytes == 12);
  CHECK(header.points == 1);
  CHECK(header.data_line == 5);
  CHECK_FALSE(header.has_pose);
}

TEST_CASE("pcd_header__members_lie_one_behind_the_other") {
  const OpenedFile file(
      "VERSION 0.7\nFIELDS x y z l t\nSIZE 8 8 8 2 8\nTYPE F F F U I\nCOUNT 1 1 1 3 1\nWIDTH 0\n"
      "HEIGHT 1\nVIEWPOINT 0 0 1 1 0 0 0\nPOINTS 0\nDATA binary_compressed\n");
  const pcd::Header header = pcd::read_header(file);
  CHECK(header.members[4].offset == 30);
  CHECK(header.members[3].bytes() == 6);
  CHECK(header.members[3].type == ElementType::kUint16);
  CHECK(header.record_bytes == 38);
  CHECK(header.data == pcd::Data::kCompressed);
  CHECK(header.has_pose);
  CHECK(header.pose.translation() == Vec3{0, 0, 1});
}
