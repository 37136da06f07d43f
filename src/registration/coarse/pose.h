// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/cholesky.h"
#include "geometry/rigid_motion.h"
#include "registration/coarse/surface.h"

namespace jalon {

/// The rigid motion that lays points onto others with least squares (Arun, Huang & Blostein 1987), a rotation even
/// where the points are mirrored or flat. from, to: the same number, at least 1.
Transform closest_motion(std::span<const Vec3> from, std::span<const Vec3> to);

/// How much of two surfaces a pose lays onto each other: weighted shares.
struct Overlap {
  double of_moving = 0, of_reference = 0;
  double count = 0;      ///< what lies on the other surface, of both: DARCES' overlapping number, by weight
  double likeness = 0;   ///< share of the salient places that come near the other surface and look alike there
  double salient = 0;    ///< share of all salient places that come near it
  size_t pairs = 0;      ///< asked points that lie on the other surface
  double rms_m = 0;      ///< off the planes of what lies on the other surface
  double scatter_m = 0;  ///< of the surfaces' own cells about these planes
  /// Two clouds that have little in common can be laid on each other with more of their planes than truly belong
  /// together; but then edges come to lie in the middle of planes.
  double score() const { return count * likeness; }
};

/// Scores and settles poses T_reference_moving, both in the surfaces' own frames. Copies nothing; threads may share it.
class PoseJudge {
 public:
  /// most: points of each surface that are asked, evenly taken.
  PoseJudge(const CoarseSurface& reference, const CoarseSurface& moving, size_t most);

  /// A point lies on the other surface when its nearest cell there is within `reach` cells, its plane within
  /// `off_plane` cells and their normals agree.
  Overlap overlap(const Transform& pose, double reach, double off_plane) const;
  /// Point-to-plane iterations (Chen & Medioni 1992) from this pose, the reach shrinking from `first` to `last` cells;
  /// directions that nothing fixes stay. fixed: the normal equations of the last one about the moving centroid.
  Transform settled(const Transform& pose, double first, double last, int iterations, Square<6>* fixed = nullptr) const;
  /// Largest distance between where two poses put the moving surface.
  double difference(const Transform& a, const Transform& b) const;

 private:
  struct Side {
    const CoarseSurface* surface;
    std::vector<uint32_t> sample, salient;
    double weight = 0;
  };
  struct Likeness {
    size_t near = 0, alike = 0;
  };
  Likeness likeness(const Side& side, const Transform& motion, const CoarseSurface& other, double reach) const;
  struct Laid {
    double weight = 0, squares = 0, scatter = 0;
    size_t n = 0;
  };
  Laid laid_on(const Side& side, const Transform& motion, const CoarseSurface& other, double reach,
               double off_plane) const;
  bool step(MotionModel& model, double reach, Square<6>& normal) const;

  Side reference_, moving_;
  std::vector<Vec3> corners_;
};

}  // namespace jalon
