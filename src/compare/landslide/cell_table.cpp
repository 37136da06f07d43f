// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/cell_table.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace jalon {

namespace {

const Column& column_of(const FieldTable& table, const char* name, ElementType type,
                        uint32_t components, size_t rows) {
  const Column* column = table.find(name);
  if (column == nullptr || column->info().type != type || column->info().components != components ||
      column->count() != rows)
    fail(Status::kInvalidArgument, "column \"%s\" is not as method landslide makes it", name);
  return *column;
}

Vec3 vector_of(const FieldTable& summary, const char* name) {
  const Column& c = column_of(summary, name, ElementType::kFloat64, 3, 1);
  const Vec3 v{c.number(0, 0), c.number(0, 1), c.number(0, 2)};
  if (!is_finite(v)) fail(Status::kInvalidArgument, "\"%s\" of the summary is not finite", name);
  return v;
}

double number_of(const FieldTable& summary, const char* name) {
  return column_of(summary, name, ElementType::kFloat64, 1, 1).number(0);
}

uint64_t key_of(uint64_t line, uint64_t column) { return line << 32 | column; }

}  // namespace

bool is_landslide(const Comparison& comparison) {
  return comparison.points.find(kZoneColumn) != nullptr;
}

CellTable::CellTable(const Comparison& comparison) {
  const size_t n = comparison.cloud->size();
  const FieldTable& points = comparison.points;
  const auto numbers = [&](const char* name) {
    return column_of(points, name, ElementType::kUint32, 1, n).values<uint32_t>();
  };
  const auto reals = [&](const char* name) {
    return column_of(points, name, ElementType::kFloat64, 1, n).values<double>();
  };
  const auto codes = [&](const char* name) {
    return column_of(points, name, ElementType::kUint8, 1, n).values<uint8_t>();
  };
  column = numbers("column");
  line = numbers("row");
  zone = numbers(kZoneColumn);
  distance = reals("distance");
  sigma = reals("sigma");
  status = codes("status");
  reference_status = codes("reference_status");
  compared_status = codes("compared_status");
  cell_m = number_of(comparison.summary, "cell");
  systematic_m = number_of(comparison.summary, "systematic");
  first = vector_of(comparison.summary, "first_cell");
  up = vector_of(comparison.summary, "direction");
  u = vector_of(comparison.summary, "along_columns");
  v = cross(up, u);
  if (!(cell_m > 0) || !std::isfinite(cell_m))
    fail(Status::kInvalidArgument, "\"cell\" of the summary is no length");
  keys_.resize(n);
  for (size_t i = 0; i < n; ++i) keys_[i] = key_of(line[i], column[i]);
  if (std::adjacent_find(keys_.begin(), keys_.end(), std::greater_equal<>()) != keys_.end())
    fail(Status::kInvalidArgument, "the rows are not in the order of a grid's cells");
  for (const uint32_t label : zone)
    if (label > n) fail(Status::kInvalidArgument, "zone %u of %zu cells", label, n);
}

size_t CellTable::find(int64_t at_column, int64_t at_row) const {
  if (at_column < 0 || at_row < 0 || at_column > UINT32_MAX || at_row > UINT32_MAX) return kNone;
  const uint64_t key = key_of(static_cast<uint64_t>(at_row), static_cast<uint64_t>(at_column));
  const auto at = std::lower_bound(keys_.begin(), keys_.end(), key);
  return at != keys_.end() && *at == key ? static_cast<size_t>(at - keys_.begin()) : kNone;
}

Vec3 CellTable::corner(int64_t at_column, int64_t at_row, double height_m) const {
  const double along = (static_cast<double>(at_column) - 0.5) * cell_m,
               across = (static_cast<double>(at_row) - 0.5) * cell_m;
  return first + u * along + v * across + up * height_m;
}

}  // namespace jalon
