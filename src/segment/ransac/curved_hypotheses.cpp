// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/curved_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

constexpr uint64_t kCurvedStream = 0x63757276;  // keeps these draws apart from those of planes
constexpr int kCurvedHypothesesSeedTries = 32;
constexpr int kCurvedHypothesesTries = 8;  // for a free point in a cell
constexpr int kCurvedHypothesesLevelsUp =
    5;                          // cells drawn from: the point's own level and up to four above
constexpr size_t kSample = 64;  // points of the cell that test and refine a hypothesis
constexpr size_t kLeastSample = 12;
constexpr double kMinSupport = 0.5;  // share of them that must lie on the surface
// Thickness of a cell, in tolerances, above which its points tell a radius: what is flatter counts as a plane
// (local_surface.cpp).
constexpr double kLeastBend = 0.5;
constexpr double kCurvedHypothesesLeastGain =
    2;  // rms about the best plane against rms about the curved surface
// A closed cylinder is longest along its axis from this ratio of variances on (geometry/cylinder.cpp).
constexpr double kLeastElongation = 1.5;

/// How a draw makes its surface (Boulaassal 2010, C.1): two points with normals, or points alone, which need no
/// neighbours and so reach radii that the spacing of the points is coarse for.
enum class Recipe { kSphereOfNormals, kSphereOfPoints, kCylinderOfNormals, kCylinderOfPoints };

Recipe recipe_of(const SurfaceSettings& settings, uint64_t draw) {
  const bool points_alone = draw % 2 == 1;
  const bool sphere = settings.spheres() && (!settings.cylinders() || draw % 4 < 2);
  if (sphere) return points_alone ? Recipe::kSphereOfPoints : Recipe::kSphereOfNormals;
  return points_alone ? Recipe::kCylinderOfPoints : Recipe::kCylinderOfNormals;
}

bool pick_seed_of_curved_hypotheses(const SegmentScene& scene, const PointPool& pool,
                                    RandomStream& random, uint32_t& seed) {
  if (pool.slots() == 0) return false;  // nothing to draw from
  for (int i = 0; i < kCurvedHypothesesSeedTries; ++i) {
    seed = pool.position(static_cast<uint32_t>(random.below(pool.slots())));
    if (seed != kNoPoint && scene.may_seed_curved(seed)) return true;
  }
  return false;
}

Octree::Cell cell_at(const SegmentScene& scene, uint32_t position, int levels_up) {
  const int level = std::max(scene.coarse_level, scene.level[position] - levels_up);
  return scene.cell_around(level, position);
}

// An even sample of the cell's free points.
std::vector<Vec3> sample_of(const SegmentScene& scene, const Octree::Cell& cell) {
  std::vector<Vec3> out;
  const size_t step = std::max<size_t>(1, cell.count / kSample);
  for (size_t i = cell.first; i < cell.first + cell.count; i += step)
    if (scene.owner[i] == 0) out.push_back(scene.local(i));
  return out;
}

Moments moments_of(std::span<const Vec3> points) {
  Moments moments;
  moments.reference = points[0];
  for (const Vec3& p : points) moments.add(p);
  return moments;
}

struct Oriented {
  Vec3 point, normal;
};

// Where the surface is and points around a position: centroid and normal of its own cell belong together, while the
// position itself may lie at the side of the cell, where a curved surface has turned away. A given normal is the
// point's.
bool oriented_at(const SegmentScene& scene, uint32_t position, Oriented& out) {
  const float* n = &scene.normals[3 * size_t{position}];
  if (scene.settings.normals == NormalSource::kField && !std::isnan(n[0])) {
    out = {scene.local(position), {n[0], n[1], n[2]}};
    return true;
  }
  const std::vector<Vec3> points = sample_of(scene, cell_at(scene, position, 0));
  if (points.size() < 3) return false;
  PlaneFit fit;
  if (!fit_plane(moments_of(points), fit)) return false;
  out = {fit.centroid, fit.plane.normal};
  return true;
}

bool pick_oriented(const SegmentScene& scene, const Octree::Cell& cell, RandomStream& random,
                   Oriented& out) {
  for (int i = 0; i < kCurvedHypothesesTries; ++i) {
    const size_t p = cell.first + random.below(cell.count);
    if (scene.owner[p] == 0) return oriented_at(scene, static_cast<uint32_t>(p), out);
  }
  return false;
}

bool from_normals(const SegmentScene& scene, uint32_t seed, const Octree::Cell& cell, bool sphere,
                  RandomStream& random, Curved& out) {
  Oriented a, b;
  if (!oriented_at(scene, seed, a) || !pick_oriented(scene, cell, random, b)) return false;
  if (sphere) {
    Sphere found;
    if (!sphere_from_normals(a.point, a.normal, b.point, b.normal, found)) return false;
    out = Curved(found);
    return true;
  }
  Cylinder found;
  if (!cylinder_from_normals(a.point, a.normal, b.point, b.normal, found)) return false;
  out = Curved(found);
  return true;
}

