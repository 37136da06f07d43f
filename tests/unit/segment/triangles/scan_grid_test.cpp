// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/scan_grid.h"

#include <doctest/doctest.h>

#include "unit/segment/lines/scanned.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct GridCase {
  std::vector<Vec3> points;
  std::vector<double> rows, columns;
  void add(double row, double column) {
    points.push_back({row, column, 0.1 * static_cast<double>(points.size() % 3)});
    rows.push_back(row);
    columns.push_back(column);
  }
  std::shared_ptr<Cloud> cloud() const {
    auto cloud = std::make_shared<Cloud>(*cloud_of(points));
    for (const auto& [name, values] : {std::pair{"row", &rows}, {"column", &columns}}) {
      auto column = std::make_shared<Column>(FieldInfo{name, ElementType::kFloat64, 1, "", ""},
                                             values->size());
      std::copy(values->begin(), values->end(), column->values<double>().begin());
      cloud->fields.set(column);
    }
    return cloud;
  }
};

// Index in the cloud of the point on a place, or -1.
int64_t point_at(const ScanGrid& grid, const Octree& tree, size_t row, size_t column) {
  const uint32_t position = grid.at(row, column);
  return position == kNoPoint ? -1 : static_cast<int64_t>(tree.order()[position]);
}

GridCase square(size_t edge) {
  GridCase made;
  for (size_t r = 0; r < edge; ++r)
    for (size_t c = 0; c < edge; ++c)
      made.add(static_cast<double>(r) + 1000, static_cast<double>(c) - 3);
  return made;
}

}  // namespace

TEST_CASE("scan_grid__has_each_point_where_the_fields_say_the_first_of_several_and_none_taken") {
  GridCase made = square(4);
  made.add(1001, -2);  // a second return
  made.add(kNaN, 0);
  const auto cloud = made.cloud();
  Task task;
  const auto tree = cloud->octree(task);
  REQUIRE(is_organised(*cloud, task));
  std::vector<uint32_t> owner(tree->size(), 0);
  for (size_t i = 0; i < tree->size(); ++i) owner[i] = tree->order()[i] == 10 ? 1 : 0;
  const auto grids = scan_grids(*cloud, *tree, owner, task);
  REQUIRE(grids.size() == 1);
  CHECK(grids[0].rows == 4);
  CHECK(grids[0].columns == 4);
  for (size_t i = 0; i < 16; ++i)
    CHECK(point_at(grids[0], *tree, i / 4, i % 4) == (i == 10 ? -1 : static_cast<int64_t>(i)));
}

TEST_CASE("scan_grid__is_one_for_each_station") {
  GridCase made = square(3);
  for (int i = 0; i < 4; ++i) made.add(i / 2, i % 2);
  auto cloud = made.cloud();
  cloud->stations.resize(3);
  cloud->stations[0].count = 9;
  cloud->stations[1].first = cloud->stations[2].first = 9;  // a station without points
  cloud->stations[2].count = 4;
  Task task;
  const auto tree = cloud->octree(task);
  const auto grids = scan_grids(*cloud, *tree, std::vector<uint32_t>(tree->size(), 0), task);
  REQUIRE(grids.size() == 2);
  CHECK(grids[0].rows == 3);
  CHECK(grids[1].columns == 2);
  CHECK(point_at(grids[0], *tree, 2, 1) == 7);
  CHECK(point_at(grids[1], *tree, 1, 1) == 12);
}

TEST_CASE("scan_grid__is_none_without_fields_or_where_numbers_lie_far_apart") {
  Task task;
  GridCase made = square(5);
  CHECK(is_organised(*made.cloud(), task));
  CHECK_FALSE(is_organised(*cloud_of(made.points), task));
  for (const double far : {1e300, 1e9, -1e9, 3000.0}) {
    GridCase spread = made;
    spread.rows[7] = far;
    CHECK_FALSE(is_organised(*spread.cloud(), task));
  }
  GridCase unknown = made;
  for (double& row : unknown.rows) row = kNaN;
  CHECK_FALSE(is_organised(*unknown.cloud(), task));
}
