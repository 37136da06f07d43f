// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangles/nearest.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <tuple>

#include "base/buffer.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/simd.h"
#include "spatial/triangles/nearest_kernel.h"
#include "spatial/triangles/side.h"
#include "spatial/triangles/stacks.h"

namespace jalon {

namespace {

using triangle_tree::FloatBox;
using triangle_tree::kWidth;
using triangle_tree::Node;

constexpr double kNearestMaxSpan_m = 1e9;   // as of TriangleTree
constexpr size_t kNearestBoxGrain = 65536;  // triangles a chunk, about 1 ms
constexpr size_t kNodeGrain = 8192;
constexpr size_t kAskGrain = 2048;        // points a chunk, about 1 ms
constexpr size_t kSearchesPerCheck = 32;  // about 30 us
constexpr size_t kRun = 256;  // points answered before they are looked at: they stay in the cache

constexpr size_t kMostDoubles = 3 * 3 * kWidth;  // corners of a leaf whose triangles share none

// Triangles on another one of their leaf, in the whole tree, from which on stacks are looked for.
constexpr size_t kManyStacked = 1024;
// Corners of a stack are as far apart as this share of what touches a point.
constexpr double kStackCell = 0.25;

using Triangle = std::array<uint32_t, 3>;

/// Where a search may begin: not below max_distance squared, whatever the rounding.
double limit_of(double max_distance) { return max_distance * max_distance * (1 + 0x1p-50); }

bool are_same_bits(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

/// The box of the triangles' corners; throws when one is not finite.
Box3 box_of(std::span<const Vec3> vertices, std::span<const Triangle> triangles, Task& task) {
  std::atomic<bool> all_finite{true};
  const Box3 box = parallel_reduce(task, triangles.size(), kNearestBoxGrain, Box3{},
                                   [&](size_t begin, size_t end) {
                                     Box3 part;
                                     bool good = true;
                                     for (size_t i = begin; i < end; ++i)
                                       for (const uint32_t v : triangles[i]) {
                                         good &= is_finite(vertices[v]);
                                         part.add(vertices[v]);
                                       }
                                     if (!good) all_finite.store(false, std::memory_order_relaxed);
                                     return part;
                                   });
  if (all_finite.load()) return box;
  uint32_t first = ~uint32_t{0};
  for (const Triangle& t : triangles)
    for (const uint32_t v : t)
      if (!is_finite(vertices[v])) first = std::min(first, v);
  fail(Status::kInvalidArgument, "vertex %u of the mesh is not finite", first);
}

/// A float box that holds the corners.
FloatBox float_box(const Box3& box) {
  FloatBox out;
  for (int a = 0; a < 3; ++a) {
    out.min[a] = static_cast<float>(box.min[a]);
    out.max[a] = static_cast<float>(box.max[a]);
    if (static_cast<double>(out.min[a]) > box.min[a])
      out.min[a] = std::nextafter(out.min[a], -std::numeric_limits<float>::infinity());
    if (static_cast<double>(out.max[a]) < box.max[a])
      out.max[a] = std::nextafter(out.max[a], std::numeric_limits<float>::infinity());
  }
  return out;
}

/// Corners in ascending order, so that triangles which share some count from them alike; true when that turned it.
bool sort_corners(std::array<Vec3, 3>& corners) {
  const auto is_less = [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  bool turned = false;
  for (const auto& [i, j] : {std::pair<size_t, size_t>{0, 1}, {1, 2}, {0, 1}})
    if (is_less(corners[j], corners[i])) {
      std::swap(corners[i], corners[j]);
      turned = !turned;
    }
  return turned;
}

/// Leaves are numbered in the order of the nodes: where those of each chunk of nodes begin.
std::vector<uint32_t> count_leaves(std::span<const Node> nodes, Task& task) {
  std::vector<uint32_t> firsts((nodes.size() + kNodeGrain - 1) / kNodeGrain + 1, 0);
  parallel_for(task, nodes.size(), kNodeGrain, [&](size_t begin, size_t end) {
    uint32_t leaves = 0;
    for (size_t n = begin; n < end; ++n)
      for (const uint32_t count : nodes[n].count) leaves += count > 0 ? 1 : 0;
    firsts[begin / kNodeGrain + 1] = leaves;
  });
  for (size_t i = 1; i < firsts.size(); ++i) firsts[i] += firsts[i - 1];
  return firsts;
}

}  // namespace

struct NearestTriangles::Impl {
  Vec3 origin;
  double span_m = 0;
  size_t triangles = 0;
  std::vector<Node> nodes;
  Buffer<TriangleBlock> blocks;
  Buffer<uint32_t> least;               ///< as of TriangleBlocks
  std::vector<Buffer<double>> corners;  ///< of the blocks below kNodeGrain nodes each
  size_t distinct = 0;                  ///< triangles in the tree
  std::vector<TriangleStack> stacks;    ///< at their places; none: they are all in the tree

  TriangleBlocks view() const { return {nodes.data(), blocks.data(), least.data()}; }
  TouchingTriangles touching() const {
    return {view(), stacks.empty() ? nullptr : stacks.data(), span_m};
  }
  /// Fills a block but for where its corners are; gives how many doubles, up to kMostDoubles, of corners it has.
  size_t fill_block(TriangleBlock& block, std::span<const Vec3> vertices,
                    std::span<const Triangle> all, std::span<const uint32_t> order,
                    double* found) const;
  /// Gives the order of the triangles in the tree.
  std::vector<uint32_t> make_nodes(std::span<const Vec3> vertices, std::span<const Triangle> all,
                                   Task& task);
  /// Gives how many triangles lie on the first one of their leaf.
  size_t make_blocks(std::span<const Vec3> vertices, std::span<const Triangle> all,
                     std::span<const uint32_t> order, Task& task);
  void find_least(Task& task);
  void make_distinct(std::span<const Vec3> vertices, std::span<const Triangle> all, Task& task);
  TriangleAnswer answer_of(const NearestOfBlocks& found, const Vec3& local, double max_distance,
                           const TriangleQuestions& questions) const;
};

size_t NearestTriangles::Impl::fill_block(TriangleBlock& block, std::span<const Vec3> vertices,
                                          std::span<const Triangle> all,
                                          std::span<const uint32_t> order, double* found) const {
  size_t used = 0;
  const auto place_of = [&](const Vec3& corner) {
    size_t at = 0;
    while (at < used &&
           !(found[at] == corner.x && found[at + 1] == corner.y && found[at + 2] == corner.z))
      at += 3;
    if (at == used) {
      for (int axis = 0; axis < 3; ++axis) found[used++] = corner[axis];
    }
    return static_cast<uint8_t>(at);
  };
  block.turned = 0;
  for (uint32_t i = 0; i < kWidth; ++i) {
    const uint32_t number = order[std::min<size_t>(i, order.size() - 1)];
    std::array<Vec3, 3> own;
    for (size_t k = 0; k < 3; ++k) own[k] = vertices[all[number][k]] - origin;
    if (sort_corners(own)) block.turned |= 1u << i;
    block.a[i] = place_of(own[0]);
    block.b[i] = place_of(own[1]);
    block.c[i] = place_of(own[2]);
    block.triangle[i] = number;
  }
  block.count = static_cast<uint32_t>(order.size());
  return used;
}

std::vector<uint32_t> NearestTriangles::Impl::make_nodes(std::span<const Vec3> vertices,
                                                         std::span<const Triangle> all,
                                                         Task& task) {
  Buffer<FloatBox> boxes(all.size());
  parallel_for(task, all.size(), kNearestBoxGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      Box3 box;
      for (const uint32_t v : all[i]) box.add(vertices[v] - origin);
      boxes[i] = float_box(box);
    }
  });
  const ProgressSpan span(task, 0.1, 0.8);
  triangle_tree::Nodes tree =
      triangle_tree::build_nodes({boxes.data(), boxes.size()}, kWidth, kWidth, task);
  nodes = std::move(tree.nodes);
  return std::move(tree.order);
}

size_t NearestTriangles::Impl::make_blocks(std::span<const Vec3> vertices,
                                           std::span<const Triangle> all,
                                           std::span<const uint32_t> order, Task& task) {
  const std::vector<uint32_t> firsts = count_leaves(nodes, task);
  blocks = Buffer<TriangleBlock>(firsts.back());
  corners.resize(firsts.size() - 1);
  std::atomic<size_t> stacked{0};
  parallel_for(task, nodes.size(), kNodeGrain, [&](size_t begin, size_t end) {
    const size_t chunk = begin / kNodeGrain;
    size_t stacked_here = 0;
    uint32_t leaf = firsts[chunk];
    std::vector<double> found;
    std::vector<size_t> begins;
    for (size_t n = begin; n < end; ++n)
      for (uint32_t i = 0; i < kWidth; ++i) {
        if (nodes[n].count[i] == 0) continue;
        double own[kMostDoubles];
        const size_t used = fill_block(blocks[leaf], vertices, all,
                                       order.subspan(nodes[n].child[i], nodes[n].count[i]), own);
        stacked_here += stacked_in(blocks[leaf], own, kStackCell * kTouchingShare * span_m);
        begins.push_back(found.size());
        found.insert(found.end(), own, own + used);
        nodes[n].child[i] = leaf++;
      }
    corners[chunk] = Buffer<double>(found.size());
    std::copy(found.begin(), found.end(), corners[chunk].data());
    for (size_t b = 0; b < begins.size(); ++b)
      blocks[firsts[chunk] + b].corners = corners[chunk].data() + begins[b];
    stacked += stacked_here;
  });
  return stacked;
}

// Children stand behind their node.
void NearestTriangles::Impl::find_least(Task& task) {
  least = Buffer<uint32_t>(nodes.size() * kWidth);
  for (size_t n = nodes.size(); n-- > 0;) {
    if (n % kNodeGrain == 0) task.checkpoint(0);
    for (uint32_t i = 0; i < kWidth; ++i) {
      uint32_t& out = least[n * kWidth + i] = kNoTriangle;
      const uint32_t child = nodes[n].child[i];
      if (nodes[n].count[i] > 0) {
        const TriangleBlock& block = blocks[child];
        out = *std::min_element(block.triangle, block.triangle + kWidth);
      } else if (child != 0) {
        const uint32_t* below = least.data() + size_t{child} * kWidth;
        out = *std::min_element(below, below + kWidth);
      }
    }
  }
}

// Where very many triangles lie on one another, points on them would look at them all, and so would their sides: which
// is the nearest is rounding.
void NearestTriangles::Impl::make_distinct(std::span<const Vec3> vertices,
                                           std::span<const Triangle> all, Task& task) {
  const TriangleStacks found =
      triangle_stacks(vertices, all, origin, kStackCell * kTouchingShare * span_m, task);
  distinct = found.distinct.size();
  std::vector<Triangle> own;
  own.reserve(distinct);
  for (const uint32_t t : found.distinct) own.push_back(all[t]);
  make_blocks(vertices, own, make_nodes(vertices, own, task), task);
  stacks.resize(blocks.size() * kWidth);
  parallel_for(task, blocks.size(), kNodeGrain, [&](size_t begin, size_t end) {
    for (size_t place = begin * kWidth; place < end * kWidth; ++place) {
      uint32_t& number = blocks[place / kWidth].triangle[place % kWidth];
      stacks[place] = found.stacks[number];
      number = found.distinct[number];
    }
  });
}

NearestTriangles::NearestTriangles() : impl_(std::make_unique<Impl>()) {}
NearestTriangles::~NearestTriangles() = default;
size_t NearestTriangles::size() const { return impl_->triangles; }
size_t NearestTriangles::distinct() const { return impl_->distinct; }
size_t NearestTriangles::memory_bytes() const {
  size_t bytes = sizeof(Impl) + impl_->nodes.capacity() * sizeof(Node) +
                 impl_->blocks.size() * sizeof(TriangleBlock) +
                 impl_->least.size() * sizeof(uint32_t) +
                 impl_->stacks.capacity() * sizeof(TriangleStack);
  for (const Buffer<double>& chunk : impl_->corners) bytes += chunk.size() * sizeof(double);
  return bytes;
}

std::shared_ptr<const NearestTriangles> NearestTriangles::build(std::span<const Vec3> vertices,
                                                                std::span<const Triangle> triangles,
                                                                Task& task) {
  std::shared_ptr<NearestTriangles> out(new NearestTriangles);
  Impl& impl = *out->impl_;
  if (triangles.size() >= ~uint32_t{0} / kWidth)
    fail(Status::kLimit, "a mesh holds at most 2^30 - 2 triangles");
  if (triangles.empty()) return out;
  impl.triangles = impl.distinct = triangles.size();
  // 1. The local frame: whole metres.
  const Box3 world = box_of(vertices, triangles, task);
  impl.origin = {std::floor(world.min.x), std::floor(world.min.y), std::floor(world.min.z)};
  const Vec3 top = world.max - impl.origin;
  impl.span_m = std::max({top.x, top.y, top.z});
  if (!(impl.span_m <= kNearestMaxSpan_m)) fail(Status::kLimit, "a mesh may span 1e9 m at most");
  // 2. The nodes, and the triangles of each leaf side by side.
  const auto order = impl.make_nodes(vertices, triangles, task);
  if (impl.make_blocks(vertices, triangles, order, task) > kManyStacked)
    impl.make_distinct(vertices, triangles, task);
  impl.find_least(task);
  return out;
}

TriangleAnswer NearestTriangles::Impl::answer_of(const NearestOfBlocks& found, const Vec3& local,
                                                 double max_distance,
                                                 const TriangleQuestions& questions) const {
  TriangleAnswer answer;
  if (found.triangle == kNoTriangle) return answer;
  const double distance = std::sqrt(found.squared);
  if (distance > max_distance) return answer;
  answer.distance = distance;
  answer.triangle = found.triangle;
  const TriangleBlock& block = blocks[found.place / kWidth];
  const uint32_t lane = found.place % kWidth;
  // Above a face, as most points are, the search has seen the side already.
  answer.is_behind = questions.sides && found.height != 0 &&
                     (found.height < 0) != ((block.turned >> lane & 1) != 0);
  if (!questions.feet && (found.height != 0 || !questions.sides)) return answer;
  const ClosestOfTriangle closest = closest_of(block, lane, local);
  answer.feature = closest.feature;
  answer.foot = origin + closest.foot;
  answer.from_foot = closest.above;
  if (!questions.sides || found.height != 0) return answer;
  const SideOfSurface side = side_of_surface(touching(), block, lane, closest);
  answer.is_behind = side.is_behind;
  answer.side = side.basis;
  return answer;
}

void NearestTriangles::ask(std::span<const double> xyz, std::span<const uint32_t> order,
                           double max_distance, const TriangleQuestions& questions, Task& task,
                           Visit visit, void* context) const {
  const Impl& impl = *impl_;
  const TriangleBlocks tree = impl.view();
  const auto search = use_avx2() ? nearest_triangles_avx2 : nearest_triangles_baseline;
  const double limit2 = limit_of(max_distance);
  // Where very many triangles lie on one another, a point looks at them all, and so does its side.
  const auto check_cancel = [&] {
    if (task.cancelled()) fail(Status::kCancelled, "cancelled");
  };
  parallel_for(task, order.size(), kAskGrain, [&](size_t begin, size_t end) {
    std::array<double, 3> local[kRun];
    NearestOfBlocks found[kRun];
    size_t place_of[kRun];
    for (size_t first = begin; first < end; first += kRun) {
      const size_t count = std::min(kRun, end - first);
      // Equal points that follow one another are asked once.
      size_t places = 0;
      for (size_t i = 0; i < count; ++i) {
        const double* p = xyz.data() + 3 * size_t{order[first + i]};
        for (size_t axis = 0; axis < 3; ++axis)
          local[places][axis] = p[axis] - impl.origin[static_cast<int>(axis)];
        if (places == 0 || !are_same_bits(local[places], local[places - 1]))
          found[places++] = {limit2, kNoTriangle, 0, 0};
        place_of[i] = places - 1;
      }
      for (size_t i = 0; i < places && impl.triangles > 0; i += kSearchesPerCheck) {
        check_cancel();
        search(tree, local[i].data(), std::min(kSearchesPerCheck, places - i), found + i);
      }
      TriangleAnswer answer;
      for (size_t i = 0; i < count; ++i) {
        const size_t place = place_of[i];
        check_cancel();
        if (i == 0 || place != place_of[i - 1]) {
          const auto& [x, y, z] = local[place];
          answer = impl.answer_of(found[place], {x, y, z}, max_distance, questions);
        }
        visit(context, order[first + i], answer);
      }
    }
  });
}

TriangleAnswer NearestTriangles::nearest(const Vec3& point, double max_distance,
                                         const TriangleQuestions& questions) const {
  const Vec3 local = point - impl_->origin;
  const double xyz[3] = {local.x, local.y, local.z};
  NearestOfBlocks found = {limit_of(max_distance), kNoTriangle, 0, 0};
  if (impl_->triangles > 0) nearest_triangles_baseline(impl_->view(), xyz, 1, &found);
  return impl_->answer_of(found, local, max_distance, questions);
}

}  // namespace jalon
