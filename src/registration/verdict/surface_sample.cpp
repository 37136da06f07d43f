// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/surface_sample.h"

namespace jalon {

std::vector<Surfel> sample_surface(const SurfacePlanes& surface, size_t most_cells, Task& task) {
  std::vector<Surfel> out;
  const int level = deepest_level(*surface.tree, most_cells, task);
  for (const uint32_t position : flattest_points(surface, level, task)) {
    const SurfacePlane& plane = surface.planes[position];
    out.push_back({surface.place(position), plane.unit(), plane.radius_m, position, -1});
  }
  return out;
}

}  // namespace jalon
