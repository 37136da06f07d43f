// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/touching.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "geometry/polygon2.h"
#include "scan/patches.h"

namespace jalon {

namespace {

constexpr size_t kBinGrain = 256;
constexpr size_t kTouchingPerCheck = 4096;

/// A piece of a patch's border in coordinates of its plane.
struct Piece {
  Vec2 from, to;
};

/// Directions in a plane.
struct Axes {
  explicit Axes(const Vec3& n)
      : u(normalized(std::abs(n.z) < 0.9 ? cross(Vec3{0, 0, 1}, n) : cross(Vec3{0, 1, 0}, n))),
        v(cross(n, u)) {}
  Vec2 flat(const Vec3& p) const { return {dot(p, u), dot(p, v)}; }
  Vec3 u, v;
};

bool near(const Piece& a, const Piece& b) {
  const auto apart = [](double a0, double a1, double b0, double b1) {
    return std::max(a0, a1) + kTouching_m < std::min(b0, b1) ||
           std::max(b0, b1) + kTouching_m < std::min(a0, a1);
  };
  if (apart(a.from.u, a.to.u, b.from.u, b.to.u) || apart(a.from.v, a.to.v, b.from.v, b.to.v))
    return false;
  return segment_distance(a.from, b.from, b.to) <= kTouching_m ||
         segment_distance(a.to, b.from, b.to) <= kTouching_m ||
         segment_distance(b.from, a.from, a.to) <= kTouching_m ||
         segment_distance(b.to, a.from, a.to) <= kTouching_m ||
         segments_meet(a.from, a.to, b.from, b.to);
}

class Comparison {
 public:
  Comparison(const FlatTriangles& flats, std::span<const uint8_t> inner_edges,
             const Patches& patches, const Task& task)
      : flats_(flats), inner_edges_(inner_edges), patches_(patches), task_(task) {}

  bool are_one(uint32_t a, uint32_t b) const {
    if (!meet(patches_[a].box, patches_[b].box)) return false;
    return are_coplanar(a, b) && touch(a, b);
  }

 private:
  bool lies_in(uint32_t patch, const Plane& plane) const {
    const auto triangles = patches_.triangles(patch);
    return std::all_of(triangles.begin(), triangles.end(),
                       [&](uint32_t t) { return flats_.lies_in(t, plane); });
  }
  bool are_coplanar(uint32_t a, uint32_t b) const {
    const uint32_t s = patches_[a].largest, t = patches_[b].largest;
    return flats_.are_coplanar(s, t) && lies_in(b, flats_.plane(s)) && lies_in(a, flats_.plane(t));
  }

  /// The border where it is near the other's box.
  std::vector<Piece> border(uint32_t patch, const Box3& box, const Axes& axes) const {
    std::vector<Piece> out;
    for (const uint32_t t : patches_.triangles(patch))
      for (size_t k = 0; k < 3; ++k) {
        if ((inner_edges_[t] >> k & 1) != 0) continue;
        Box3 of_edge;
        of_edge.add(flats_.corner(t, k));
        of_edge.add(flats_.corner(t, k + 1));
        if (meet(of_edge, box))
          out.push_back({axes.flat(flats_.corner(t, k)), axes.flat(flats_.corner(t, k + 1))});
      }
    return out;
  }

  bool covers(uint32_t patch, const Vec2& p, const Axes& axes) const {
    for (const uint32_t t : patches_.triangles(patch)) {
      const std::array<Vec2, 3> corners{axes.flat(flats_.corner(t, 0)),
                                        axes.flat(flats_.corner(t, 1)),
                                        axes.flat(flats_.corner(t, 2))};
      if (contains(corners, p)) return true;
    }
    return false;
  }

  /// Borders that come near each other, or one patch inside the other.
  bool touch(uint32_t a, uint32_t b) const {
    const Axes axes(flats_.plane(patches_[a].largest).normal);
    const std::vector<Piece> of_a = border(a, patches_[b].box, axes),
                             of_b = border(b, patches_[a].box, axes);
    size_t compared = 0;
    for (const Piece& s : of_a)
      for (const Piece& t : of_b) {
        if (++compared % kTouchingPerCheck == 0 && task_.cancelled()) return false;
        if (near(s, t)) return true;
      }
    return covers(a, axes.flat(flats_.corner(patches_[b].largest, 0)), axes) ||
           covers(b, axes.flat(flats_.corner(patches_[a].largest, 0)), axes);
  }

  const FlatTriangles& flats_;
  std::span<const uint8_t> inner_edges_;
  const Patches& patches_;
  const Task& task_;
};

}  // namespace

void join_touching(const FlatTriangles& flats, std::span<const uint8_t> inner_edges,
                   UnionFind& groups, Task& task) {
  // 1. Patches, and which of them may meet.
  const Patches patches(flats, groups, task);
  if (patches.size() < 2) return;
  const PatchBins bins(patches, task);
  // 2. Pairs that are one plane, each compared in one bin.
  const Comparison comparison(flats, inner_edges, patches, task);
  std::vector<std::vector<std::array<uint32_t, 2>>> pairs((bins.size() + kBinGrain - 1) /
                                                          kBinGrain);
  parallel_for(task, bins.size(), kBinGrain, [&](size_t begin, size_t end) {
    for (size_t bin = begin; bin < end; ++bin) {
      const auto members = bins.members(bin);
      for (size_t i = 0; i < members.size() && !task.cancelled(); ++i)
        for (size_t j = i + 1; j < members.size(); ++j)
          if (bins.bin_of(patches[members[i]].box, patches[members[j]].box) == bin &&
              comparison.are_one(members[i], members[j]))
            pairs[begin / kBinGrain].push_back({members[i], members[j]});
    }
  });
  // 3. Joined, whatever the order.
  for (const auto& chunk : pairs)
    for (const auto& [a, b] : chunk) groups.join(patches[a].largest, patches[b].largest);
}

}  // namespace jalon
