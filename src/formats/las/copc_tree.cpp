// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/copc_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "spatial/octree/octree.h"

// Points stand in the order of the octree's curve, so that each cell of each level is a run of them.
// A level at a time, each node moves what it keeps to the beginning of its run, in order; behind it
// the runs of its children follow one another.
namespace jalon::las {

namespace {

constexpr size_t kWholePoints = 10000;  // fewer are kept all: halves of a chunk are hardly smaller
constexpr size_t kLeastPoints = 100;    // a child of fewer is no node: its chunk would be all heads
constexpr int kLastLevel = kMaxLevel - kCopcGridLevels;  // beyond it the octree knows no cells
constexpr int kGridBits = 31;                            // of the octree's coordinates
constexpr double kGridEdge = 0x1p31;
// Points between two looks at the cancel flag, and of a chunk.
constexpr size_t kGrain = size_t{1} << 16;

/// A node's points before it has chosen.
struct Run {
  CopcKey key;
  size_t begin = 0, end = 0;
};
/// What it kept and what it hands down.
struct Choice {
  size_t kept = 0;
  std::array<size_t, 8> child_ends{};  ///< of the runs of its children, in the order of the curve
};

struct Grid {
  const int32_t *x, *y, *z;

  bool share_cell(uint32_t a, uint32_t b, int level) const {
    const int shift = kGridBits - level;
    return x[a] >> shift == x[b] >> shift && y[a] >> shift == y[b] >> shift &&
           z[a] >> shift == z[b] >> shift;
  }
  /// Which of the eight children of its node at this level a point is in, in the order of the curve.
  unsigned child(uint32_t p, int level) const {
    const int shift = kGridBits - level - 1;
    const auto bit = [&](int32_t value) { return static_cast<unsigned>(value >> shift) & 1u; };
    return bit(x[p]) << 2 | bit(y[p]) << 1 | bit(z[p]);
  }
  /// From the centre of its cell at this level, in half steps of the grid.
  int64_t squared_distance(uint32_t p, int level) const {
    const int64_t edge = int64_t{1} << (kGridBits - level);
    const auto off = [&](int32_t value) {
      const int64_t d = 2 * (value & (edge - 1)) + 1 - edge;
      return d * d;
    };
    return off(x[p]) + off(y[p]) + off(z[p]);
  }
};

class Chooser {
 public:
  Chooser(const Grid& grid, Task& task) : grid_(grid), task_(task) {}

  /// Puts what the node keeps first.
  Choice choose(std::span<uint32_t> points, int level) {
    if (points.size() <= kWholePoints || level == kLastLevel) return {points.size(), {}};
    std::vector<uint8_t> kept(points.size());
    keep_grid(points, level + kCopcGridLevels, kept);
    const std::array<size_t, 8> left = keep_crumbs(points, level, kept);
    std::vector<uint32_t> others;
    size_t to = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      look(i);
      if (kept[i] != 0) points[to++] = points[i];
      else others.push_back(points[i]);
    }
    std::ranges::copy(others, points.begin() + static_cast<ptrdiff_t>(to));
    Choice choice{to, {}};
    size_t end = to;
    for (size_t c = 0; c < 8; ++c) choice.child_ends[c] = end += left[c];
    return choice;
  }

 private:
  // A root has all points of the cloud.
  void look(size_t i) const {
    if (i % kGrain == 0 && task_.cancelled()) task_.checkpoint(0);
  }

  void keep_grid(std::span<const uint32_t> points, int cells, std::vector<uint8_t>& kept) const {
    for (size_t i = 0; i < points.size();) {
      look(i);
      size_t best = i;
      int64_t least = grid_.squared_distance(points[i], cells);
      const uint32_t first = points[i];
      for (++i; i < points.size() && grid_.share_cell(first, points[i], cells); ++i) {
        look(i);
        if (const int64_t d = grid_.squared_distance(points[i], cells); d < least) {
          least = d;
          best = i;
        }
      }
      kept[best] = 1;
    }
  }

