// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/touching.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/polygon2.h"

namespace jalon {

namespace {

constexpr double kAngle = 1.7453292519943296e-5;  // 0.001 degrees: what counts as one plane
constexpr double kDistance_m = 1e-4;              // 0.1 mm
constexpr double kMostBins = 1 << 20;
constexpr size_t kCheckEvery = 4096;

/// A connected group of coplanar triangles.
struct Patch {
  Box3 box;
  uint32_t largest = 0;  ///< the triangle whose plane is the patch's
  std::vector<uint32_t> triangles;
};

Box3 box_of(const FlatTriangle& t) {
  Box3 box;
  for (const Vec3& c : t.corners) box.add(c);
  return box;
}

bool meet(const Box3& a, const Box3& b) {
  for (int k = 0; k < 3; ++k)
    if (a.min[k] > b.max[k] + kDistance_m || b.min[k] > a.max[k] + kDistance_m) return false;
  return true;
}

std::vector<Patch> patches_of(const std::vector<FlatTriangle>& flats, UnionFind& groups) {
  constexpr uint32_t kNone = 0xffffffffu;
  std::vector<uint32_t> patch_of_root(flats.size(), kNone);
  std::vector<Patch> patches;
  for (uint32_t i = 0; i < flats.size(); ++i) {
    uint32_t& p = patch_of_root[groups.find(i)];
    if (p == kNone) {
      p = static_cast<uint32_t>(patches.size());
      patches.push_back({{}, i, {}});
    }
    Patch& patch = patches[p];
    patch.triangles.push_back(i);
    if (flats[i].area > flats[patch.largest].area) patch.largest = i;
    for (const Vec3& c : flats[i].corners) patch.box.add(c);
  }
  return patches;
}

bool lies_in(const FlatTriangle& t, const Plane& plane) {
  return std::all_of(t.corners.begin(), t.corners.end(),
                     [&](const Vec3& c) { return std::abs(plane.distance(c)) <= kDistance_m; });
}

/// Two triangles of one plane, in coordinates of that plane.
bool touch(const std::array<Vec2, 3>& a, const std::array<Vec2, 3>& b) {
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) {
      const Vec2 &p = a[i], &q = a[(i + 1) % 3], &r = b[j], &s = b[(j + 1) % 3];
      if (segment_distance(p, r, s) <= kDistance_m || segment_distance(r, p, q) <= kDistance_m ||
          segments_meet(p, q, r, s))
        return true;
    }
  return contains(a, b[0]) || contains(b, a[0]);
}

/// Whether two patches of one plane come within the distance of each other.
bool touch(const std::vector<FlatTriangle>& flats, const Patch& a, const Patch& b) {
  const Vec3 n = flats[a.largest].plane.normal;
  const Vec3 u = normalized(std::abs(n.z) < 0.9 ? cross(Vec3{0, 0, 1}, n) : cross(Vec3{0, 1, 0}, n)), v = cross(n, u);
  const auto near = [&](const Patch& patch, const Box3& box) {
    std::vector<std::array<Vec2, 3>> out;
    for (const uint32_t t : patch.triangles)
      if (meet(box_of(flats[t]), box)) {
        out.emplace_back();
        for (size_t k = 0; k < 3; ++k) out.back()[k] = {dot(flats[t].corners[k], u), dot(flats[t].corners[k], v)};
      }
    return out;
  };
  const auto in_a = near(a, b.box), in_b = near(b, a.box);
  for (const auto& s : in_a)
    for (const auto& t : in_b)
      if (touch(s, t)) return true;
  return false;
}

bool are_coplanar(const std::vector<FlatTriangle>& flats, const Patch& a, const Patch& b) {
  const FlatTriangle &s = flats[a.largest], &t = flats[b.largest];
  if (norm(cross(s.plane.normal, t.plane.normal)) > kAngle) return false;
  const auto lies = [&](const Patch& patch, const Plane& plane) {
    return std::all_of(patch.triangles.begin(), patch.triangles.end(),
                       [&](uint32_t k) { return lies_in(flats[k], plane); });
  };
  return lies_in(t, s.plane) && lies(b, s.plane) && lies(a, t.plane);
}

/// A grid over the two widest extents, about as many bins as patches: only patches of one bin can touch.
class Bins {
 public:
  explicit Bins(const std::vector<Patch>& patches) {
    Box3 all;
    for (const Patch& p : patches) all.add(p.box.min), all.add(p.box.max);
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(),
                     [&](int a, int b) { return all.max[a] - all.min[a] > all.max[b] - all.min[b]; });
    const double side = std::ceil(std::sqrt(std::min(kMostBins, static_cast<double>(patches.size()))));
    for (size_t k = 0; k < 2; ++k) {
      axis_[k] = axes[k];
      from_[k] = all.min[axes[k]];
      const double extent = all.max[axes[k]] - all.min[axes[k]];
      count_[k] = static_cast<size_t>(side);
      per_m_[k] = extent > 0 ? side / extent : 0;
    }
    members_.resize(count_[0] * count_[1]);
    for (uint32_t p = 0; p < patches.size(); ++p)
      for (size_t j = at(1, patches[p].box.min, -1); j <= at(1, patches[p].box.max, 1); ++j)
        for (size_t i = at(0, patches[p].box.min, -1); i <= at(0, patches[p].box.max, 1); ++i)
          members_[j * count_[0] + i].push_back(p);
  }
  const std::vector<std::vector<uint32_t>>& members() const { return members_; }

 private:
  size_t at(size_t k, const Vec3& p, int side) const {
    const double i = (p[axis_[k]] + side * kDistance_m - from_[k]) * per_m_[k];
    return static_cast<size_t>(std::clamp(i, 0.0, static_cast<double>(count_[k] - 1)));
  }
  std::array<int, 2> axis_{};
  std::array<double, 2> from_{}, per_m_{};
  std::array<size_t, 2> count_{};
  std::vector<std::vector<uint32_t>> members_;
};

}  // namespace

bool are_coplanar(const FlatTriangle& a, const FlatTriangle& b) {
  return norm(cross(a.plane.normal, b.plane.normal)) <= kAngle && lies_in(a, b.plane) && lies_in(b, a.plane);
}

void join_touching(const std::vector<FlatTriangle>& flats, UnionFind& groups, Task& task) {
  const std::vector<Patch> patches = patches_of(flats, groups);
  if (patches.empty()) return;
  const Bins bins(patches);
  size_t compared = 0;
  for (size_t bin = 0; bin < bins.members().size(); ++bin) {
    const auto& members = bins.members()[bin];
    for (size_t i = 0; i < members.size(); ++i)
      for (size_t j = i + 1; j < members.size(); ++j) {
        if (++compared % kCheckEvery == 0)
          task.checkpoint(0.5 + 0.5 * static_cast<double>(bin) / static_cast<double>(bins.members().size()));
        const Patch &a = patches[members[i]], &b = patches[members[j]];
        if (!meet(a.box, b.box)) continue;
        if (groups.find(a.largest) == groups.find(b.largest)) continue;
        if (are_coplanar(flats, a, b) && touch(flats, a, b)) groups.join(a.largest, b.largest);
      }
  }
}

}  // namespace jalon
