// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "geometry/vec.h"
#include "registration/icp/planes.h"

namespace jalon {

/// Which points of a cloud take part at a level of the coarse-to-fine search, and the tree over them.
struct IcpPoints {
  std::vector<uint32_t> positions;  ///< in the cloud's tree, ascending; empty: all of them
  double reach_m = 0;               ///< how far apart points of one surface may be sideways, besides the planes' radii

  size_t count(const SurfacePlanes& planes) const { return positions.empty() ? planes.size() : positions.size(); }
  uint32_t position(size_t i) const { return positions.empty() ? static_cast<uint32_t>(i) : positions[i]; }
};

/// Both clouds, and the pose between the frames of their trees.
struct IcpClouds {
  SurfacePlanes reference, moving;
  /// From a place of the moving frame to one of the reference frame. Both frames begin at the cubes' origins, so that
  /// large coordinates do not come in.
  Transform inner(const Transform& pose) const;
  Transform outer(const Transform& inner) const;
};

/// For each point of either side its nearest one of the other, as positions in the clouds' trees; kNoPoint: none near.
struct IcpNeighbours {
  Buffer<uint32_t> of_moving, of_reference;
};

/// Finds neighbours at one level; keeps what does not depend on the pose. Near an edge the nearest point often lies
/// around the corner: where its normal is more than an angle off, the nearest of some more that is not.
class IcpSearch {
 public:
  IcpSearch(const IcpClouds& clouds, const IcpPoints& reference, const IcpPoints& moving, double least_cosine,
            Task& task);
  IcpNeighbours find(const Transform& inner, double max_distance_m, Task& task) const;

 private:
  std::shared_ptr<const Octree> moved_tree(const Transform& inner, Buffer<double>& xyz, Task& task) const;
  void turn_corners(const Octree& moved, const Transform& inner, double max_distance_m, IcpNeighbours& found,
                    Task& task) const;
  uint32_t reference_position(uint32_t in_tree) const {
    return reference_.positions.empty() ? in_tree : reference_.positions[tree_->order()[in_tree]];
  }
  const IcpClouds& clouds_;
  const IcpPoints &reference_, &moving_;
  double least_cosine_;
  Buffer<double> xyz_;  // of the reference's points at this level, where they are not all
  std::shared_ptr<const Octree> tree_;
};

enum class IcpMetric : uint8_t { kPointToPoint, kPointToPlane, kPlaneToPlane };

/// When two neighbours are a pair.
struct PairRule {
  IcpMetric metric = IcpMetric::kPointToPlane;
  double most_m = 0;        ///< greatest residual
  double reach_m = 0;       ///< sideways, besides the plane's radius
  double least_cosine = 0;  ///< between the normals of both
  double plane_points = 16; ///< whose mean a plane is: for the noise that a residual should have
};

/// A moved point and a plane, or a moved plane and a point: residual is the moved side's height above the other's. Of
/// points alone it is their distance, and of two planes the distance that their shapes leave (Segal et al. 2009).
struct IcpPair {
  Vec3 place, normal;
  Vec3 offset;             ///< of the moved point from the other
  Vec3 other;              ///< the second plane's normal
  double residual_m = 0;
  double tilt_rad = 0;     ///< of the plane
  double variance_m2 = 0;  ///< that the residual should have
};

/// False when they are no pair. moved: the place of the moving point in the reference frame. from_moving: the plane is
/// the reference's and the raw point the moving one; else the other way round.
bool pair_of_shapes(const IcpClouds& clouds, const Transform& inner, uint32_t moving, uint32_t reference,
                    const PairRule& rule, IcpPair& out);

/// The same for any metric. Inline: it is the inner loop of an iteration.
inline bool pair_of(const IcpClouds& clouds, const Transform& inner, uint32_t moving, uint32_t reference,
                    bool from_moving, const PairRule& rule, IcpPair& out) {
  if (rule.metric != IcpMetric::kPointToPlane) return pair_of_shapes(clouds, inner, moving, reference, rule, out);
  const SurfacePlane &m = clouds.moving.planes[moving], &r = clouds.reference.planes[reference];
  if (!(m.sigma_m <= clouds.moving.flat_m) || !(r.sigma_m <= clouds.reference.flat_m)) return false;
  const Vec3 of_moving = inner.direction(m.unit()), of_reference = r.unit();
  const double cosine = dot(of_moving, of_reference);
  if (!(std::abs(cosine) >= rule.least_cosine)) return false;
  out.place = inner.point(clouds.moving.place(moving));
  const Vec3 d = out.place - clouds.reference.place(reference);
  const SurfacePlane& plane = from_moving ? r : m;
  out.normal = from_moving ? of_reference : of_moving;
  const double height = dot(out.normal, d);
  const double sideways2 = squared_norm(d) - height * height, reach = double{plane.radius_m} + rule.reach_m;
  if (sideways2 > reach * reach) return false;
  out.residual_m = from_moving ? height - plane.height_m : height + plane.height_m;
  if (!(std::abs(out.residual_m) <= rule.most_m)) return false;
  out.tilt_rad = plane.tilt_rad;
  const double point = from_moving ? m.sigma_m : r.sigma_m;
  const double scatter = plane.sigma_m, r2 = plane.radius_m * plane.radius_m;
  out.variance_m2 = point * point + scatter * scatter * (1 + 2 * sideways2 / r2) / rule.plane_points;
  return true;
}

/// A residual of a pair along one direction, and its share in the pair's weight.
struct PairTerm {
  Vec3 normal;
  double residual_m = 0, weight = 1;
};
/// Of points alone three, along the axes; of two planes three, along the axes of (C1 + C2)^-1 of their shapes. Point to
/// plane has one. How many.
size_t pair_terms(const IcpPair& pair, IcpMetric metric, PairTerm (&terms)[3]);

}  // namespace jalon
