// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Single queries: depth-first through the box tree, for the nearest points the nearest child first, for a ball in the
// order of the curve. Grid coordinates only rule points out; what may belong to the answer is measured in doubles
// between the caller's own coordinates, so that answers equal brute force. Where the tree has boxes in doubles, these
// rule out (exact_walk.h).

#include <algorithm>
#include <cmath>
#include <limits>

#include "spatial/octree/exact_walk.h"
#include "spatial/octree/impl.h"
#include "spatial/octree/other_within.h"

namespace jalon {

namespace {

// A grid coordinate stands for [g, g + 1): its centre is within half a diagonal, sqrt(3) / 2, of the point; a little is
// added for the rounding of the distances themselves.
constexpr double kQueryGridError = 0.8661;
constexpr double kQueryRounding = 1 + 1e-12;

struct Visit {
  double squared;  // lower bound, grid units
  uint32_t level, block;
};

// Of the boxes of a block from a place, grid units.
void squared_distances(const BoxBlock& b, const Vec3& q, double (&squared)[kBoxes]) {
  for (size_t i = 0; i < kBoxes; ++i) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double below = b.lo[axis][i] - q[axis], above = q[axis] - (b.hi[axis][i] + 1.0);
      const double out = std::max(std::max(below, above), 0.0);
      sum += out * out;
    }
    squared[i] = sum;
  }
}

// Walks the leaves that may hold points nearer than bound() (squared, grid units), nearest first by box; scan(leaf)
// looks at one.
template <class Bound, class Scan>
void walk(const Octree::Impl& tree, const Vec3& q, Bound bound, Scan scan) {
  if (tree.count == 0) return;
  // Depth-first: at most 7 siblings wait on each of at most 11 levels.
  Visit stack[kBoxes * 12];
  size_t depth = 0;
  stack[depth++] = {0, static_cast<uint32_t>(tree.levels.size()) - 1, 0};
  while (depth != 0) {
    const Visit visit = stack[--depth];
    if (visit.squared > bound()) continue;
    const BoxBlock& b = tree.levels[visit.level][visit.block];
    double squared[kBoxes];
    squared_distances(b, q, squared);
    Visit children[kBoxes];
    size_t count = 0;
    for (uint32_t i = 0; i < kBoxes; ++i) {
      if (b.lo[0][i] > b.hi[0][i] || squared[i] > bound()) continue;
      size_t at = count++;
      for (; at > 0 && children[at - 1].squared > squared[i]; --at) children[at] = children[at - 1];
      children[at] = {squared[i], visit.level, visit.block * static_cast<uint32_t>(kBoxes) + i};
    }
    if (visit.level == 0) {
      for (size_t i = 0; i < count; ++i)
        if (children[i].squared <= bound()) scan(children[i].block);
    } else {
      for (size_t i = count; i-- > 0;)
        stack[depth++] = {children[i].squared, visit.level - 1, children[i].block};
    }
  }
}

// Calls scan(leaf) for the leaves whose boxes are within sqrt(limit) (grid units), in the order of the curve.
template <class Scan>
void leaves_within(const Octree::Impl& tree, const Vec3& q, double limit, Scan scan) {
  if (tree.count == 0) return;
  struct Waiting {
    uint32_t level, block;
  };
  Waiting stack[kBoxes * 12];  // as of walk
  size_t depth = 0;
  stack[depth++] = {static_cast<uint32_t>(tree.levels.size()) - 1, 0};
  while (depth != 0) {
    const auto [level, block] = stack[--depth];
    const BoxBlock& b = tree.levels[level][block];
    double squared[kBoxes];
    squared_distances(b, q, squared);
    const auto is_in = [&](size_t i) { return b.lo[0][i] <= b.hi[0][i] && squared[i] <= limit; };
    const uint32_t first = block * static_cast<uint32_t>(kBoxes);
    if (level == 0) {
      for (uint32_t i = 0; i < kBoxes; ++i)
        if (is_in(i)) scan(first + i);
    } else {
      for (uint32_t i = kBoxes; i-- > 0;)
        if (is_in(i)) stack[depth++] = {level - 1, first + i};
    }
  }
}

