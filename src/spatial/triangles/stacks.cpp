// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangles/stacks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"

namespace jalon {

namespace {

using Triangle = std::array<uint32_t, 3>;

constexpr size_t kStackGrain = size_t{1} << 14;  // triangles: about 1 ms
constexpr size_t kParts = 256;                   // of the hashes, sorted side by side

/// The cells of a triangle's corners, ascending.
struct CornerCells {
  std::array<std::array<int64_t, 3>, 3> cells;
  bool is_turned;  ///< sorting them turned it over

  bool has_three() const { return cells[0] != cells[1] && cells[1] != cells[2]; }
};

/// Finds the triangles on one another.
class Stacking {
 public:
  Stacking(std::span<const Vec3> vertices, std::span<const Triangle> triangles, const Vec3& origin,
           double cell_m, Task& task)
      : vertices_(vertices), triangles_(triangles), origin_(origin), cell_m_(cell_m), task_(task) {}

  TriangleStacks find() {
    stack_.resize(triangles_.size());
    share_out();
    parallel_chunks(task_, kParts, [&](size_t p) {
      std::vector<Entry>& part = parts_[p];
      std::sort(part.begin(), part.end());
      for (size_t first = 0, last = 0; first < part.size(); first = last) {
        while (last < part.size() && part[last].hash == part[first].hash) ++last;
        if (last - first >= kHighStack) join({part.data() + first, last - first});
      }
    });
    TriangleStacks out;
    for (uint32_t t = 0; t < stack_.size(); ++t) {
      if (stack_[t].alike == 0) continue;
      out.distinct.push_back(t);
      out.stacks.push_back(stack_[t]);
    }
    return out;
  }

 private:
  struct Entry {
    uint64_t hash;
    uint32_t triangle;
    bool operator<(const Entry& b) const {
      return hash < b.hash || (hash == b.hash && triangle < b.triangle);
    }
  };

  CornerCells cells_of(uint32_t triangle) const {
    CornerCells out{};
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 local = vertices_[triangles_[triangle][k]] - origin_;
      for (int axis = 0; axis < 3; ++axis)
        out.cells[k][static_cast<size_t>(axis)] =
            static_cast<int64_t>(std::floor(local[axis] / cell_m_));
    }
    for (const auto& [i, j] : {std::pair<size_t, size_t>{0, 1}, {1, 2}, {0, 1}})
      if (out.cells[j] < out.cells[i]) {
        std::swap(out.cells[i], out.cells[j]);
        out.is_turned = !out.is_turned;
      }
    return out;
  }

  static uint64_t hash_of(const CornerCells& corners) {
    constexpr uint64_t kOdd = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio (Knuth, 6.4)
    uint64_t hash = 0;
    for (const auto& cell : corners.cells)
      for (const int64_t c : cell) {
        hash = (hash ^ static_cast<uint64_t>(c)) * kOdd;
        hash ^= hash >> 32;
      }
    return hash;
  }

  // 1. The triangles by the first bits of their hashes.
  void share_out() {
    std::vector<uint64_t> hashes(triangles_.size());
    std::vector<uint8_t> is_large(triangles_.size());
    parallel_for(task_, triangles_.size(), kStackGrain, [&](size_t begin, size_t end) {
      for (size_t t = begin; t < end; ++t) {
        const CornerCells corners = cells_of(static_cast<uint32_t>(t));
        hashes[t] = hash_of(corners);
        is_large[t] = corners.has_three() ? 1 : 0;
      }
    });
    parts_.resize(kParts);
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      if (t % kStackGrain == 0) task_.checkpoint(0);
      if (is_large[t] != 0)
        parts_[hashes[t] / (~uint64_t{0} / kParts + 1)].push_back({hashes[t], t});
    }
  }

  // 2. Those of one hash and of the cells of the first: the first stands for them.
  void join(std::span<const Entry> entries) {
    const CornerCells first = cells_of(entries.front().triangle);
    std::vector<std::pair<uint32_t, bool>> members;
    for (const Entry& entry : entries) {
      const CornerCells own = cells_of(entry.triangle);
      if (own.cells == first.cells) members.emplace_back(entry.triangle, own.is_turned);
    }
    if (members.size() < kHighStack) return;
    TriangleStack stack{0, 0};
    for (const auto& [triangle, is_turned] : members) {
      ++(is_turned == first.is_turned ? stack.alike : stack.reversed);
      stack_[triangle] = {0, 0};
    }
    stack_[entries.front().triangle] = stack;
  }

  std::span<const Vec3> vertices_;
  std::span<const Triangle> triangles_;
  const Vec3 origin_;
  const double cell_m_;
  Task& task_;
  std::vector<std::vector<Entry>> parts_;
  std::vector<TriangleStack> stack_;  // of each triangle; none alike: another one stands for it
};

}  // namespace

size_t stacked_in(const TriangleBlock& block, const double* corners, double near_m) {
  const auto are_near = [&](uint8_t p, uint8_t q) {
    for (size_t axis = 0; axis < 3; ++axis)
      if (!(std::fabs(corners[p + axis] - corners[q + axis]) <= near_m)) return false;
    return true;
  };
  size_t stacked = 0;
  for (uint32_t i = 1; i < block.count; ++i)
    stacked += are_near(block.a[i], block.a[0]) && are_near(block.b[i], block.b[0]) &&
               are_near(block.c[i], block.c[0]);
  return stacked;
}

TriangleStacks triangle_stacks(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                               const Vec3& origin, double cell_m, Task& task) {
  return Stacking(vertices, triangles, origin, cell_m, task).find();
}

}  // namespace jalon
