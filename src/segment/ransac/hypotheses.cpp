// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/hypotheses.h"

#include <algorithm>

#include "base/random.h"
#include "segment/ransac/curved_hypotheses.h"

namespace jalon {

namespace {

constexpr int kHypothesesTries = 8;  // for a free point in a cell
constexpr int kHypothesesLevelsUp =
    3;                               // cells drawn from: the point's own level and up to two above
constexpr size_t kLocalSample = 48;  // points of the cell that test and refine a hypothesis
constexpr double kMinLocalSupport = 0.5;  // share of them that must lie on the plane
constexpr double kMinSpread = 2;          // distance of the three points, in tolerances
constexpr double kNarrow = 0.2;  // width of the bounds, relative, at which scoring may stop
constexpr int kHypothesesSeedTries = 32;

bool pick_seed_of_hypotheses(const SegmentScene& scene, const PointPool& pool, RandomStream& random,
                             uint32_t& seed) {
  if (pool.slots() == 0) return false;  // nothing to draw from
  for (int i = 0; i < kHypothesesSeedTries; ++i) {
    seed = pool.position(static_cast<uint32_t>(random.below(pool.slots())));
    if (seed != kNoPoint && scene.may_seed(seed)) return true;
  }
  return false;
}

Octree::Cell pick_cell(const SegmentScene& scene, uint32_t seed, RandomStream& random) {
  const int own = scene.level[seed];
  const int level =
      std::max(scene.coarse_level, own - static_cast<int>(random.below(kHypothesesLevelsUp)));
  return scene.cell_around(level, seed);
}

bool pick_partner(const SegmentScene& scene, const Octree::Cell& cell, const Vec3& away_from,
                  RandomStream& random, Vec3& out) {
  const double spread = kMinSpread * scene.settings.distance_tolerance_m;
  for (int i = 0; i < kHypothesesTries; ++i) {
    const size_t p = cell.first + random.below(cell.count);
    if (scene.owner[p] != 0) continue;
    out = scene.local(p);
    if (squared_norm(out - away_from) >= spread * spread) return true;
  }
  return false;
}

// Share of the cell's free points on the plane, from an even sample, and the least-squares plane of those.
bool local_support(const SegmentScene& scene, const Octree::Cell& cell, const Vec3& reference,
                   bool refine, Plane& plane) {
  const double tolerance = scene.settings.distance_tolerance_m;
  Moments moments;
  moments.reference = reference;
  const size_t step = std::max<size_t>(1, cell.count / kLocalSample);
  size_t seen = 0;
  for (size_t i = cell.first; i < cell.first + cell.count; i += step) {
    if (scene.owner[i] != 0) continue;
    ++seen;
    const Vec3 p = scene.local(i);
    if (std::fabs(plane.distance(p)) <= tolerance) moments.add(p);
  }
  if (static_cast<double>(moments.n) < kMinLocalSupport * static_cast<double>(seen)) return false;
  PlaneFit fit;
  if (refine && moments.n >= 6 && fit_plane(moments, fit)) plane = fit.plane;
  return true;
}

// Any three free points (Boulaassal 2010, 3.4.3.3).
bool draw_globally(const SegmentScene& scene, const PointPool& pool, RandomStream& random,
                   Candidate& candidate) {
  const double spread = kMinSpread * scene.settings.distance_tolerance_m;
  Vec3 points[3];
  for (Vec3& point : points) {
    uint32_t position = kNoPoint;
    if (!pick_seed_of_hypotheses(scene, pool, random, position)) return false;
    if (&point == points) candidate.seed = position;
    point = scene.local(position);
    for (const Vec3* other = points; other != &point; ++other)
      if (squared_norm(*other - point) < spread * spread) return false;
  }
  return plane_through(points[0], points[1], points[2], candidate.plane);
}

uint32_t inliers(const SegmentScene& scene, const PointPool& pool, const Candidate& c, size_t piece,
                 Task& task) {
  const double tolerance = scene.settings.distance_tolerance_m;
  if (!c.curved.exists())
    return pool.count(piece, scene.test(c.plane, tolerance, scene.min_cosine()), task);
  return pool.count(piece, curved_test(scene, c.curved, scene.cell_edge_m(c.seed), tolerance),
                    task);
}

}  // namespace

// 1. a free point at random; 2. a cell of a random level around it; 3. two more free points of that cell, well apart
// (Schnabel et al. 2007, 4.3: points close together belong to one surface); 4. the plane of the three, tested and
// refined on the cell's points; 5. in a pass for one orientation class, turned onto its axis and tested again.
bool draw_candidate(const RansacScene& scene, const PointPool& pool, const OrientationPass& pass,
                    uint64_t draw, Candidate& out) {
  RandomStream random(scene.draw.seed, draw);
  Candidate candidate;
  if (scene.draw.sampling == Sampling::kGlobal) {
    if (!draw_globally(scene, pool, random, candidate)) return false;
    if (!pass.shape(candidate.plane, scene.local(candidate.seed))) return false;
    if (scene.inconsistent(candidate.seed, candidate.plane.normal, scene.min_cosine()))
      return false;
    out = candidate;
    return true;
  }
  if (!pick_seed_of_hypotheses(scene, pool, random, candidate.seed)) return false;
  const Octree::Cell cell = pick_cell(scene, candidate.seed, random);
  const Vec3 a = scene.local(candidate.seed);
  Vec3 b, c;
  if (!pick_partner(scene, cell, a, random, b) || !pick_partner(scene, cell, a, random, c))
    return false;
  if (!plane_through(a, b, c, candidate.plane)) return false;
  if (scene.inconsistent(candidate.seed, candidate.plane.normal, scene.min_cosine())) return false;
  if (!local_support(scene, cell, a, true, candidate.plane)) return false;
  if (pass.wanted != Orientation::kNone &&
      !(pass.shape(candidate.plane, a) && local_support(scene, cell, a, false, candidate.plane)))
    return false;
  out = candidate;
  return true;
}

// Bounds of the score from h inliers among m of N points, by the hypergeometric distribution (Schnabel et al. 2007,
// 4.5.1): -1 - f(-2 - m, -2 - N, -1 - h), f(N, x, n) = (x n +- sqrt(x n (N - x) (N - n) / (N - 1))) / N.
void score_next_piece(const SegmentScene& scene, const PointPool& pool, Candidate& c, Task& task) {
  c.found += inliers(scene, pool, c, c.pieces++, task);
  const double h = c.found, all = static_cast<double>(pool.free_points());
  const double m = static_cast<double>(pool.points_upto(c.pieces - 1));
  if (c.pieces == PointPool::kPieces) {
    c.lower = c.upper = c.estimate = h;
    return;
  }
  if (m == 0) {  // an empty piece says nothing
    c.lower = 0;
    c.upper = c.estimate = all;
    return;
  }
  const double big = -2 - m, x = -2 - all, n = -1 - h;
  const double root = std::sqrt(std::max(0.0, x * n * (big - x) * (big - n) / (big - 1)));
  const double from = -1 - (x * n + root) / big, to = -1 - (x * n - root) / big;
  c.lower = std::max(h, std::min(from, to));
  c.upper = std::max(h, std::max(from, to));
  c.estimate = h * all / m;
}

void score_roughly(const SegmentScene& scene, const PointPool& pool, Candidate& c, Task& task) {
  while (c.pieces < PointPool::kPieces) {
    score_next_piece(scene, pool, c, task);
    if (c.upper - c.lower <= kNarrow * c.estimate || c.upper < scene.settings.min_points) return;
  }
}

}  // namespace jalon
