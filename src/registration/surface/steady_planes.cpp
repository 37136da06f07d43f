// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/surface/steady_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloud/neighbour_planes.h"

namespace jalon {

namespace {

constexpr uint32_t kTimesAsMany = 3;
constexpr double kSteady = 0.9;  // cosine of the turn: 26 degrees

}  // namespace

SurfacePlanes steady_planes(const SurfacePlanes& surface, uint32_t k, Task& task) {
  SurfacePlanes out{surface.tree, Buffer<SurfacePlane>(surface.size()), surface.noise_m,
                    surface.flat_m, surface.radius_m};
  std::copy(surface.planes.data(), surface.planes.data() + surface.size(), out.planes.data());
  const auto many =
      static_cast<uint32_t>(std::min<size_t>(size_t{kTimesAsMany} * k, surface.tree->size()));
  SurfacePlane* planes = out.planes.data();
  surface.tree->for_each_knn(many, task, [&](const Octree::Batch& b) {
    const auto compare = [&](const NeighbourPlane& wide) {
      SurfacePlane& plane = planes[wide.position];
      const bool is_steady =
          wide.normal != nullptr &&
          std::abs(dot(plane.unit(), {wide.normal[0], wide.normal[1], wide.normal[2]})) >= kSteady;
      if (!is_steady) plane.sigma_m = std::numeric_limits<float>::infinity();
    };
    NeighbourPlanes<decltype(compare)> wide(*surface.tree, compare);
    for (size_t i = 0; i < b.count; ++i) wide.add(b.first + i, b.neighbours + i * b.k, many);
    wide.flush();
  });
  return out;
}

}  // namespace jalon
