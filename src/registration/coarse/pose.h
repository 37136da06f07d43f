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

/// The rigid motion T_to_from that lays points onto others with least squares (Arun, Huang &
/// Blostein 1987), a rotation even where the points are mirrored or flat. Before: the same number,
/// at least 1.
Transform closest_motion(std::span<const Vec3> from, std::span<const Vec3> to);

/// How much of two surfaces a pose lays onto each other: weighted shares.
struct SurfaceOverlap {
  double of_moving = 0, of_reference = 0;
  double count =
      0;  ///< what lies on the other surface, of both: DARCES' overlapping number, by weight
  double likeness =
      0;  ///< share of the salient places that come near the other surface and look alike there
  double salient = 0;    ///< share of all salient places that come near it
  size_t pairs = 0;      ///< asked points that lie on the other surface
  double rms_m = 0;      ///< off the planes of what lies on the other surface
  double scatter_m = 0;  ///< of the surfaces' own cells about these planes
  /// Two clouds that have little in common can be laid on each other with more of their planes than truly belong
  /// together; but then edges come to lie in the middle of planes.
  double score() const { return count * likeness; }
};

/// A pose after its iterations.
struct SettledPose {
  Transform T_reference_moving;
  Square<6> fixed{};  ///< normal equations of the last iteration, about the moving centroid
};

/// Scores and settles poses between the surfaces' own frames. Copies nothing; threads may share it.
///
/// Before: features are described and weights balanced; the surfaces outlive the judge. After:
/// nothing depends on chance or on the number of threads. O(s log n) a pose, for s points asked.
class PoseJudge {
 public:
  /// most: points of each surface that are asked, evenly taken.
  PoseJudge(const CoarseSurface& reference, const CoarseSurface& moving, size_t most);

  /// A point lies on the other surface when its nearest cell there is within `reach` cells, its
  /// plane within `off_plane` cells and their normals agree.
  SurfaceOverlap overlap(const Transform& T_reference_moving, double reach, double off_plane) const;
  /// Point-to-plane iterations (Chen & Medioni 1992) from this pose, the reach shrinking from
  /// `first` to `last` cells; directions that nothing fixes stay. Fewer iterations where too little
  /// meets.
  SettledPose settled(const Transform& T_reference_moving, double first, double last,
                      int iterations) const;
  /// Largest distance (m) between where two poses put the moving surface.
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
  // T_other_side: to the frame of the other surface.
  Likeness likeness(const Side& side, const Transform& T_other_side, const CoarseSurface& other,
                    double reach) const;
  struct Laid {
    double weight = 0, squares = 0, scatter = 0;
    size_t n = 0;
  };
  Laid laid_on(const Side& side, const Transform& T_other_side, const CoarseSurface& other,
               double reach, double off_plane) const;
  struct Step {
    Square<6> normal{};
    bool moved = false;  ///< else too little meets, or it fixes nothing
  };
  Step step(MotionModel& model, double reach) const;

  Side reference_, moving_;
  std::vector<Vec3> corners_;
};

}  // namespace jalon