// Calls found(position, exact squared distance) for the points of a leaf that are not certainly beyond limit (grid
// units).
template <class Limit, class Found>
void scan_leaf(const Octree::Impl& tree, size_t leaf, const Vec3& q_world, const Vec3& q,
               Limit limit, Found found) {
  for (size_t i = tree.leaf_first[leaf]; i < tree.leaf_first[leaf + 1]; ++i) {
    const double dx = tree.x[i] + 0.5 - q.x, dy = tree.y[i] + 0.5 - q.y, dz = tree.z[i] + 0.5 - q.z;
    if (dx * dx + dy * dy + dz * dz > limit()) continue;
    found(i, squared_norm(tree.exact_point(i) - q_world));
  }
}

// Calls found(position, exact squared distance) for the points of the boxes in doubles that may hold some.
template <class MayHold, class Take>
void measure(const Octree::Impl& tree, const Vec3& q, MayHold may_hold, Take found) {
  exact_walk(tree, q, may_hold, [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i) found(i, squared_norm(tree.exact_point(i) - q));
  });
}

Vec3 to_grid(const Octree::Impl& tree, const Vec3& q) {
  return (q - tree.cube.origin) * tree.inverse_step;
}

// Largest squared grid distance of a grid centre whose point can be within sqrt(squared_m2) of the query.
double limit_of(const Octree::Impl& tree, double squared_m2) {
  const double reach = std::sqrt(squared_m2) * tree.inverse_step * kQueryRounding + kQueryGridError;
  return reach * reach * kQueryRounding;
}

struct Found {
  double squared;  // exact, m^2
  uint32_t index, position;
  bool operator<(const Found& b) const {
    return squared < b.squared || (squared == b.squared && index < b.index);
  }
};

// The k nearest points of q, nearest first; heap has room for k. Returns how many there are.
// squared_reach (m^2): what lies farther may be left out.
size_t nearest(const Octree::Impl& tree, const Vec3& q, size_t k, Found* heap,
               double squared_reach = std::numeric_limits<double>::infinity()) {
  const size_t wanted = std::min(k, tree.count);
  if (wanted == 0) return 0;
  const Vec3 q_grid = to_grid(tree, q);
  size_t count = 0;  // heap[0, count): farthest first
  double limit = limit_of(tree, squared_reach);
  const auto found = [&](size_t position, double squared) {
    const Found candidate{squared, tree.order[position], static_cast<uint32_t>(position)};
    if (count < wanted) {
      heap[count++] = candidate;
      std::push_heap(heap, heap + count);
    } else if (candidate < heap[0]) {
      std::pop_heap(heap, heap + count);
      heap[count - 1] = candidate;
      std::push_heap(heap, heap + count);
    } else {
      return;
    }
    if (count == wanted) limit = std::min(limit, limit_of(tree, heap[0].squared));
  };
  const auto bound = [&] { return limit; };
  if (tree.has_exact_boxes()) {
    const auto may_hold = [&](double squared, uint32_t least_index) {
      return squared <= squared_reach &&
             (count < wanted || Found{squared, least_index, kNoPoint} < heap[0]);
    };
    measure(tree, q, may_hold, found);
  } else {
    walk(tree, q_grid, bound, [&](size_t leaf) { scan_leaf(tree, leaf, q, q_grid, bound, found); });
  }
  std::sort_heap(heap, heap + count);
  return count;
}

}  // namespace

void Octree::Impl::nearest_of_point(size_t position, uint32_t k, uint32_t* neighbours) const {
  Found heap[256];
  const size_t found = nearest(*this, exact_point(position), k, heap);
  for (size_t j = 0; j < k; ++j) neighbours[j] = j < found ? heap[j].position : kNoPoint;
}

