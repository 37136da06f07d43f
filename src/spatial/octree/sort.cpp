// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The sort of an octree's points by (code, index), in three moves:
//   1. every point is put on the grid and goes to the bucket of its top levels (two passes over the doubles: count,
//   then move);
//   2. buckets that hold too much of the cloud are split again by their next differing levels (far outliers, uneven
//   density);
//   3. each bucket, now a cell that fits the L2 cache, is sorted by itself and cut into leaves; where more points than
//   a leaf's share a deepest cell, the bits of the grid below it order them, and where they share a grid point, finer
//   grids do (crowds.cpp).
// All moves are stable and the cuts depend on the points only, so any number of threads gives the same bits.

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/parallel.h"
#include "spatial/octree/impl.h"
#include "spatial/partition.h"
#include "spatial/radix_sort.h"

namespace jalon {

namespace {

// Spreads 5 bits to every third place.
constexpr auto kSpread = [] {
  std::array<uint32_t, 32> table{};
  for (uint32_t v = 0; v < 32; ++v) table[v] = static_cast<uint32_t>(spread_bits(v));
  return table;
}();

// Levels (first, first + depth] of the code: a digit of 3 * depth bits, depth <= 5.
struct Digit {
  int first, depth;
  size_t bins() const { return size_t{1} << 3 * depth; }
  uint32_t operator()(const GridPoint& p) const {
    const int shift = kGridBits - first - depth;
    const uint32_t mask = (1u << depth) - 1;
    return kSpread[static_cast<uint32_t>(p.x) >> shift & mask] << 2 |
           kSpread[static_cast<uint32_t>(p.y) >> shift & mask] << 1 |
           kSpread[static_cast<uint32_t>(p.z) >> shift & mask];
  }
};

// A part of the records in which all points agree on the levels above.
struct Bucket {
  size_t first, count;
  bool in_second;  // which of the two record arrays holds it
};

void append_buckets(const std::vector<size_t>& begins, size_t offset, bool in_second,
                    std::vector<Bucket>& buckets) {
  for (size_t b = 0; b + 1 < begins.size(); ++b)
    if (begins[b + 1] > begins[b])
      buckets.push_back({offset + begins[b], begins[b + 1] - begins[b], in_second});
}

// First level at which points of the bucket differ, minus one; kGridBits when all share their grid point.
int common_levels(const GridPoint* points, size_t n, Task& task) {
  struct Bits {
    uint32_t x = 0;
    Bits& operator+=(const Bits& b) {
      x |= b.x;
      return *this;
    }
  };
  const GridPoint p = points[0];
  const Bits bits =
      parallel_reduce(task, n, partition_grain(n), Bits{}, [&](size_t begin, size_t end) {
        uint32_t all = 0;
        for (size_t i = begin; i < end; ++i)
          all |= static_cast<uint32_t>((points[i].x ^ p.x) | (points[i].y ^ p.y) |
                                       (points[i].z ^ p.z));
        return Bits{all};
      });
  return kGridBits - (32 - std::countl_zero(bits.x));
}

// Points of a bucket that is handed on although it is large, all of them on one grid point: they stand by index
// already, and whole leaves of them are as good as all.
constexpr size_t kMostSerial = size_t{1} << 19;  // a cancel has to wait for the sort of a bucket
static_assert(kMostSerial % kLeafPoints == 0);

void append_in_pieces(Bucket bucket, std::vector<Bucket>& buckets) {
  for (; bucket.count > kMostSerial; bucket.first += kMostSerial, bucket.count -= kMostSerial)
    buckets.push_back({bucket.first, kMostSerial, bucket.in_second});
  buckets.push_back(bucket);
}

// Step 2: splits buckets larger than limit until none is left, in code order.
std::vector<Bucket> split_large(std::vector<Bucket> buckets, size_t limit, GridPoint* arrays[2],
                                Task& task) {
  for (bool again = true; again;) {
    again = false;
    std::vector<Bucket> split;
    for (const Bucket& bucket : buckets) {
      GridPoint* from = arrays[bucket.in_second] + bucket.first;
      const int level = bucket.count > limit ? common_levels(from, bucket.count, task) : kGridBits;
      if (level == kGridBits) {
        append_in_pieces(bucket, split);
        continue;
      }
      const Digit digit{level, std::min(4, kGridBits - level)};
      const auto begins =
          partition(bucket.count, digit.bins(), digit, task,
                    arrays[!bucket.in_second] + bucket.first, [from](size_t i) { return from[i]; });
      append_buckets(begins, bucket.first, !bucket.in_second, split);
      again = true;
    }
    buckets.swap(split);
  }
  return buckets;
}

// Equal pieces.
void cut_evenly(size_t first, size_t last, size_t offset, std::vector<uint32_t>& leaves) {
  for (size_t i = first; i < last; i += kLeafPoints)
    leaves.push_back(static_cast<uint32_t>(offset + i));
}

// Cuts sorted codes into leaves: runs of at most kLeafPoints points that never leave a cell which is too large for one
// leaf. Neighbouring children of such a cell share a leaf while they fit; same_code(first, last) cuts more points of
// one code, whose codes are not read any more.
template <class SameCode>
void cut_leaves(const uint64_t* codes, size_t first, size_t last, size_t offset,
                std::vector<uint32_t>& leaves, const SameCode& same_code) {
  if (last - first <= kLeafPoints) return leaves.push_back(static_cast<uint32_t>(offset + first));
  const uint64_t differing = codes[first] ^ codes[last - 1];
  if (differing == 0) return same_code(first, last);
  const int shift = (63 - std::countl_zero(differing)) / 3 * 3;
  size_t open = first;  // where the leaf begins that still takes children
  for (size_t begin = first; begin < last;) {
    const uint64_t next = ((codes[begin] >> shift) + 1) << shift;
    const size_t end =
        static_cast<size_t>(std::lower_bound(codes + begin, codes + last, next) - codes);
    if (end - begin > kLeafPoints) {
      if (open < begin) leaves.push_back(static_cast<uint32_t>(offset + open));
      cut_leaves(codes, begin, end, offset, leaves, same_code);
      open = end;
    } else if (end - open > kLeafPoints) {
      leaves.push_back(static_cast<uint32_t>(offset + open));
      open = begin;
    }
    begin = end;
  }
  if (open < last) leaves.push_back(static_cast<uint32_t>(offset + open));
}

// The code of a grid point within its deepest cell.
uint64_t code_below(const GridPoint& p) {
  constexpr uint32_t mask = (1u << (kGridBits - kMaxLevel)) - 1;
  return morton_code(static_cast<uint32_t>(p.x) & mask, static_cast<uint32_t>(p.y) & mask,
                     static_cast<uint32_t>(p.z) & mask);
}

// Step 3 for one bucket: the order of its points to sorted.values, its leaves behind the others.
void sort_bucket(const GridPoint* points, size_t count, size_t offset, KeyedRange sorted,
                 KeyedRange scratch, std::vector<uint32_t>& leaves) {
  for (size_t i = 0; i < count; ++i) {
    sorted.keys[i] = code_of(points[i].x, points[i].y, points[i].z);
    sorted.values[i] = static_cast<uint32_t>(i);
  }
  sort_pairs(sorted, scratch, count);
  const auto same_point = [&](size_t first, size_t last) {
    cut_evenly(first, last, offset, leaves);
  };
  const auto same_cell = [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i) sorted.keys[i] = code_below(points[sorted.values[i]]);
    sort_pairs({sorted.keys + first, sorted.values + first},
               {scratch.keys + first, scratch.values + first}, last - first);
    cut_leaves(sorted.keys, first, last, offset, leaves, same_point);
  };
  cut_leaves(sorted.keys, 0, count, offset, leaves, same_cell);
}

}  // namespace

