// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangles/tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "base/buffer.h"
#include "base/error.h"
#include "base/parallel.h"
#include "spatial/triangles/nodes.h"

namespace jalon {

namespace {

using triangle_tree::Float4;
using triangle_tree::FloatBox;
using triangle_tree::kStackSize;
using triangle_tree::kWidth;
using triangle_tree::Node;

constexpr double kTreeMaxSpan_m = 1e9;   // beyond it floats no longer tell boxes apart
constexpr size_t kTreeBoxGrain = 65536;  // triangles a chunk, about 1 ms
// Boxes grow by this share of the whole: eight roundings of a float (2^-24), for their own corners and for the ray's
// origin.
constexpr double kBoxMargin = 0x1.0p-21;
// Slack of the slab test for the roundings of (bound - origin) / direction in floats: four of them, doubled.
constexpr float kSlabSlack = 0x1.0p-21f;
// Stands for a direction component of 0: moves no point by more than the boxes' margin.
constexpr double kTinyComponent = 1e-20;

struct TreeCorners {
  double a[3], b[3], c[3];  ///< relative to the tree's origin
};

/// What the test of one ray against triangles needs (Woop et al. 2013, section 3): axes permuted so that z is the
/// ray's largest component, and the shear that makes the ray the z axis.
struct WoopRay {
  int kx, ky, kz;
  double sx, sy, sz;
  double origin[3];

  WoopRay(const Vec3& local_origin, const Vec3& d) {
    const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    sz = 1 / d[kz];
    sx = d[kx] * sz;
    sy = d[ky] * sz;
    for (int i = 0; i < 3; ++i) origin[i] = local_origin[i];
  }

  /// t of the triangle's plane where the ray meets the triangle. The edge functions of a shared edge are exact
  /// negatives of each other, and 0 counts as inside for both sides: no gap.
  bool meets(const TreeCorners& triangle, double& t) const {
    const double az = triangle.a[kz] - origin[kz], bz = triangle.b[kz] - origin[kz],
                 cz = triangle.c[kz] - origin[kz];
    const double ax = triangle.a[kx] - origin[kx] - sx * az,
                 ay = triangle.a[ky] - origin[ky] - sy * az;
    const double bx = triangle.b[kx] - origin[kx] - sx * bz,
                 by = triangle.b[ky] - origin[ky] - sy * bz;
    const double cx = triangle.c[kx] - origin[kx] - sx * cz,
                 cy = triangle.c[ky] - origin[ky] - sy * cz;
    const double u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const double determinant = u + v + w;
    if (determinant == 0) return false;
    t = (u * (sz * az) + v * (sz * bz) + w * (sz * cz)) / determinant;
    return true;
  }
};

/// The ray in floats for the boxes: from where it enters the mesh's box, so that far stations lose nothing; t counts
/// from there, in units of the direction's largest component.
struct SlabRay {
  float origin[3], inverse[3];
  int near_row[3], far_row[3];  ///< rows of Node::bounds
  double t_entry = 0, scale = 1;
  double t_end = 0;  ///< where it leaves the box

