// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/lines/line_growth.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace jalon;

namespace {

ScanLine line_at(uint64_t row, double from, double to, double y) {
  ScanLine line;
  line.row = row;
  line.from = from;
  line.to = to;
  for (double z = from; z <= to + 1e-9; z += 0.05)
    line.moments.add({0.1 * static_cast<double>(row), y, z});
  return line;
}

}  // namespace

TEST_CASE("line_growth__lines_are_beside_each_other_where_they_overlap_in_near_rows") {
  const std::vector<ScanLine> lines{line_at(0, 0, 1, 0), line_at(0, 1.5, 2, 0),
                                    line_at(1, 0.5, 3, 0), line_at(3, 0, 3, 0),
                                    line_at(9, 0, 3, 0)};
  Task task;
  const auto beside = lines_beside(lines, task);
  CHECK(beside[0] == std::vector<uint32_t>{2});
  CHECK(beside[1] == std::vector<uint32_t>{2});
  CHECK(beside[2] == std::vector<uint32_t>{0, 1, 3});
  CHECK(beside[4].empty());
}

TEST_CASE("line_growth__parts_two_levels_and_keeps_no_pair") {
  std::vector<ScanLine> lines;
  for (uint64_t r = 0; r < 10; ++r) lines.push_back(line_at(r, 0, 2, r < 5 ? 0 : 0.3));
  lines.push_back(line_at(20, 0, 2, 0));
  lines.push_back(line_at(21, 0, 2, 0));
  Task task;
  const LineRegions regions = grow_lines(lines, lines_beside(lines, task), 0.025, task);
  REQUIRE(regions.planes.size() == 2);
  for (size_t r = 1; r < 10; ++r) CHECK((regions.labels[r] == regions.labels[r - 1]) == (r != 5));
  CHECK(regions.labels[10] == 0);
  for (const Plane& plane : regions.planes) CHECK(std::fabs(plane.normal.y) > 0.9999);
}
