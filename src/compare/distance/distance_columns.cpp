// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/distance_columns.h"

namespace jalon {

namespace {

std::shared_ptr<Column> number_column(const char* name, const char* meaning, size_t points) {
  return std::make_shared<Column>(FieldInfo{name, ElementType::kFloat64, 1, "m", meaning}, points);
}

}  // namespace

DistanceColumns::DistanceColumns(size_t points, bool with_differences)
    : distance(number_column("distance", "from the reference", points)),
      nearest(std::make_shared<Column>(FieldInfo{"nearest", ElementType::kUint32, 1, "",
                                                 "nearest reference point; 4294967295 = none"},
                                       points)),
      status(std::make_shared<Column>(FieldInfo{"status", ElementType::kUint8, 1, "",
                                                "0 compared, 4 nothing within max_distance_m"},
                                      points)),
      distances(distance->values<double>().data()),
      nearests(nearest->values<uint32_t>().data()),
      statuses(status->values<uint8_t>().data()) {
  if (!with_differences) return;
  constexpr const char* kNames[] = {"difference_x", "difference_y", "difference_z"};
  for (int axis = 0; axis < 3; ++axis) {
    difference[axis] =
        number_column(kNames[axis], "from the foot on the reference to the point", points);
    differences[axis] = difference[axis]->values<double>().data();
  }
}

void DistanceColumns::attach(FieldTable& table) const {
  for (const auto& column :
       {distance, status, nearest, difference[0], difference[1], difference[2]})
    if (column) table.set(column);
}

}  // namespace jalon