  bool enter(const Ray& ray, const Vec3& local_origin, const Box3& box) {
    scale =
        std::max({std::abs(ray.direction.x), std::abs(ray.direction.y), std::abs(ray.direction.z)});
    double from = ray.t_min, to = ray.t_max;
    for (int i = 0; i < 3; ++i) {
      double d = ray.direction[i] / scale;
      if (std::abs(d) < kTinyComponent) d = std::signbit(d) ? -kTinyComponent : kTinyComponent;
      const double inverse_d = 1 / d;
      const double t0 = (box.min[i] - local_origin[i]) * inverse_d / scale;
      const double t1 = (box.max[i] - local_origin[i]) * inverse_d / scale;
      from = std::max(from, std::min(t0, t1));
      to = std::min(to, std::max(t0, t1));
      inverse[i] = static_cast<float>(inverse_d);
      near_row[i] = 2 * i + (d < 0 ? 1 : 0);
      far_row[i] = 2 * i + (d < 0 ? 0 : 1);
    }
    if (!(from <= to)) return false;
    t_entry = from;
    t_end = to;
    for (int i = 0; i < 3; ++i)
      origin[i] = static_cast<float>(local_origin[i] + ray.direction[i] * t_entry);
    return true;
  }
  /// A float not less than the t given, as the boxes count it.
  float reach(double t) const {
    return static_cast<float>((t - t_entry) * scale) * (1 + 4 * kSlabSlack) + 1e-30f;
  }
};

// Four lanes at once; the portable forms are what the SSE instructions do, lane by lane.
#if defined(__SSE__)
inline Float4 max4(Float4 a, Float4 b) { return _mm_max_ps(a, b); }
inline Float4 min4(Float4 a, Float4 b) { return _mm_min_ps(a, b); }
inline uint32_t tree_less_equal(Float4 a, Float4 b) {
  return static_cast<uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a, b)));
}
#else
inline Float4 max4(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
inline uint32_t tree_less_equal(Float4 a, Float4 b) {
  uint32_t mask = 0;
  for (uint32_t i = 0; i < kWidth; ++i) mask |= (a[i] <= b[i] ? 1u : 0u) << i;
  return mask;
}
#endif

/// Where the ray enters the four boxes; gives the mask of those it meets before reach.
inline uint32_t slabs(const Node& node, const SlabRay& ray, float reach, Float4& near) {
  const Float4 x0 = (node.bounds[ray.near_row[0]] - ray.origin[0]) * ray.inverse[0];
  const Float4 x1 = (node.bounds[ray.far_row[0]] - ray.origin[0]) * ray.inverse[0];
  const Float4 y0 = (node.bounds[ray.near_row[1]] - ray.origin[1]) * ray.inverse[1];
  const Float4 y1 = (node.bounds[ray.far_row[1]] - ray.origin[1]) * ray.inverse[1];
  const Float4 z0 = (node.bounds[ray.near_row[2]] - ray.origin[2]) * ray.inverse[2];
  const Float4 z1 = (node.bounds[ray.far_row[2]] - ray.origin[2]) * ray.inverse[2];
  const Float4 zero = {0, 0, 0, 0}, all = {reach, reach, reach, reach};
  near = max4(max4(x0, y0), max4(z0, zero));
  const Float4 far = min4(min4(x1, y1), min4(z1, all)) * (1 + kSlabSlack);
  return tree_less_equal(near * (1 - kSlabSlack), far);
}

/// A child still to be visited.
struct Pending {
  uint32_t child, count;
  float near;
};

}  // namespace

struct TriangleTree::Impl {
  Vec3 origin;
  Box3 bounds;         ///< of the corners, relative to origin
  Box3 padded_bounds;  ///< with the boxes' margin
  triangle_tree::Nodes tree;
  Buffer<TreeCorners> corners;  ///< in tree order

  /// visit(t, triangle) gets every hit in the ray's interval and gives back the new end of it; negative infinity
  /// stops.
  template <class F>
  void traverse(const Ray& ray, F&& visit) const;
};

template <class F>
void TriangleTree::Impl::traverse(const Ray& ray, F&& visit) const {
  if (tree.nodes.empty() || !is_finite(ray.direction) || !is_finite(ray.origin)) return;
  const Vec3 local = ray.origin - origin;
  SlabRay slab;
  if (ray.direction == Vec3{} || !slab.enter(ray, local, padded_bounds)) return;
  const WoopRay woop(local, ray.direction);
  double limit = ray.t_max;
  float reach = slab.reach(std::min(limit, slab.t_end));
  std::array<Pending, kStackSize> stack;
  size_t size = 0;
  stack[size++] = {0, 0, 0};
  while (size > 0) {
    const Pending top = stack[--size];
    if (top.near * (1 - kSlabSlack) > reach) continue;
    if (top.count > 0) {
      for (uint32_t k = top.child; k < top.child + top.count; ++k) {
        double t;
        if (!woop.meets(corners[k], t) || !(t >= ray.t_min && t <= limit)) continue;
        limit = visit(t, tree.order[k]);
        if (limit < ray.t_min) return;
        reach = slab.reach(std::min(limit, slab.t_end));
      }
      continue;
    }
    const Node& node = tree.nodes[top.child];
    Float4 near;
    const size_t first = size;  // sorted in, the nearest on top
    for (uint32_t met = slabs(node, slab, reach, near); met != 0; met &= met - 1) {
      const auto i = static_cast<uint32_t>(std::countr_zero(met));
      size_t at = size++;
      for (; at > first && stack[at - 1].near < near[i]; --at) stack[at] = stack[at - 1];
      stack[at] = {node.child[i], node.count[i], near[i]};
    }
  }
}

