// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/plane.h"
#include "geometry/quadric.h"
#include "spatial/neighbours/range_sums.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// The neighbours of one point of the tree, itself included: sorted positions and squared distances (m^2).
struct Neighbourhood {
  size_t point;  ///< sorted position
  std::span<const uint32_t> neighbours;
  std::span<const float> squared;
  bool repeats =
      false;  ///< neighbours and place of the grid are those of the one visited before with this scratch
};

/// Has a point of a batch the neighbours and the place of the grid of the point before? Then local() coordinates tell
/// the same of both: of points that coincide, sums over their neighbours are taken once.
inline bool repeats_before(const Octree& tree, const Octree::BallBatch& batch, size_t i) {
  if (i == 0) return false;
  const uint32_t *begin = batch.neighbours + batch.offsets[i],
                 *end = batch.neighbours + batch.offsets[i + 1],
                 *before = batch.neighbours + batch.offsets[i - 1];
  // What tells nearly all apart comes first.
  if (end - begin != begin - before || *begin != *before) return false;
  const size_t point = batch.first + i;
  const auto same = [&](const int32_t* axis) { return axis[point] == axis[point - 1]; };
  return same(tree.grid_x()) && same(tree.grid_y()) && same(tree.grid_z()) &&
         std::equal(begin, end, before);
}

template <class Scratch, class F>
void visit_balls(const Octree& tree, const Octree::BallBatch& batch, F&& visit) {
  Scratch scratch;
  for (size_t i = 0; i < batch.count; ++i) {
    const size_t begin = batch.offsets[i], n = batch.offsets[i + 1] - begin;
    visit(Neighbourhood{batch.first + i,
                        {batch.neighbours + begin, n},
                        {batch.squared + begin, n},
                        repeats_before(tree, batch, i)},
          scratch);
  }
}

/// Calls visit(Neighbourhood, Scratch&) for
/// every point, in parallel; one Scratch a batch. By radius_m when it is above 0, else the k
/// nearest.
template <class Scratch, class F>
void for_each_neighbourhood(const Octree& tree, uint32_t k, double radius_m, Task& task,
                            F&& visit) {
  if (radius_m > 0) {
    tree.for_each_ball(radius_m, task, [&](const Octree::BallBatch& batch) {
      visit_balls<Scratch>(tree, batch, visit);
    });
    return;
  }
  tree.for_each_knn(k, task, [&](const Octree::Batch& batch) {
    Scratch scratch;
    for (size_t i = 0; i < batch.count; ++i) {
      const uint32_t* neighbours = batch.neighbours + i * batch.k;
      size_t n = batch.k;
      while (n > 0 && neighbours[n - 1] == kNoPoint) --n;  // a small cloud fills up the end
      visit(Neighbourhood{batch.first + i, {neighbours, n}, {batch.squared + i * batch.k, n}},
            scratch);
    }
  });
}

/// The same by radius_m, with crowded(Octree::CrowdedBall, Scratch&) for balls of very many points of a tree that has
/// crowds (Octree::has_crowds).
template <class Scratch, class F, class G>
void for_each_crowded_neighbourhood(const Octree& tree, double radius_m, Task& task, F&& visit,
                                    G&& crowded) {
  tree.for_each_crowded_ball(
      radius_m, task,
      [&](const Octree::BallBatch& batch) { visit_balls<Scratch>(tree, batch, visit); },
      [&](const Octree::CrowdedBall& ball) {
        Scratch scratch;
        crowded(ball, scratch);
      });
}

/// Principal axes of some points: n is the direction of least extent, u of the largest, u x v = n.
struct PrincipalFrame {
  Vec3 centre, u, v, n;
  std::array<double, 3> eigenvalues{};  ///< of the covariance, ascending
};

/// False when fewer than 3 points or when they lie on a line (fit_plane's rule).
bool principal_frame(const Moments& moments, PrincipalFrame& out);

/// The quadric over the frame's plane, with the coordinates of one point in it.
struct LocalQuadric {
  Quadric quadric;
  double x = 0, y = 0;  ///< of the point asked for
};
/// work is memory that the caller keeps between calls.
bool local_quadric(const PrincipalFrame& frame, std::span<const Vec3> points, const Vec3& at,
                   std::vector<Vec3>& work, LocalQuadric& out);

/// Balls of very many points, of which sums are known: what lists of points give, but for rounding.
class SummedBalls {
 public:
  SummedBalls(const Octree& tree, double radius_m, bool with_quadrics, Task& task)
      : tree_(tree), radius_m_(radius_m), planes_(tree, task) {
    if (with_quadrics) quadrics_.emplace(tree, task);
  }

  /// As the sums of the points' local() coordinates about that of the ball's point.
  Moments moments(const Octree::RangedBall& ball) const;
  /// The quadric over the frame that these moments gave; of balls made with quadrics.
  bool quadric(const PrincipalFrame& frame, const Octree::RangedBall& ball,
               LocalQuadric& out) const;

 private:
  const Octree& tree_;
  double radius_m_;
  RangeSums<2> planes_;
  std::optional<RangeSums<4>> quadrics_;
};

/// for_each_neighbourhood with summed(SummedBalls, Octree::RangedBall) in the place of visit for balls of very many
/// points.
template <class Scratch, class F, class G>
void for_each_summed_neighbourhood(const Octree& tree, uint32_t k, double radius_m,
                                   bool with_quadrics, Task& task, F&& visit, G&& summed) {
  if (!(radius_m > 0)) return for_each_neighbourhood<Scratch>(tree, k, 0, task, visit);
  const SummedBalls sums(tree, radius_m, with_quadrics, task);
  tree.for_each_ranged_ball(
      radius_m, task,
      [&](const Octree::BallBatch& batch) { visit_balls<Scratch>(tree, batch, visit); },
      [&](const Octree::RangedBall& ball) { summed(sums, ball); });
}

}  // namespace jalon
