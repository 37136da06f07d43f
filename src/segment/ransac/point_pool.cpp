// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/point_pool.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

#include "base/numbers.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/simd.h"

namespace jalon {

namespace {

constexpr size_t kSmallPool = 8192;  // below, one piece: the whole is counted at once
constexpr size_t kBlocksPerChunk = 256;
constexpr size_t kBlocksShared = 2048;  // from so many on a count is worth waking the other threads
constexpr size_t kPointsPerStretch = 1 << 15;
constexpr uint64_t kPieceStream = 0x70696563;  // keeps this choice apart from the draws

// 1, 3, 12 and 48 of 64 parts.
uint8_t random_piece(uint64_t seed, uint32_t position) {
  RandomStream random(seed ^ kPieceStream, position);
  const uint64_t part = random.bits() >> 58;
  return part < 1 ? 0 : part < 4 ? 1 : part < 16 ? 2 : 3;
}

uint32_t mark(const PointColumns& points, const PlaneTest& test, uint32_t mask[kBlockPoints / 32]) {
  return mark_block(points, test, mask);
}
uint32_t mark(const PointColumns& points, const CurvedTest& test,
              uint32_t mask[kBlockPoints / 32]) {
  return mark_curved(points, test, mask);
}

}  // namespace

PointPool::PointPool(const RansacScene& scene, Task& task) : avx2_(use_avx2()) {
  share_out(scene, task);
  values_ = Buffer<float>(6 * slots_);
  boxes_ = Buffer<float>(6 * first_block_[kPieces]);
  parallel_for(task, first_block_[kPieces], kBlocksPerChunk, [&](size_t begin, size_t end) {
    for (size_t block = begin; block < end; ++block) fill_block(scene, block);
  });
}

// A slot for each free point, ascending in its piece: counted by stretches of points, then put in place.
void PointPool::share_out(const RansacScene& scene, Task& task) {
  const size_t stretches = (scene.size() + kPointsPerStretch - 1) / kPointsPerStretch;
  std::vector<std::array<size_t, kPieces>> next(stretches);
  const auto for_each_free = [&](size_t stretch, auto&& take) {
    const size_t end = std::min(scene.size(), (stretch + 1) * kPointsPerStretch);
    for (size_t i = stretch * kPointsPerStretch; i < end; ++i)
      if (scene.owner[i] == 0)
        take(static_cast<uint32_t>(i), random_piece(scene.draw.seed, static_cast<uint32_t>(i)));
  };
  parallel_chunks(task, stretches, [&](size_t stretch) {
    std::array<size_t, kPieces> counts{};
    for_each_free(stretch, [&](uint32_t, uint8_t piece) { ++counts[piece]; });
    next[stretch] = counts;
  });
  for (const auto& counts : next)
    for (size_t p = 0; p < kPieces; ++p) piece_free_[p] += counts[p];
  free_ = built_ = points_upto(kPieces - 1);
  const bool is_small = free_ < kSmallPool;
  if (is_small) piece_free_ = {0, 0, 0, free_};
  std::array<size_t, kPieces> sum{};
  for (size_t p = 0; p < kPieces; ++p) {
    sum[p] = first_block_[p] * kBlockPoints;
    first_block_[p + 1] = first_block_[p] + (piece_free_[p] + kBlockPoints - 1) / kBlockPoints;
  }
  for (auto& counts : next) {
    if (is_small) counts = {0, 0, 0, counts[0] + counts[1] + counts[2] + counts[3]};
    for (size_t p = 0; p < kPieces; ++p) counts[p] = std::exchange(sum[p], sum[p] + counts[p]);
  }
  slots_ = first_block_[kPieces] * kBlockPoints;
  positions_ = Buffer<uint32_t>(slots_);
  for (size_t p = 0; p < kPieces; ++p)  // the last block of a piece may not be full
    std::fill(positions_.begin() + sum[p], positions_.begin() + first_block_[p + 1] * kBlockPoints,
              kNoPoint);
  parallel_chunks(task, stretches, [&](size_t stretch) {
    for_each_free(stretch, [&](uint32_t position, uint8_t piece) {
      positions_[next[stretch][is_small ? kPieces - 1 : piece]++] = position;
    });
  });
}

void PointPool::fill_block(const SegmentScene& scene, size_t block) {
  Box3 box;
  for (size_t slot = block * kBlockPoints; slot < (block + 1) * kBlockPoints; ++slot) {
    const uint32_t position = positions_[slot];
    float v[6] = {kFloatNaN, 0, 0, kFloatNaN, 0, 0};
    if (position != kNoPoint) {
      const Vec3 p = scene.local(position);
      for (int k = 0; k < 3; ++k) v[k] = static_cast<float>(p[k]);
      for (size_t k = 0; k < 3; ++k) v[3 + k] = scene.normals[size_t{3} * position + k];
      box.add({v[0], v[1], v[2]});
    }
    for (size_t k = 0; k < 6; ++k) values_[k * slots_ + slot] = v[k];
  }
  for (int k = 0; k < 3; ++k) {
    const size_t at = 6 * block + static_cast<size_t>(k);
    boxes_[at] = static_cast<float>((box.min[k] + box.max[k]) / 2);
    boxes_[at + 3] = static_cast<float>((box.max[k] - box.min[k]) / 2);
  }
}

size_t PointPool::points_upto(size_t last) const {
  size_t sum = 0;
  for (size_t p = 0; p <= last; ++p) sum += piece_free_[p];
  return sum;
}

bool PointPool::may_touch(size_t block, const PlaneTest& t) const {
  const float* b = &boxes_[6 * block];
  const float distance = b[0] * t.nx + b[1] * t.ny + b[2] * t.nz - t.offset;
  const float reach =
      b[3] * std::fabs(t.nx) + b[4] * std::fabs(t.ny) + b[5] * std::fabs(t.nz) + t.tolerance;
  // A few roundings of the terms above, so that pruning never loses a point that the kernel would count.
  const float slack =
      1e-6f * (std::fabs(b[0]) + std::fabs(b[1]) + std::fabs(b[2]) + std::fabs(t.offset) + reach);
  return std::fabs(distance) <= reach + slack;
}

// By the ball around the box.
bool PointPool::may_touch(size_t block, const CurvedTest& t) const {
  const float* b = &boxes_[6 * block];
  const Vec3 axis{t.ax, t.ay, t.az};
  Vec3 d{double{b[0]} - t.cx, double{b[1]} - t.cy, double{b[2]} - t.cz};
  const double far = norm(d), half = norm(Vec3{b[3], b[4], b[5]});
  d -= dot(d, axis) * axis;
  const double inner = std::sqrt(double{t.inner2}), outer = std::sqrt(double{t.outer2});
  const double distance = norm(d),
               reach = half + 1e-6 * (far + half + outer);  // with a few roundings of the kernel
  return distance + reach >= inner && distance - reach <= outer;
}

PointColumns PointPool::columns(size_t block) const {
  const float* p = values_.data() + block * kBlockPoints;
  return {p, p + slots_, p + 2 * slots_, p + 3 * slots_, p + 4 * slots_, p + 5 * slots_};
}

template <class Test>
uint32_t PointPool::count_of(size_t piece, const Test& test, Task& task) const {
  const size_t first = first_block_[piece], blocks = first_block_[piece + 1] - first;
  const auto count_some = [&](size_t begin, size_t end) {
    uint32_t sum = 0;
    for (size_t block = first + begin; block < first + end; ++block)
      if (may_touch(block, test)) sum += count_in_block(block, test);
    return sum;
  };
  if (blocks < kBlocksShared) return count_some(0, blocks);
  return parallel_reduce(task, blocks, kBlocksPerChunk, uint32_t{0}, count_some);
}
template uint32_t PointPool::count_of(size_t, const PlaneTest&, Task&) const;
template uint32_t PointPool::count_of(size_t, const CurvedTest&, Task&) const;

uint32_t PointPool::count_in_block(size_t block, const PlaneTest& test) const {
  return avx2_ ? count_block_avx2(columns(block), test)
               : count_block_baseline(columns(block), test);
}

uint32_t PointPool::count_in_block(size_t block, const CurvedTest& test) const {
  return avx2_ ? count_curved_avx2(columns(block), test)
               : count_curved_baseline(columns(block), test);
}

bool PointPool::overlaps(size_t block, const Box3& box) const {
  const float* b = &boxes_[6 * block];
  for (int k = 0; k < 3; ++k)
    if (b[k] - b[3 + k] > box.max[k] || b[k] + b[3 + k] < box.min[k]) return false;
  return true;
}

template <class Test>
uint32_t PointPool::write_inliers(size_t block, const Test& test, const Box3& box,
                                  uint32_t* out) const {
  uint32_t mask[kBlockPoints / 32], written = 0;
  const PointColumns c = columns(block);
  mark(c, test, mask);
  for (size_t word = 0; word < kBlockPoints / 32; ++word)
    for (uint32_t bits = mask[word]; bits != 0; bits &= bits - 1) {
      const size_t i = 32 * word + static_cast<size_t>(std::countr_zero(bits));
      if (box.contains({c.x[i], c.y[i], c.z[i]}))
        out[written++] = static_cast<uint32_t>(block * kBlockPoints + i);
    }
  return written;
}

// 1. each block's inliers are counted, wherever in the block; 2. those in the box are written into that room; 3. the
// rooms are moved together.
template <class Test>
std::vector<uint32_t> PointPool::slots_of(const Test& test, const Box3& box, Task& task) const {
  std::vector<uint32_t> counts(first_block_[kPieces]), firsts(counts.size());
  parallel_for(task, counts.size(), kBlocksPerChunk, [&](size_t begin, size_t end) {
    for (size_t block = begin; block < end; ++block)
      counts[block] =
          overlaps(block, box) && may_touch(block, test) ? count_in_block(block, test) : 0;
  });
  std::exclusive_scan(counts.begin(), counts.end(), firsts.begin(), 0u);
  std::vector<uint32_t> slots(counts.empty() ? 0 : firsts.back() + counts.back());
  parallel_for(task, counts.size(), kBlocksPerChunk, [&](size_t begin, size_t end) {
    for (size_t block = begin; block < end; ++block)
      if (counts[block] != 0)
        counts[block] = write_inliers(block, test, box, &slots[firsts[block]]);
  });
  size_t used = 0;
  for (size_t block = 0; block < counts.size(); ++block) {
    if (used != firsts[block])
      std::copy_n(slots.data() + firsts[block], counts[block], slots.data() + used);
    used += counts[block];
  }
  slots.resize(used);
  return slots;
}

std::vector<uint32_t> PointPool::collect(const PlaneTest& test, const Box3& box, Task& task) const {
  return slots_of(test, box, task);
}

std::vector<uint32_t> PointPool::collect(const CurvedTest& test, Task& task) const {
  Box3 everywhere;
  std::swap(everywhere.min, everywhere.max);
  return slots_of(test, everywhere, task);
}

void PointPool::remove(std::span<const uint32_t> slots, Task& task) {
  parallel_for(task, slots.size(), kPointsPerStretch, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) values_[slots[i]] = kFloatNaN;
  });
  auto from = slots.begin();
  for (size_t p = 0; p < kPieces; ++p) {
    const auto to = std::lower_bound(from, slots.end(), first_block_[p + 1] * kBlockPoints);
    piece_free_[p] -= static_cast<size_t>(to - from);
    from = to;
  }
  free_ -= slots.size();
}

}  // namespace jalon
