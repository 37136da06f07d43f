// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangle_side.h"

#include <cmath>
#include <numbers>

#include "spatial/triangle_closest.h"
#include "spatial/triangle_descent.h"

namespace jalon {

namespace {

// Triangles touch a point when they are closer to it than this share of the whole mesh: some hundred roundings ...
constexpr double kRoundingShare = 0x1p-44;
// ... or than this share of the nearest triangle's longest side and of the distance: so that corners which meet a side
// but for the digits of a file (floats, 2^-24 of some ten metres) leave no gap.
constexpr double kGapShare = 0x1p-18;

using Corners = std::array<Vec3, 3>;

Corners corners_of(const TriangleBlock& block, uint32_t lane) {
  return {Vec3{block.a[0][lane], block.a[1][lane], block.a[2][lane]},
          Vec3{block.b[0][lane], block.b[1][lane], block.b[2][lane]},
          Vec3{block.c[0][lane], block.c[1][lane], block.c[2][lane]}};
}

ClosestResult<double> closest_to(const Corners& k, const Vec3& p) {
  return closest_on_triangle<double>({p.x, p.y, p.z}, {k[0].x, k[0].y, k[0].z}, {k[1].x, k[1].y, k[1].z},
                                     {k[2].x, k[2].y, k[2].z});
}

/// The normal against which the triangle runs anticlockwise; zero for one that has no plane.
Vec3 unit_normal(const Corners& corners, bool is_turned) {
  const Vec3 n = cross(corners[1] - corners[0], corners[2] - corners[0]);
  double longest2 = 0;
  for (size_t k = 0; k < 3; ++k) longest2 = std::max(longest2, squared_norm(corners[(k + 1) % 3] - corners[k]));
  if (!(squared_norm(n) > longest2 * longest2 * kFlattest2)) return {};
  return normalized(is_turned ? -n : n);
}

/// The angle that a triangle fills at a point which it touches: all around inside of it, half of that on a side.
double angle_at(const Corners& corners, const Vec3& at, double tolerance) {
  for (size_t k = 0; k < 3; ++k)
    if (norm(corners[k] - at) <= tolerance) {
      const Vec3 a = corners[(k + 1) % 3] - corners[k], b = corners[(k + 2) % 3] - corners[k];
      return std::atan2(norm(cross(a, b)), dot(a, b));
    }
  const ClosestResult<double> closest = closest_to(corners, at);
  const double nearest2 = std::min({closest.ab.squared, closest.ac.squared, closest.bc.squared});
  return nearest2 <= tolerance * tolerance ? std::numbers::pi : 2 * std::numbers::pi;
}

/// Sum over the triangles that touch the point of their normals times their angles.
Vec3 pseudo_normal(const TriangleBlocks& tree, const Vec3& at, double tolerance) {
  const double p[3] = {at.x, at.y, at.z}, limit2 = tolerance * tolerance;
  Vec3 sum;
  descend(tree.nodes, p, limit2, [&](uint32_t child) {
    const TriangleBlock& block = tree.blocks[child];
    for (uint32_t lane = 0; lane < block.count; ++lane) {
      const Corners corners = corners_of(block, lane);
      if (closest_to(corners, at).squared > limit2) continue;
      sum += angle_at(corners, at, tolerance) * unit_normal(corners, (block.turned >> lane & 1) != 0);
    }
    return limit2;
  });
  return sum;
}

double longest_side(const Corners& corners) {
  return std::max({norm(corners[1] - corners[0]), norm(corners[2] - corners[1]), norm(corners[0] - corners[2])});
}

}  // namespace

ClosestOfTriangle closest_of(const TriangleBlock& block, uint32_t lane, const Vec3& point) {
  const Corners corners = corners_of(block, lane);
  const ClosestResult<double> closest = closest_to(corners, point);
  if (closest.on_face) {
    const double share = closest.height / closest.normal2;
    const Vec3 above = Vec3{closest.normal.x, closest.normal.y, closest.normal.z} * share;
    return {TriangleFeature::kFace, point - above, above};
  }
  const SideResult<double>& side = closest.use_ab ? closest.ab : closest.use_ac ? closest.ac : closest.bc;
  const Vec3 above = {side.rest.x, side.rest.y, side.rest.z};
  if (!side.at_from && !side.at_to) return {TriangleFeature::kSide, point - above, above};
  const size_t from = closest.use_ab || closest.use_ac ? 0 : 1, to = closest.use_ab ? 1 : 2;
  return {TriangleFeature::kCorner, corners[side.at_from ? from : to], above};
}

bool is_behind(const TriangleBlocks& tree, const TriangleBlock& block, uint32_t lane, const ClosestOfTriangle& closest,
               double span_m) {
  const Corners corners = corners_of(block, lane);
  const Vec3 own = unit_normal(corners, (block.turned >> lane & 1) != 0);
  if (closest.feature == TriangleFeature::kFace) return dot(closest.above, own) < 0;
  const double gap = kGapShare * std::min(longest_side(corners), norm(closest.above));
  const double side = dot(closest.above, pseudo_normal(tree, closest.foot, gap + kRoundingShare * span_m));
  // Normals that cancel (a sheet folded onto itself, triangles that run both ways around): that of the triangle itself.
  return side != 0 ? side < 0 : dot(closest.above, own) < 0;
}

}  // namespace jalon