void Octree::Impl::sort_points(Task& task) {
  // Steps 1: buckets of some thousand points for a surface that fills the cube.
  constexpr size_t kBucketGoal =
      512;  // most cells of a surface's cube are empty, so the occupied ones hold far more
  int depth = 1;
  while (depth < 5 && (count >> 3 * depth) > kBucketGoal / 2) ++depth;
  // Both halves of the records are there until the last point has its place in the tree.
  require_memory(count * (2 * sizeof(GridPoint) + 3 * sizeof(int32_t) + sizeof(uint32_t)));
  Buffer<GridPoint> first_half(count), second_half(count);
  GridPoint* arrays[2] = {first_half.data(), second_half.data()};
  std::atomic<bool> all_on_grid{true};
  std::vector<Bucket> buckets;
  {
    ProgressSpan span(task, 0, 0.5, "sorting points");
    have_pages(arrays[0], count, task);
    const Vec3 o = cube.origin;
    const double inverse = inverse_step, s = step;
    const double* p = xyz.data();
    const auto to_grid = [=](size_t i) {
      return on_grid_of(p + 3 * i, o, inverse, static_cast<uint32_t>(i));
    };
    const Digit digit{0, depth};
    append_buckets(partition(count, digit.bins(), digit, task, arrays[0], to_grid), 0, false,
                   buckets);
    parallel_for(task, count, partition_grain(count), [&](size_t begin, size_t end) {
      bool exact = true;
      for (size_t i = begin; i < end; ++i) {
        const GridPoint g = to_grid(i);
        const double* q = p + 3 * i;
        exact &= (o.x + g.x * s == q[0]) & (o.y + g.y * s == q[1]) & (o.z + g.z * s == q[2]);
        if (!exact) break;
      }
      if (!exact) all_on_grid.store(false, std::memory_order_relaxed);
    });
  }
  on_grid = all_on_grid;
  ProgressSpan rest(task, 0.5, 1);
  constexpr size_t kTaskPoints = size_t{1} << 15;
  {
    ProgressSpan span(task, 0, 0.3);
    buckets = split_large(std::move(buckets), std::clamp(count / 16, 4 * kTaskPoints, kMostSerial),
                          arrays, task);
  }

  // Step 3, in groups of buckets worth a hand-over.
  x = Buffer<int32_t>(count);
  y = Buffer<int32_t>(count);
  z = Buffer<int32_t>(count);
  order = Buffer<uint32_t>(count);
  const auto groups =
      groups_of(buckets.size(), kTaskPoints, [&](size_t b) { return buckets[b].count; });
  std::vector<std::vector<uint32_t>> leaves_of(groups.size() - 1);
  ProgressSpan span(task, 0.3, 1);
  parallel_chunks(task, groups.size() - 1, [&](size_t g) {
    size_t most = 0;
    for (size_t b = groups[g]; b < groups[g + 1]; ++b) most = std::max(most, buckets[b].count);
    Buffer<uint64_t> keys(2 * most);
    Buffer<uint32_t> values(2 * most);
    for (size_t b = groups[g]; b < groups[g + 1]; ++b) {
      const Bucket& bucket = buckets[b];
      const GridPoint* from = arrays[bucket.in_second] + bucket.first;
      sort_bucket(from, bucket.count, bucket.first, {keys.data(), values.data()},
                  {keys.data() + most, values.data() + most}, leaves_of[g]);
      for (size_t i = 0; i < bucket.count; ++i) {
        const GridPoint& q = from[values[i]];
        x[bucket.first + i] = q.x;
        y[bucket.first + i] = q.y;
        z[bucket.first + i] = q.z;
        order[bucket.first + i] = q.index;
      }
    }
  });

  for (const auto& part : leaves_of) leaves += part.size();
  leaf_first = Buffer<uint32_t>(leaves + 1);
  size_t at = 0;
  for (const auto& part : leaves_of) {
    std::copy(part.begin(), part.end(), leaf_first.data() + at);
    at += part.size();
  }
  leaf_first[leaves] = static_cast<uint32_t>(count);
}

}  // namespace jalon
