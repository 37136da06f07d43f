// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/search.h"

#include <cmath>

#include "base/parallel.h"
#include "spatial/neighbours/nearest.h"

namespace jalon {

namespace {

constexpr size_t kSearchGrain = 1 << 14;
constexpr uint32_t kAround = 8;  // points looked at around a corner

// Sorted positions of the reference for each query, in the caller's order of the queries or in
// their tree's.
Buffer<uint32_t> nearest_positions(const Octree& reference, const Octree& queries,
                                   bool in_tree_order, double max_distance_m, Task& task) {
  Buffer<uint32_t> out(queries.size());
  const auto order = queries.order();
  for_each_nearest(reference, queries, max_distance_m, task, [&](const NearestBatch& batch) {
    for (size_t i = batch.first; i < batch.first + batch.count; ++i)
      out[in_tree_order ? i : order[i]] = batch.nearest[i - batch.first];
  });
  return out;
}

}  // namespace

IcpSearch::IcpSearch(const IcpClouds& clouds, const IcpLevel& level, double least_cosine,
                     Task& task)
    : clouds_(clouds), level_(level), least_cosine_(least_cosine), tree_(clouds.reference.tree) {
  const std::vector<uint32_t>& positions = level.reference.positions;
  if (positions.empty()) return;
  const Octree& all = *clouds.reference.tree;
  xyz_ = Buffer<double>(3 * positions.size());
  for (size_t i = 0; i < positions.size(); ++i) {
    const Vec3 p = all.cube().origin + all.local(positions[i]);
    for (int c = 0; c < 3; ++c) xyz_[3 * i + static_cast<size_t>(c)] = p[c];
  }
  tree_ = Octree::build(xyz_, all.cube(), task);
}

// The moved points on the reference's grid: shifted by whole metres they stay the same numbers.
std::shared_ptr<const Octree> IcpSearch::moved_tree(const Transform& T_reference_moving,
                                                    Buffer<double>& xyz, Task& task) const {
  const size_t n = level_.moving.count(clouds_.moving);
  xyz = Buffer<double>(3 * n);
  const Octree& reference = *clouds_.reference.tree;
  const Vec3 origin = reference.cube().origin;
  const double step = reference.grid_step();
  const Box3 box = parallel_reduce(task, n, kSearchGrain, Box3{}, [&](size_t begin, size_t end) {
    Box3 part;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = T_reference_moving.point(clouds_.moving.place(level_.moving.position(i)));
      Vec3 q;
      for (int c = 0; c < 3; ++c) {
        q[c] = origin[c] + step * std::nearbyint(p[c] / step);
        xyz[3 * i + static_cast<size_t>(c)] = q[c];
      }
      part.add(q);
    }
    return part;
  });
  return Octree::build(xyz, enclosing_cube(box), task);
}

IcpNeighbours IcpSearch::find(const Transform& T_reference_moving, double max_distance_m,
                              Task& task) const {
  Buffer<double> xyz;
  const auto moved = moved_tree(T_reference_moving, xyz, task);
  const bool all = level_.reference.positions.empty();
  IcpNeighbours out{nearest_positions(*tree_, *moved, false, max_distance_m, task),
                    nearest_positions(*moved, *tree_, all, max_distance_m, task)};
  const auto order = moved->order();
  for (uint32_t& p : out.of_moving)
    if (p != kNoPoint) p = reference_position(p);
  for (uint32_t& p : out.of_reference)
    if (p != kNoPoint) p = level_.moving.position(order[p]);
  if (least_cosine_ > 0) turn_corners(*moved, T_reference_moving, max_distance_m, out, task);
  return out;
}

void IcpSearch::turn_corners(const Octree& moved, const Transform& T_reference_moving,
                             double max_distance_m, IcpNeighbours& found, Task& task) const {
  const SurfacePlanes &reference = clouds_.reference, &moving = clouds_.moving;
  const Vec3 origin = reference.tree->cube().origin;
  const auto alike = [&](uint32_t m, uint32_t r) {
    if (!moving.flat(m) || !reference.flat(r)) return false;
    const Vec3 n_moving = T_reference_moving.direction(moving.planes[m].unit());
    return std::abs(dot(n_moving, reference.planes[r].unit())) >= least_cosine_;
  };
  // The first of some near ones that is alike; position(i): of entry i of the tree.
  const auto turned = [&](const Octree& tree, const Vec3& at, auto position, auto fits) {
    Neighbour near[kAround];
    const size_t n = tree.knn_positions(at, kAround, near);
    for (size_t k = 0; k < n && near[k].squared_distance <= max_distance_m * max_distance_m; ++k)
      if (const uint32_t p = position(near[k].index); fits(p)) return p;
    return kNoPoint;
  };
  parallel_for(task, found.of_moving.size(), kSearchGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      uint32_t& near = found.of_moving[i];
      const uint32_t m = level_.moving.position(i);
      if (near == kNoPoint || !moving.flat(m) || alike(m, near)) continue;
      near = turned(
          *tree_, origin + T_reference_moving.point(moving.place(m)),
          [&](uint32_t p) { return reference_position(p); },
          [&](uint32_t r) { return alike(m, r); });
    }
  });
  const auto order = moved.order();
  parallel_for(task, found.of_reference.size(), kSearchGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      uint32_t& near = found.of_reference[i];
      const uint32_t r = level_.reference.position(i);
      if (near == kNoPoint || !reference.flat(r) || alike(near, r)) continue;
      near = turned(
          moved, origin + reference.place(r),
          [&](uint32_t p) { return level_.moving.position(order[p]); },
          [&](uint32_t m) { return alike(m, r); });
    }
  });
}

}  // namespace jalon
