// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangles/side.h"

#include <cmath>
#include <numbers>

#include "base/simd.h"
#include "spatial/triangles/closest.h"
#include "spatial/triangles/descent.h"

namespace jalon {

namespace {

// Beside kTouchingShare, of the nearest triangle's longest side and of the distance: so that corners which meet a side
// but for the digits of a file (floats, 2^-24 of some ten metres) leave no gap.
constexpr double kGapShare = 0x1p-18;

using SideCorners = std::array<Vec3, 3>;

SideCorners corners_of(const TriangleBlock& block, uint32_t lane) {
  const auto corner = [&](uint8_t at) {
    return Vec3{block.corners[at], block.corners[at + 1], block.corners[at + 2]};
  };
  return {corner(block.a[lane]), corner(block.b[lane]), corner(block.c[lane])};
}

ClosestResult<double> closest_to(const SideCorners& k, const Vec3& p) {
  return closest_on_triangle<double>({p.x, p.y, p.z}, {k[0].x, k[0].y, k[0].z},
                                     {k[1].x, k[1].y, k[1].z}, {k[2].x, k[2].y, k[2].z});
}

/// The normal against which the triangle runs anticlockwise; zero for one that has no plane.
Vec3 unit_normal(const SideCorners& corners, bool is_turned) {
  const Vec3 n = cross(corners[1] - corners[0], corners[2] - corners[0]);
  double longest2 = 0;
  for (size_t k = 0; k < 3; ++k)
    longest2 = std::max(longest2, squared_norm(corners[(k + 1) % 3] - corners[k]));
  if (!(squared_norm(n) > longest2 * longest2 * kFlattest2)) return {};
  return normalized(is_turned ? -n : n);
}

/// What touches a point of a surface: the sum of normals times angles, and the sides that leave it.
class Surroundings {
 public:
  Surroundings(const Vec3& at, double tolerance)
      : at_(at), tolerance_(tolerance), surely_beyond2_(tolerance * tolerance * kRootRounding) {}

  /// A triangle that touches the point, or a stack of them; one without a plane says nothing.
  void add(const SideCorners& corners, bool is_turned, const TriangleStack& stack) {
    Vec3 normal = unit_normal(corners, is_turned);
    if (normal == Vec3{}) return;
    const int balance = stack.alike - stack.reversed, to_left = is_turned ? -balance : balance,
              count = stack.alike + stack.reversed;
    normal *= static_cast<double>(balance);
    // 1. At a corner: two sides leave it. Walked anticlockwise, the triangle is to the left of the one to the next.
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 apart = corners[k] - at_;
      if (squared_norm(apart) > surely_beyond2_ || !(norm(apart) <= tolerance_)) continue;
      const Vec3 a = corners[(k + 1) % 3] - corners[k], b = corners[(k + 2) % 3] - corners[k];
      normals_ += normal * std::atan2(norm(cross(a, b)), dot(a, b));
      add_spoke(a, to_left, count);
      add_spoke(b, -to_left, count);
      return;
    }
    // 2. On a side, which leaves it both ways.
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 a = corners[k] - at_, b = corners[(k + 1) % 3] - at_,
                 along = corners[(k + 1) % 3] - corners[k];
      const Vec3 area = cross(a, along);
      if (squared_norm(area) > surely_beyond2_ * squared_norm(along) ||
          !(norm(area) <= tolerance_ * norm(along)))
        continue;
      normals_ += normal * std::numbers::pi;
      add_spoke(b, to_left, count);
      add_spoke(a, -to_left, count);
      return;
    }
    // 3. Inside of it.
    normals_ += normal * (2 * std::numbers::pi);
  }
  const Vec3& normals() const { return normals_; }
  /// Around a point of a surface that runs one way around, each side has as many triangles to its left as to its right.
  TriangleSide basis() const {
    bool has_border = false;
    for (size_t i = 0; i < spokes_; ++i) {
      if (spoke_[i].triangles % 2 != 0) has_border = true;
      else if (spoke_[i].balance != 0) return TriangleSide::kInconsistent;
    }
    return has_border ? TriangleSide::kBorder : TriangleSide::kCertain;
  }

