// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "compare/comparison.h"
#include "compare/summary.h"

namespace jalon {

namespace {

constexpr ParamRow kRows[] = {
    number_row("max_distance_m", 0, 0, 1e9, "m", "",
               "Radius beyond which a point counts as without reference (status nothing near); 0 = no limit."),
};

struct Columns {
  std::shared_ptr<Column> distance, nearest, status;
};

Columns make_columns(size_t n) {
  return {std::make_shared<Column>(FieldInfo{"distance", ElementType::kFloat64, 1, "m", "from the reference"}, n),
          std::make_shared<Column>(
              FieldInfo{"nearest", ElementType::kUint32, 1, "", "nearest reference point; 4294967295 = none"}, n),
          std::make_shared<Column>(
              FieldInfo{"status", ElementType::kUint8, 1, "", "0 compared, 4 nothing within max_distance_m"}, n)};
}

void fill(const Cloud& compared, const Octree& tree, double limit_m, const Columns& columns, Task& task) {
  const auto distance = columns.distance->values<double>();
  const auto nearest = columns.nearest->values<uint32_t>();
  const auto status = columns.status->values<uint8_t>();
  parallel_for(task, compared.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      std::array<Neighbour, 1> found{};
      tree.knn(compared.point(i), 1, found);
      const double d = std::sqrt(found[0].squared_distance);
      const bool is_near = d <= limit_m;
      distance[i] = is_near ? d : std::numeric_limits<double>::quiet_NaN();
      nearest[i] = is_near ? found[0].index : kNoPoint;
      status[i] = static_cast<uint8_t>(is_near ? CompareStatus::kCompared : CompareStatus::kNothingNear);
    }
  });
}

}  // namespace

std::span<const ParamRow> distance_rows() { return kRows; }

Comparison compare_distance(const CloudPtr& reference, const CloudPtr& compared, const ParamSet& params, Task& task) {
  if (reference->size() == 0) fail(Status::kInsufficientData, "the reference cloud is empty");
  if (compared->size() == 0) fail(Status::kInsufficientData, "the compared cloud is empty");
  const double limit_m = params.number("max_distance_m");
  const auto tree = reference->octree(task);
  const Columns columns = make_columns(compared->size());
  fill(*compared, *tree, limit_m > 0 ? limit_m : std::numeric_limits<double>::infinity(), columns, task);
  Comparison made;
  made.cloud = compared;
  for (const auto& column : {columns.distance, columns.nearest, columns.status}) made.points.set(column);
  made.summary = summarise(columns.distance->values<double>(), columns.status->values<uint8_t>(), task);
  return made;
}

}  // namespace jalon