  /// How many each child gets.
  std::array<size_t, 8> keep_crumbs(std::span<const uint32_t> points, int level,
                                    std::vector<uint8_t>& kept) const {
    std::array<size_t, 8> left{};
    for (size_t i = 0; i < points.size(); ++i) {
      look(i);
      if (kept[i] == 0) ++left[grid_.child(points[i], level)];
    }
    for (size_t i = 0; i < points.size(); ++i) {
      look(i);
      if (left[grid_.child(points[i], level)] < kLeastPoints) kept[i] = 1;
    }
    for (size_t& count : left)
      if (count < kLeastPoints) count = 0;
    return left;
  }

  const Grid& grid_;
  Task& task_;
};

CopcKey child_key(const CopcKey& key, unsigned child) {
  return {key.level + 1, 2 * key.x + static_cast<int32_t>(child >> 2 & 1),
          2 * key.y + static_cast<int32_t>(child >> 1 & 1),
          2 * key.z + static_cast<int32_t>(child & 1)};
}

void share_out(CopcTree& tree, const Grid& grid, Task& task) {
  std::vector<Run> level = {{CopcKey{}, 0, tree.order.size()}};
  for (double done = 0; !level.empty(); done = (1 + done) / 2) {
    ProgressSpan span(task, done, (1 + done) / 2);
    std::vector<Choice> choices(level.size());
    parallel_chunks(task, level.size(), [&](size_t r) {
      const Run& run = level[r];
      choices[r] =
          Chooser(grid, task)
              .choose(std::span(tree.order).subspan(run.begin, run.end - run.begin), run.key.level);
    });
    std::vector<Run> below;
    for (size_t r = 0; r < level.size(); ++r) {
      const Run& run = level[r];
      const Choice& choice = choices[r];
      tree.nodes.push_back({run.key, run.begin, choice.kept});
      size_t begin = choice.kept;
      for (unsigned c = 0; c < 8 && begin < run.end - run.begin; ++c) {
        if (choice.child_ends[c] > begin)
          below.push_back(
              {child_key(run.key, c), run.begin + begin, run.begin + choice.child_ends[c]});
        begin = choice.child_ends[c];
      }
    }
    level = std::move(below);
  }
}

Box3 box_of(const Buffer<double>& xyz, Task& task) {
  return parallel_reduce<Box3>(task, xyz.size() / 3, kGrain, {}, [&](size_t begin, size_t end) {
    Box3 box;
    for (size_t i = begin; i < end; ++i) box.add({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]});
    return box;
  });
}

// Whole numbers that the octree takes as they are. The upper faces belong to the last cells.
void put_on_grid(Buffer<double>& xyz, const Vec3& low, double edge, Task& task) {
  parallel_for(task, xyz.size() / 3, kGrain, [&](size_t begin, size_t end) {
    for (size_t i = 3 * begin; i < 3 * end; ++i)
      xyz[i] = std::min(std::floor((xyz[i] - low[static_cast<int>(i % 3)]) / edge * kGridEdge),
                        kGridEdge - 1);
  });
}

}  // namespace

CopcTree copc_tree(Buffer<double> xyz, Task& task) {
  CopcTree tree;
  const size_t n = xyz.size() / 3;
  if (n == 0) return tree;
  const Box3 box = box_of(xyz, task);
  const Vec3 size = box.max - box.min;
  double edge = std::max({size.x, size.y, size.z});
  if (!(edge > 0)) edge = 1;  // all points are one
  tree.halfsize = edge / 2;
  tree.centre = box.min + Vec3{edge / 2, edge / 2, edge / 2};
  tree.spacing = std::ldexp(edge, -kCopcGridLevels);
  std::shared_ptr<const Octree> octree;
  {
    ProgressSpan span(task, 0, 0.6);
    put_on_grid(xyz, box.min, edge, task);
    octree = Octree::build(xyz, {{0, 0, 0}, kGridEdge}, task);
  }
  ProgressSpan span(task, 0.6, 1);
  tree.order.resize(n);
  std::iota(tree.order.begin(), tree.order.end(), 0u);
  share_out(tree, {octree->grid_x(), octree->grid_y(), octree->grid_z()}, task);
  // Node by node, and the octree's positions become the caller's.
  std::vector<uint32_t> order;
  order.reserve(n);
  for (CopcTree::Node& node : tree.nodes) {
    const size_t first = order.size();
    for (size_t i = 0; i < node.count; ++i)
      order.push_back(octree->order()[tree.order[node.first + i]]);
    node.first = first;
  }
  tree.order = std::move(order);
  return tree;
}

}  // namespace jalon::las
