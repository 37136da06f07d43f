// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/patches.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kPatchesMostBins = 1 << 20;
constexpr uint32_t kNone = 0xffffffffu;
constexpr size_t kTrianglesPerCheck = 1 << 16;
constexpr size_t kPatchesPerCheck = 1 << 12;
constexpr size_t kMostBinsPerPatch = 16;  // 64 bytes

}  // namespace

Patches::Patches(const FlatTriangles& flats, UnionFind& groups, Task& task) {
  // 1. A patch for each root; a root is the first triangle of its group.
  std::vector<uint32_t> patch_of(flats.size(), kNone);
  std::vector<uint32_t> counts;
  std::vector<double> largest_area;
  for (uint32_t t = 0; t < flats.size(); ++t) {
    if (t % kTrianglesPerCheck == 0) task.checkpoint(0.5 * t / flats.size());
    if (!flats.is_flat(t)) continue;
    const uint32_t root = groups.find(t);
    if (root == t) {
      patch_of[t] = static_cast<uint32_t>(patches_.size());
      patches_.push_back({{}, t, 0});
      counts.push_back(0);
      largest_area.push_back(0);
    }
    const uint32_t p = patch_of[t] = patch_of[root];
    ++counts[p];
    if (const double area = flats.area(t); area > largest_area[p])
      largest_area[p] = area, patches_[p].largest = t;
    patches_[p].box += flats.box(t);
  }
  // 2. Their triangles, patch by patch.
  uint32_t sum = 0;
  for (size_t p = 0; p < patches_.size(); ++p) {
    patches_[p].first = sum;
    sum += counts[p];
    counts[p] = patches_[p].first;
  }
  triangles_.resize(sum);
  for (uint32_t t = 0; t < flats.size(); ++t) {
    if (t % kTrianglesPerCheck == 0) task.checkpoint(0.5 + 0.5 * t / flats.size());
    if (patch_of[t] != kNone) triangles_[counts[patch_of[t]]++] = t;
  }
}

bool meet(const Box3& a, const Box3& b) {
  for (int k = 0; k < 3; ++k)
    if (a.min[k] > b.max[k] + kTouching_m || b.min[k] > a.max[k] + kTouching_m) return false;
  return true;
}

PatchBins::PatchBins(const Patches& patches, Task& task) {
  Box3 all;
  for (size_t p = 0; p < patches.size(); ++p) all += patches[p].box;
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](int a, int b) { return all.max[a] - all.min[a] > all.max[b] - all.min[b]; });
  for (size_t k = 0; k < 2; ++k) axis_[k] = axes[k];
  // 1. As many bins as patches; fewer where large patches would be in too many of them.
  const double n = std::clamp(static_cast<double>(patches.size()), 1.0, kPatchesMostBins);
  for (side_ = static_cast<size_t>(std::ceil(std::sqrt(n)));; side_ = (side_ + 1) / 2) {
    for (size_t k = 0; k < 2; ++k) {
      from_[k] = all.min[axis_[k]];
      const double extent = all.max[axis_[k]] - from_[k];
      per_m_[k] = extent > 0 ? static_cast<double>(side_) / extent : 0;
    }
    if (side_ == 1 || entries(patches, task) <= kMostBinsPerPatch * patches.size()) break;
  }
  // 2. Counted, then filled.
  std::vector<size_t> place(side_ * side_ + 1, 0);
  for_each_bin(patches, task, [&](size_t, size_t bin) { ++place[bin + 1]; });
  for (size_t b = 1; b < place.size(); ++b) place[b] += place[b - 1];
  first_ = place;
  members_.resize(first_.back());
  for_each_bin(patches, task,
               [&](size_t p, size_t bin) { members_[place[bin]++] = static_cast<uint32_t>(p); });
}

template <class F>
void PatchBins::for_each_bin(const Patches& patches, Task& task, F&& f) const {
  for (size_t p = 0; p < patches.size(); ++p) {
    if (p % kPatchesPerCheck == 0) task.checkpoint(0);
    const auto [i0, i1, j0, j1] = range(patches[p].box);
    for (size_t j = j0; j <= j1; ++j)
      for (size_t i = i0; i <= i1; ++i) f(p, j * side_ + i);
  }
}

std::array<size_t, 4> PatchBins::range(const Box3& box) const {
  return {at(0, box.min, -kTouching_m), at(0, box.max, kTouching_m), at(1, box.min, -kTouching_m),
          at(1, box.max, kTouching_m)};
}

size_t PatchBins::entries(const Patches& patches, Task& task) const {
  size_t sum = 0;
  for (size_t p = 0; p < patches.size(); ++p) {
    if (p % kPatchesPerCheck == 0) task.checkpoint(0);
    const auto [i0, i1, j0, j1] = range(patches[p].box);
    sum += (i1 - i0 + 1) * (j1 - j0 + 1);
  }
  return sum;
}

size_t PatchBins::bin_of(const Box3& a, const Box3& b) const {
  Vec3 low;
  for (int k = 0; k < 3; ++k) low[k] = std::max(a.min[k], b.min[k]);
  return at(1, low, -kTouching_m) * side_ + at(0, low, -kTouching_m);
}

size_t PatchBins::at(size_t k, const Vec3& p, double shift) const {
  const double i = (p[axis_[k]] + shift - from_[k]) * per_m_[k];
  return static_cast<size_t>(std::clamp(i, 0.0, static_cast<double>(side_ - 1)));
}

}  // namespace jalon
