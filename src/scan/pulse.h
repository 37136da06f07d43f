// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/random.h"
#include "scan/static_settings.h"
#include "scan/surfaces.h"
#include "spatial/triangles/tree.h"

namespace jalon {

/// What comes back of one pulse, before noise.
struct Echo {
  double range = 0;
  uint32_t triangle = 0;  ///< of the face that gives most of it
  bool is_mixed = false;  ///< made of several true planes
};

/// Sends pulses: a line, or a cone of sub-rays; glass lets some of them through.
///
/// Sub-rays stand for equal areas of the beam's cross-section and return the cosine of their incidence (Lambert).
/// Those within the range resolution of the nearest of them make one return, at their weighted mean range: the mixed
/// pixels at edges (Boehler & Marbs 2005).
class PulseCaster {
 public:
  PulseCaster(const StaticSettings& settings, const TriangleTree& tree, const Surfaces& surfaces);

  /// direction: unit vector of the beam's axis. random: decides at panes, the same for all sub-rays.
  bool send(const Vec3& eye, const Vec3& direction, const RandomStream& random, Echo& echo) const;

 private:
  /// First surface on the line that is not passed through.
  bool hit(Ray ray, RandomStream random, RayHit& out) const;
  bool sub_hit(const Vec3& eye, const Vec3& direction, size_t k, const RandomStream& random,
               RayHit& out) const;
  Echo merged(std::span<RayHit> hits, const Vec3& direction) const;

  const StaticSettings& settings_;
  const TriangleTree& tree_;
  const Surfaces& surfaces_;
  std::vector<Vec2>
      offsets_;  ///< of the sub-rays in the unit disc; the axis, then from the rim inward
};

}  // namespace jalon