TriangleTree::TriangleTree() : impl_(std::make_unique<Impl>()) {}
TriangleTree::~TriangleTree() = default;
size_t TriangleTree::size() const { return impl_->tree.order.size(); }
const Vec3& TriangleTree::origin() const { return impl_->origin; }
const Box3& TriangleTree::local_bounds() const { return impl_->bounds; }
size_t TriangleTree::memory_bytes() const {
  return sizeof(Impl) + impl_->tree.nodes.capacity() * sizeof(Node) +
         impl_->tree.order.capacity() * sizeof(uint32_t) +
         impl_->corners.size() * sizeof(TreeCorners);
}

bool TriangleTree::nearest(const Ray& ray, RayHit& hit) const {
  bool found = false;
  impl_->traverse(ray, [&](double t, uint32_t triangle) {
    if (!found || t < hit.t || triangle < hit.triangle) hit = {t, triangle};
    found = true;
    return t;
  });
  return found;
}

bool TriangleTree::occluded(const Ray& ray) const {
  bool found = false;
  impl_->traverse(ray, [&](double, uint32_t) {
    found = true;
    return -std::numeric_limits<double>::infinity();
  });
  return found;
}

std::shared_ptr<const TriangleTree> TriangleTree::build(
    std::span<const Vec3> vertices, std::span<const std::array<uint32_t, 3>> triangles,
    Task& task) {
  std::shared_ptr<TriangleTree> out(new TriangleTree);
  Impl& impl = *out->impl_;
  if (triangles.size() >= ~uint32_t{0})
    fail(Status::kLimit, "a mesh holds at most 2^32 - 2 triangles");
  if (triangles.empty()) return out;

  // 1. The local frame: whole metres, so that a shift by whole metres shifts it and changes no bit.
  const Box3 world =
      parallel_reduce(task, triangles.size(), kTreeBoxGrain, Box3{}, [&](size_t begin, size_t end) {
        Box3 box;
        for (size_t i = begin; i < end; ++i)
          for (const uint32_t v : triangles[i]) box.add(vertices[v]);
        return box;
      });
  impl.origin = {std::floor(world.min.x), std::floor(world.min.y), std::floor(world.min.z)};
  impl.bounds = {world.min - impl.origin, world.max - impl.origin};
  const double span = std::max({impl.bounds.max.x, impl.bounds.max.y, impl.bounds.max.z});
  if (!(span <= kTreeMaxSpan_m)) fail(Status::kLimit, "a mesh may span 1e9 m at most");
  const double margin = kBoxMargin * span;
  const Vec3 margins{margin, margin, margin};
  impl.padded_bounds = {impl.bounds.min - margins, impl.bounds.max + margins};

  // 2. A float box around each triangle.
  Buffer<FloatBox> boxes(triangles.size());
  parallel_for(task, triangles.size(), kTreeBoxGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      Box3 box;
      for (const uint32_t v : triangles[i]) box.add(vertices[v] - impl.origin);
      for (int a = 0; a < 3; ++a) {
        boxes[i].min[a] = static_cast<float>(box.min[a] - margin);
        boxes[i].max[a] = static_cast<float>(box.max[a] + margin);
      }
    }
  });

  // 3. The nodes, and the corners in their order.
  impl.tree =
      triangle_tree::build_nodes({boxes.data(), boxes.size()}, triangle_tree::kLeafSize, 1, task);
  impl.corners = Buffer<TreeCorners>(triangles.size());
  parallel_for(task, triangles.size(), kTreeBoxGrain, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      const auto& t = triangles[impl.tree.order[k]];
      const Vec3 a = vertices[t[0]] - impl.origin, b = vertices[t[1]] - impl.origin,
                 c = vertices[t[2]] - impl.origin;
      impl.corners[k] = {{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
    }
  });
  return out;
}

}  // namespace jalon
