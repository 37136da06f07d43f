// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/e57/record_points.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/formats/e57/packed_records.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kSixth = 0.52359877559829887;  // of a half turn

/// Four records of a place, whether it is invalid, a brightness and whether that is.
struct Scan {
  OpenedFile file;
  Task task;
  e57::Records records;
  explicit Scan(const std::vector<e57::RecordColumn>& columns)
      : file(section_file(48, packets_of(streams(), 40, 1), "")),
        records(file, 48, 4, columns, task) {
    REQUIRE(records.next(task) == 4);
  }
  static std::vector<BitStream> streams() {
    const uint64_t rows[4][6] = {
        {1, 2, 3, 0, 10, 0}, {4, 5, 6, 1, 20, 0}, {7, 8, 9, 0, 30, 1}, {2, 1, 1, 0, 40, 0}};
    std::vector<BitStream> out(6);
    for (const auto& row : rows)
      for (size_t c = 0; c < 6; ++c) out[c].add(row[c], 8);
    return out;
  }
};

std::vector<e57::RecordColumn> whole_numbers() {
  return std::vector<e57::RecordColumn>(6, {kJcInteger, 1, 0, {0, 8}});
}

}  // namespace

TEST_CASE("e57_record_points__invalid_places_are_left_out_and_invalid_values_are_none") {
  Scan scan(whole_numbers());
  e57::ScanLayout layout{{0, 1, 2}, false, 3, {{4, {}, 2, 0.5, 5}}};
  const e57::RecordPoints points(scan.records, layout, 0, 4);
  CHECK(points.count() == 3);
  CHECK(points.places({}) == std::vector<double>{1, 2, 3, 7, 8, 9, 2, 1, 1});
  const std::vector<double> values = points.values(layout.fields[0]);
  CHECK(values[0] == 20.5);
  CHECK(std::isnan(values[1]));
  CHECK(values[2] == 80.5);
  layout.invalid.reset();
  const e57::RecordPoints part(scan.records, layout, 1, 3);
  CHECK(part.places({}) == std::vector<double>{4, 5, 6, 7, 8, 9});
}

TEST_CASE("e57_record_points__angles_become_places_and_a_pose_moves_them") {
  std::vector<e57::RecordColumn> columns = whole_numbers();
  for (const size_t c : {1u, 2u}) {
    columns[c].kind = kJcScaled;
    columns[c].scale = kSixth;
  }
  Scan scan(columns);
  const e57::ScanLayout layout{{0, 1, 2}, true, {}, {}};
  Transform pose;
  pose.m[3] = 100;
  const std::vector<double> xyz = e57::RecordPoints(scan.records, layout, 3, 4).places(pose);
  CHECK(xyz[0] == doctest::Approx(100 + 2 * 0.75));  // of two metres, both angles 30 degrees
  CHECK(xyz[1] == doctest::Approx(std::sqrt(3) / 2));
  CHECK(xyz[2] == doctest::Approx(1));
}