size_t Octree::Impl::nearest_of_place(const Vec3& q, size_t k, uint32_t* positions) const {
  constexpr size_t kOnStack = 64;
  Found small[kOnStack];
  std::vector<Found> large(k > kOnStack ? std::min(k, count) : 0);
  Found* heap = k > kOnStack ? large.data() : small;
  const size_t found = nearest(*this, q, k, heap);
  for (size_t j = 0; j < found; ++j) positions[j] = heap[j].position;
  return found;
}

uint32_t Octree::Impl::nearest_position(const Vec3& q, double squared_reach) const {
  Found found;
  return nearest(*this, q, 1, &found, squared_reach) == 0 ? kNoPoint : found.position;
}

namespace {

// take(position, exact squared distance) for the points in the ball, in the order of the curve: positions ascend.
template <class Take>
void for_each_in_ball(const Octree::Impl& tree, const Vec3& q, double radius, Take take) {
  if (!(radius >= 0)) return;
  const Vec3 q_grid = to_grid(tree, q);
  const double squared_radius = radius * radius, limit = limit_of(tree, squared_radius);
  const auto bound = [&] { return limit; };
  const auto found = [&](size_t position, double squared) {
    if (squared <= squared_radius) take(position, squared);
  };
  if (tree.has_exact_boxes()) {
    const auto meets = [&](const ExactBlock& block, size_t slot) {
      return squared_distance(block, slot, q) <= squared_radius;
    };
    return exact_runs(tree, meets, [&](size_t first, size_t last) {
      for (size_t i = first; i < last; ++i) found(i, squared_norm(tree.exact_point(i) - q));
    });
  }
  leaves_within(tree, q_grid, limit,
                [&](size_t leaf) { scan_leaf(tree, leaf, q, q_grid, bound, found); });
}

}  // namespace

bool Octree::nearest_within(const Vec3& q, double radius, Neighbour& out) const {
  Found found;
  if (!(radius >= 0) || nearest(*impl_, q, 1, &found, radius * radius) == 0 ||
      found.squared > radius * radius)
    return false;
  out = {found.squared, found.index};
  return true;
}

bool has_other_within(const Octree& octree, size_t sorted_position, double radius) {
  if (!(radius >= 0)) return false;
  const Octree::Impl& tree = octree.impl();
  const Vec3 q = tree.exact_point(sorted_position), q_grid = to_grid(tree, q);
  const double squared_radius = radius * radius, limit = limit_of(tree, squared_radius);
  bool has_one = false;
  const auto found = [&](size_t position, double squared) {
    has_one = has_one || (position != sorted_position && squared <= squared_radius);
  };
  if (tree.has_exact_boxes()) {
    const auto may_hold = [&](double squared, uint32_t) {
      return !has_one && squared <= squared_radius;
    };
    measure(tree, q, may_hold, found);
    return has_one;
  }
  const auto bound = [&] { return has_one ? -1.0 : limit; };  // nothing is nearer than -1
  walk(tree, q_grid, bound, [&](size_t leaf) { scan_leaf(tree, leaf, q, q_grid, bound, found); });
  return has_one;
}

void Octree::radius(const Vec3& q, double radius, std::vector<Neighbour>& out) const {
  out.clear();
  for_each_in_ball(*impl_, q, radius, [&](size_t position, double squared) {
    out.push_back({squared, impl_->order[position]});
  });
  std::sort(out.begin(), out.end(),
            [](const Neighbour& a, const Neighbour& b) { return a.index < b.index; });
}

void Octree::radius_positions(const Vec3& q, double radius, std::vector<Neighbour>& out) const {
  out.clear();
  for_each_in_ball(*impl_, q, radius, [&](size_t position, double squared) {
    out.push_back({squared, static_cast<uint32_t>(position)});
  });
}

}  // namespace jalon