 private:
  // Sides in one direction: the cosine of 1e-5, or a hundred times the angle of a gap.
  static constexpr double kSameDirection = 1 - 5e-11;
  // Squares are compared before roots are taken: many triangles may touch a point.
  static constexpr double kRootRounding = 1 + 0x1p-40;
  static constexpr size_t kMaxSpokes = 64;  // more: the sides of the first ones are judged

  struct Spoke {
    Vec3 direction;
    int balance, triangles;
  };

  void add_spoke(const Vec3& side, int to_left, int triangles) {
    const double length2 = squared_norm(side);
    for (size_t i = 0; i < spokes_; ++i)
      if (const double along = dot(spoke_[i].direction, side);
          along > 0 && along * along >= kSameDirection * kSameDirection * length2) {
        spoke_[i].balance += to_left;
        spoke_[i].triangles += triangles;
        return;
      }
    if (spokes_ < kMaxSpokes) spoke_[spokes_++] = {normalized(side), to_left, triangles};
  }

  Vec3 at_;
  double tolerance_, surely_beyond2_;
  Vec3 normals_;
  std::array<Spoke, kMaxSpokes> spoke_;
  size_t spokes_ = 0;
};

Surroundings surroundings(const TouchingTriangles& touching, const Vec3& at, double gap_m) {
  const TriangleBlocks& tree = touching.tree;
  const double tolerance = gap_m + kTouchingShare * touching.span_m;
  Surroundings found(at, tolerance);
  const auto leaf_distances = use_avx2() ? leaf_distances_avx2 : leaf_distances_baseline;
  const double p[3] = {at.x, at.y, at.z}, limit2 = tolerance * tolerance;
  descend(
      tree.nodes, p, limit2,
      [&](uint32_t child) {
        const TriangleBlock& block = tree.blocks[child];
        double squared[triangle_tree::kWidth];
        leaf_distances(block, p, squared);
        for (uint32_t lane = 0; lane < block.count; ++lane) {
          if (squared[lane] <= limit2)
            found.add(corners_of(block, lane), (block.turned >> lane & 1) != 0,
                      touching.stacks != nullptr
                          ? touching.stacks[triangle_tree::kWidth * child + lane]
                          : TriangleStack{});
        }
        return limit2;
      },
      [](uint32_t) { return false; });
  return found;
}

double longest_side(const SideCorners& corners) {
  return std::max({norm(corners[1] - corners[0]), norm(corners[2] - corners[1]),
                   norm(corners[0] - corners[2])});
}

}  // namespace

ClosestOfTriangle closest_of(const TriangleBlock& block, uint32_t lane, const Vec3& point) {
  const SideCorners corners = corners_of(block, lane);
  const ClosestResult<double> closest = closest_to(corners, point);
  if (closest.on_face) {
    const double share = closest.height / closest.normal2;
    const Vec3 above = Vec3{closest.normal.x, closest.normal.y, closest.normal.z} * share;
    return {TriangleFeature::kFace, point - above, above};
  }
  const SideResult<double>& side = closest.use_ab   ? closest.ab
                                   : closest.use_ac ? closest.ac
                                                    : closest.bc;
  const Vec3 above = {side.rest.x, side.rest.y, side.rest.z};
  if (!side.at_from && !side.at_to) return {TriangleFeature::kSide, point - above, above};
  const size_t from = closest.use_ab || closest.use_ac ? 0 : 1, to = closest.use_ab ? 1 : 2;
  return {TriangleFeature::kCorner, corners[side.at_from ? from : to], above};
}

SideOfSurface side_of_surface(const TouchingTriangles& touching, const TriangleBlock& block,
                              uint32_t lane, const ClosestOfTriangle& closest) {
  const SideCorners corners = corners_of(block, lane);
  const bool behind_own =
      dot(closest.above, unit_normal(corners, (block.turned >> lane & 1) != 0)) < 0;
  if (closest.feature == TriangleFeature::kFace) return {behind_own, TriangleSide::kCertain};
  const double gap = kGapShare * std::min(longest_side(corners), norm(closest.above));
  const Surroundings found = surroundings(touching, closest.foot, gap);
  const TriangleSide basis = found.basis();
  const double side = dot(closest.above, found.normals());
  // Where triangles run both ways around, or normals cancel (a sheet folded onto itself), the nearest one decides.
  return {basis == TriangleSide::kInconsistent || side == 0 ? behind_own : side < 0, basis};
}

}  // namespace jalon
