// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/error.h"
#include "base/setting_rows.h"
#include "cloud/operations.h"

namespace jalon {

namespace {

/// The points that take part, ascending, and their coordinates.
struct Chosen {
  std::vector<uint64_t> points;
  std::vector<double> xyz;
};

Chosen points_with_value(const Cloud& cloud, const std::string& field, double value) {
  const Column& column = cloud.fields.require(field);
  if (column.info().components != 1)
    fail(Status::kInvalidArgument, "field \"%s\" has %u components; one is needed", field.c_str(),
         column.info().components);
  Chosen out;
  visit(column.info().type, [&](auto zero) {
    const auto values = column.values<decltype(zero)>();
    for (size_t i = 0; i < values.size(); ++i)
      if (static_cast<double>(values[i]) == value) out.points.push_back(i);
  });
  for (const uint64_t i : out.points)
    out.xyz.insert(out.xyz.end(), cloud.xyz().begin() + static_cast<ptrdiff_t>(3 * i),
                   cloud.xyz().begin() + static_cast<ptrdiff_t>(3 * i + 3));
  return out;
}

}  // namespace

std::span<const ParamRow> components_rows() {
  using S = ComponentsSettings;
  static constexpr auto kRows = setting_rows(
      number_row<&S::cell_m>("cell_m", 1e-6, 1e6, "m", "",
                             "Edge length of the grid cells: points closer than this are connected "
                             "(26); not read when level is 0 or more"),
      integer_row<&S::level>("level", -1, kMaxLevel, "", "",
                             "Take the cells of this octree level (0 = the whole cube, 21 = "
                             "smallest) instead of cell_m; -1 = use cell_m"),
      choice_row<&S::connectivity>("connectivity", "6|18|26", "",
                                   "Neighbours of a cell: those that share a face (6), also an "
                                   "edge (18), also a corner (26)"),
      integer_row<&S::min_points>("min_points", 1, 1e15, "points", "",
                                  "Components of fewer points get the number 0"),
      string_row<&S::field>(
          "field", "",
          "Connect only the points whose field of this name has the value below (\"changed\" and 1 "
          "for those that a filter found); the others get the number 0; empty = all points"),
      number_row<&S::value>("value", -1e300, 1e300, "", "", "The value that the field must have"));
  return kRows;
}

Cloud with_components(const Cloud& cloud, const ComponentsSettings& settings, Task& task,
                      uint64_t& count) {
  Cube cube;
  double cell_m = settings.cell_m;
  if (cloud.size() != 0) {
    ProgressSpan span(task, 0, 0.1);
    const bool by_level = settings.level >= 0;
    cube = by_level ? cloud.octree(task)->cube() : enclosing_cube(bounds(cloud, task));
    if (by_level) cell_m = std::ldexp(cube.edge, -settings.level);
  }
  ProgressSpan span(task, 0.1, 1);
  const auto connected = [&](std::span<const double> xyz) {
    return connected_components(xyz, cube.origin, cell_m, settings.connectivity,
                                settings.min_points, task);
  };
  Components components;
  if (settings.field.empty()) {
    components = connected(cloud.xyz());
  } else {
    const Chosen chosen = points_with_value(cloud, settings.field, settings.value);
    components = connected(chosen.xyz);
    std::vector<uint32_t> labels(cloud.size(), 0);
    for (size_t i = 0; i < chosen.points.size(); ++i)
      labels[chosen.points[i]] = components.labels[i];
    components.labels = std::move(labels);
  }
  Cloud out = cloud;
  out.fields.set(make_column<uint32_t>(
      {"component", ElementType::kUint32, 1, "", "connected component, 1 = largest, 0 = too small"},
      components.labels));
  count = components.count();
  return out;
}

}  // namespace jalon