// A sphere through four points of the sample; a cylinder along its longest direction through three.
bool from_points(std::span<const Vec3> sample, const Eigen3& spread, bool sphere,
                 RandomStream& random, Curved& out) {
  std::array<Vec3, 4> points;
  for (Vec3& p : points) p = sample[random.below(sample.size())];
  if (sphere) {
    Sphere found;
    if (!sphere_through(points, found)) return false;
    out = Curved(found);
    return true;
  }
  if (!(spread.values[2] > kLeastElongation * spread.values[1])) return false;
  Cylinder found;
  if (!cylinder_along(spread.vectors[2], std::span<const Vec3>(points.data(), 3), found))
    return false;
  out = Curved(found);
  return true;
}

bool allows(const SurfaceSettings& settings, double radius_m) {
  return radius_m >= settings.min_radius_m && radius_m <= settings.max_radius_m;
}

// The points of the sample on the surface; empty when they are too few of them.
std::vector<Vec3> support_of(const SegmentScene& scene, std::span<const Vec3> sample,
                             const Curved& curved) {
  std::vector<Vec3> out;
  for (const Vec3& p : sample)
    if (std::fabs(curved.distance(p)) <= scene.settings.distance_tolerance_m) out.push_back(p);
  const bool enough =
      out.size() >= kLeastSample &&
      static_cast<double>(out.size()) >= kMinSupport * static_cast<double>(sample.size());
  if (!enough) out.clear();
  return out;
}

// Least squares on the cell's points near the surface; false when a plane fits them nearly as well.
bool refine(const SegmentScene& scene, std::span<const Vec3> sample, Task& task, Curved& curved) {
  std::vector<Vec3> support = support_of(scene, sample, curved);
  if (support.empty()) return false;
  PrimitiveSetting setting;
  setting.robust = false;
  setting.min_radius_m = scene.settings.min_radius_m;
  setting.max_radius_m = scene.settings.max_radius_m;
  Segment fitted;
  if (!adjust_curved(support, curved, setting, task, fitted)) return false;
  curved = curved_of(fitted);
  support = support_of(scene, sample, curved);
  if (support.empty()) return false;
  const Eigen3 spread = symmetric_eigen(moments_of(support).covariance());
  double squares = 0;
  for (const Vec3& p : support) squares += curved.distance(p) * curved.distance(p);
  return spread.values[0] >= kCurvedHypothesesLeastGain * kCurvedHypothesesLeastGain * squares /
                                 static_cast<double>(support.size());
}

}  // namespace

CurvedTest curved_test(const SegmentScene& scene, const Curved& c, double cell_edge_m,
                       double tolerance_m) {
  const double inner = std::max(0.0, c.radius - tolerance_m), outer = c.radius + tolerance_m;
  const double turn = scene.settings.normal_tolerance_rad + cell_edge_m / (2 * c.radius);
  const double cosine =
      scene.settings.uses_normals() && turn < std::numbers::pi / 2 ? std::cos(turn) : 0.0;
  return {static_cast<float>(c.centre.x),     static_cast<float>(c.centre.y),
          static_cast<float>(c.centre.z),     static_cast<float>(c.axis.x),
          static_cast<float>(c.axis.y),       static_cast<float>(c.axis.z),
          static_cast<float>(inner * inner),  static_cast<float>(outer * outer),
          static_cast<float>(cosine * cosine)};
}

bool curved_inconsistent(const SegmentScene& scene, const Curved& curved, size_t position) {
  const double edge = scene.cell_edge_m(position);
  const double turn = scene.settings.normal_tolerance_rad + edge / (2 * curved.radius);
  if (!scene.settings.uses_normals() || !(turn < std::numbers::pi / 2)) return false;
  return scene.inconsistent(position, normalized(curved.outward(scene.local(position))),
                            std::cos(turn));
}

// 1. a free point at random; 2. a cell of a random level around it whose points bend; 3. a sphere or a cylinder from
// two points with normals or from points alone; 4. tested and refined on the cell's points, which no plane may fit
// nearly as well.
bool draw_curved(const RansacScene& scene, const PointPool& pool, uint64_t draw, Task& task,
                 Candidate& out) {
  RandomStream random(scene.draw.seed ^ kCurvedStream, draw);
  Candidate candidate;
  if (!pick_seed_of_curved_hypotheses(scene, pool, random, candidate.seed)) return false;
  const Octree::Cell cell =
      cell_at(scene, candidate.seed, static_cast<int>(random.below(kCurvedHypothesesLevelsUp)));
  const std::vector<Vec3> sample = sample_of(scene, cell);
  if (sample.size() < kLeastSample) return false;
  const Eigen3 spread = symmetric_eigen(moments_of(sample).covariance());
  const double bend = kLeastBend * scene.settings.distance_tolerance_m;
  if (!(spread.values[0] > bend * bend)) return false;
  const Recipe recipe = recipe_of(scene.settings, draw);
  const bool sphere = recipe == Recipe::kSphereOfNormals || recipe == Recipe::kSphereOfPoints;
  const bool normals = recipe == Recipe::kSphereOfNormals || recipe == Recipe::kCylinderOfNormals;
  const bool made =
      normals ? from_normals(scene, candidate.seed, cell, sphere, random, candidate.curved)
              : from_points(sample, spread, sphere, random, candidate.curved);
  if (!made || !allows(scene.settings, candidate.curved.radius)) return false;
  const double seed_m = candidate.curved.distance(scene.local(candidate.seed));
  if (std::fabs(seed_m) > scene.settings.distance_tolerance_m) return false;
  if (!refine(scene, sample, task, candidate.curved)) return false;
  out = candidate;
  return true;
}

}  // namespace jalon
