// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/pairs.h"

#include <cmath>

#include "base/parallel.h"
#include "spatial/neighbours/nearest.h"

namespace jalon {

namespace {

constexpr size_t kGrain = 1 << 14;
constexpr uint32_t kAround = 8;  // points looked at around a corner

Transform shift_by(const Vec3& v) {
  Transform out;
  for (int i = 0; i < 3; ++i) out.m[static_cast<size_t>(4 * i + 3)] = v[i];
  return out;
}

// Sorted positions of the reference for each query, in the caller's order of the queries or in their tree's.
Buffer<uint32_t> nearest_positions(const Octree& reference, const Octree& queries, bool in_tree_order,
                                   double max_distance_m, Task& task) {
  Buffer<uint32_t> out(queries.size());
  const auto order = queries.order();
  for_each_nearest(reference, queries, max_distance_m, task, [&](const NearestBatch& batch) {
    for (size_t i = batch.first; i < batch.first + batch.count; ++i)
      out[in_tree_order ? i : order[i]] = batch.nearest[i - batch.first];
  });
  return out;
}

}  // namespace

Transform IcpClouds::inner(const Transform& pose) const {
  const Vec3 to = reference.tree->cube().origin, from = moving.tree->cube().origin;
  // In this order the large numbers meet before they are rounded.
  Transform out = pose;
  const Vec3 t = (from - to) + (pose.direction(from) - from + pose.translation());
  for (int i = 0; i < 3; ++i) out.m[static_cast<size_t>(4 * i + 3)] = t[i];
  return out;
}

Transform IcpClouds::outer(const Transform& inner) const {
  return shift_by(reference.tree->cube().origin) * inner * shift_by(-moving.tree->cube().origin);
}

IcpSearch::IcpSearch(const IcpClouds& clouds, const IcpPoints& reference, const IcpPoints& moving, double least_cosine,
                     Task& task)
    : clouds_(clouds),
      reference_(reference),
      moving_(moving),
      least_cosine_(least_cosine),
      tree_(clouds.reference.tree) {
  if (reference.positions.empty()) return;
  const Octree& all = *clouds.reference.tree;
  xyz_ = Buffer<double>(3 * reference.positions.size());
  for (size_t i = 0; i < reference.positions.size(); ++i) {
    const Vec3 p = all.cube().origin + all.local(reference.positions[i]);
    for (int c = 0; c < 3; ++c) xyz_[3 * i + static_cast<size_t>(c)] = p[c];
  }
  tree_ = Octree::build(xyz_, all.cube(), task);
}

// The moved points on the reference's grid: shifted by whole metres they stay the same numbers.
std::shared_ptr<const Octree> IcpSearch::moved_tree(const Transform& inner, Buffer<double>& xyz, Task& task) const {
  const size_t n = moving_.count(clouds_.moving);
  xyz = Buffer<double>(3 * n);
  const Octree& reference = *clouds_.reference.tree;
  const Vec3 origin = reference.cube().origin;
  const double step = reference.grid_step();
  const Box3 box = parallel_reduce(task, n, kGrain, Box3{}, [&](size_t begin, size_t end) {
    Box3 part;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = inner.point(clouds_.moving.place(moving_.position(i)));
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

IcpNeighbours IcpSearch::find(const Transform& inner, double max_distance_m, Task& task) const {
  Buffer<double> xyz;
  const auto moved = moved_tree(inner, xyz, task);
  IcpNeighbours out{nearest_positions(*tree_, *moved, false, max_distance_m, task),
                    nearest_positions(*moved, *tree_, reference_.positions.empty(), max_distance_m, task)};
  const auto order = moved->order();
  for (uint32_t& p : out.of_moving)
    if (p != kNoPoint) p = reference_position(p);
  for (uint32_t& p : out.of_reference)
    if (p != kNoPoint) p = moving_.position(order[p]);
  if (least_cosine_ > 0) turn_corners(*moved, inner, max_distance_m, out, task);
  return out;
}

void IcpSearch::turn_corners(const Octree& moved, const Transform& inner, double max_distance_m, IcpNeighbours& found,
                             Task& task) const {
  const SurfacePlanes &reference = clouds_.reference, &moving = clouds_.moving;
  const Vec3 origin = reference.tree->cube().origin;
  const auto alike = [&](uint32_t m, uint32_t r) {
    return moving.flat(m) && reference.flat(r) &&
           std::abs(dot(inner.direction(moving.planes[m].unit()), reference.planes[r].unit())) >= least_cosine_;
  };
  // The first of some near ones that is alike; position(i): of entry i of the tree.
  const auto turned = [&](const Octree& tree, const Vec3& at, auto position, auto fits) {
    Neighbour near[kAround];
    const size_t n = tree.knn_positions(at, kAround, near);
    for (size_t k = 0; k < n && near[k].squared_distance <= max_distance_m * max_distance_m; ++k)
      if (const uint32_t p = position(near[k].index); fits(p)) return p;
    return kNoPoint;
  };
  parallel_for(task, found.of_moving.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      uint32_t& near = found.of_moving[i];
      const uint32_t m = moving_.position(i);
      if (near == kNoPoint || !moving.flat(m) || alike(m, near)) continue;
      near = turned(*tree_, origin + inner.point(moving.place(m)),
                    [&](uint32_t p) { return reference_position(p); }, [&](uint32_t r) { return alike(m, r); });
    }
  });
  const auto order = moved.order();
  parallel_for(task, found.of_reference.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      uint32_t& near = found.of_reference[i];
      const uint32_t r = reference_.position(i);
      if (near == kNoPoint || !reference.flat(r) || alike(near, r)) continue;
      near = turned(moved, origin + reference.place(r), [&](uint32_t p) { return moving_.position(order[p]); },
                    [&](uint32_t m) { return alike(m, r); });
    }
  });
}

}  // namespace jalon
