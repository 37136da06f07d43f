// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "segment/picks/picks.h"
#include "segment/surface/primitive_fits.h"

namespace jalon {

/// The free points of a cloud, in coordinates relative to the first pick's whole metres.
struct PickScene {
  const Cloud& cloud;
  std::span<const uint32_t> labels;  ///< 0 = free
  Vec3 origin;
  PickSettings setting;
  std::vector<Vec3> picks;  ///< local
  Vec3 local(size_t i) const { return cloud.point(i) - origin; }
};

/// A segment in the making: its surface in local coordinates and the indices of its points.
struct Picked {
  Segment segment;
  std::vector<uint32_t> members;
};

Picked pick_plane(const PickScene& scene, Task& task);
Picked pick_sphere(const PickScene& scene, Task& task);
Picked pick_cylinder(const PickScene& scene, Task& task);

}  // namespace jalon
