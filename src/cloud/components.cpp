// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/components.h"

#include <cmath>

#include "cloud/operations.h"

namespace jalon {

namespace {

constexpr ParamRow kRows[] = {
    number_row("cell_m", 0.1, 1e-6, 1e6, "m", "",
               "Edge length of the grid cells: points closer than this are connected (26); not "
               "read when level is 0 or more"),
    integer_row("level", -1, -1, kMaxLevel, "", "",
                "Take the cells of this octree level (0 = the whole cube, 21 = smallest) "
                "instead of cell_m; -1 = use cell_m"),
    choice_row("connectivity", "26", "6|18|26", "",
               "Neighbours of a cell: those that share a face (6), also an edge (18), also a corner (26)"),
    integer_row("min_points", 10, 1, 1e15, "points", "", "Components of fewer points get the number 0"),
};

}  // namespace

std::span<const ParamRow> components_rows() { return kRows; }

Cloud with_components(const Cloud& cloud, const ParamSet& options, Task& task, uint64_t& count) {
  Cube cube;
  double cell_m = options.number("cell_m");
  if (cloud.size() != 0) {
    Span span(task, 0, 0.1);
    const int64_t level = options.integer("level");
    cube = level >= 0 ? cloud.octree(task)->cube() : enclosing_cube(bounds(cloud, task));
    if (level >= 0) cell_m = std::ldexp(cube.edge, -static_cast<int>(level));
  }
  Span span(task, 0.1, 1);
  const std::string& text = options.text("connectivity");
  const Connectivity3 connectivity = text == "6"    ? Connectivity3::k6
                                     : text == "18" ? Connectivity3::k18
                                                    : Connectivity3::k26;
  const Components components = connected_components(cloud.xyz(), cube.origin, cell_m, connectivity,
                                                     static_cast<uint64_t>(options.integer("min_points")), task);
  Cloud out = cloud;
  out.fields.set(make_column<uint32_t>(
      {"component", ElementType::kUint32, 1, "", "connected component, 1 = largest, 0 = too small"},
      components.labels));
  count = components.count();
  return out;
}

}  // namespace jalon
