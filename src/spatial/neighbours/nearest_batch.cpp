// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The nearest reference point of every compared point, leaf by leaf of the compared tree, so that neighbours share
// their work:
//   1. gather the reference points in the leaf's box widened by a reach, guessed from the leaf before;
//   2. measure all queries of the leaf against all of them, in the vector lanes (nearest_kernel.inc);
//   3. a query whose answer is not inside the reach: widen it once to what is needed;
//   4. where that gathers too much (surfaces far apart, outliers): one by one through the tree, the answer of the query
//   before as first bound;
//   5. an answer too close to call in single precision on the grid is settled from the caller's doubles.

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>

#include "base/error.h"
#include "base/parallel.h"
#include "base/simd.h"
#include "spatial/neighbours/nearest.h"
#include "spatial/neighbours/nearest_frame.h"
#include "spatial/octree/distinct_points.h"

namespace jalon {

namespace {

constexpr int64_t kWholeFrame = int64_t{1} << 31;
// The reach guessed for a leaf: what the leaf before needed, and a quarter more: repeating costs more than a few
// candidates too many.
constexpr double kNearestBatchGuess = 1.25;
// Surfaces farther apart than so many sides of the leaf have far more points in reach than can be nearest.
constexpr double kNearestBatchFarOff = 4;
// Two coordinates that are wrong by less than 2 steps each: a distance is wrong by less than 2 sqrt(3).
constexpr double kNearestBatchGridError = 3.4642;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct NearestBatchKernels {
  bool (*gather)(const OctreeView&, const GridMap&, const GridBox&, const int32_t*,
                 NearCandidates&);
  void (*of_group)(const NearCandidates&, NearestGroup&);
  void (*of_one)(const OctreeView&, const GridMap&, const int32_t*, float, NearestOne&);
};

class LeafSearch {
 public:
  LeafSearch(const Octree& reference, const Octree& compared, const SearchFrame& frame,
             double max_distance_m, bool frame_is_coarse, const NearestBatchKernels& kernels)
      : reference_(reference.impl()),
        compared_(compared.impl()),
        frame_(frame),
        most_m2_(max_distance_m * max_distance_m),
        frame_is_coarse_(frame_is_coarse),
        max_reach_(std::min(max_distance_m / frame.step + 2 * kNearestBatchGridError,
                            static_cast<double>(2 * kWholeFrame))),
        kernels_(kernels) {}

  /// Sorted positions in the reference for the points of one leaf.
  void leaf(size_t leaf, uint32_t* nearest) {
    const size_t first = compared_.leaf_first[leaf], count = compared_.leaf_first[leaf + 1] - first;
    load_queries(first, count);
    uint32_t pending = (1u << count) - 1;
    if (reach_ == 0 && !guess_reach(nearest)) return one_by_one(pending, nearest);
    for (int attempt = 0;; ++attempt) {
      double needed = 0;
      if (!try_reach(pending, needed)) return one_by_one(pending, nearest);
      pending = write(pending, nearest);
      if (pending == 0) {
        reach_ = std::min(max_reach_, kNearestBatchGuess * largest_ + 2 * kNearestBatchGridError);
        return;
      }
      if (attempt != 0 || needed > kNearestBatchFarOff * std::max(reach_, side_))
        return one_by_one(pending, nearest);
      reach_ = std::min(max_reach_, needed + 4 * kNearestBatchGridError);
    }
  }

 private:
  void load_queries(size_t first, size_t count) {
    first_ = first;
    group_.count = static_cast<uint32_t>(count);
    const int32_t* from[3] = {compared_.x.data() + first, compared_.y.data() + first,
                              compared_.z.data() + first};
    float* to[3] = {group_.x, group_.y, group_.z};
    side_ = 0;
    for (int axis = 0; axis < 3; ++axis) {
      int32_t hi = 0, lo = std::numeric_limits<int32_t>::max();
      for (size_t i = 0; i < count; ++i) {
        const int32_t v = (from[axis][i] >> frame_.compared.shift) + frame_.compared.offset[axis];
        query_[axis][i] = v;
        lo = std::min(lo, v);
        hi = std::max(hi, v);
      }
      anchor_[axis] = lo;
      top_[axis] = hi;
      side_ = std::max(side_, static_cast<double>(hi) - lo);
      for (size_t i = 0; i < kMostQueries; ++i)
        to[axis][i] = static_cast<float>(query_[axis][std::min(i, count - 1)] - lo);
    }
    for (uint32_t q = 0; q < group_.count; ++q) known_[q] = kNoPoint;
  }

  // The first query alone says how far the reference is; false when it is too far for a common gathering.
  bool guess_reach(uint32_t* nearest) {
    nearest[0] = search_one(0, last_);
    if (nearest[0] == kNoPoint) return false;
    known_[0] = last_ = nearest[0];
    const double distance = std::sqrt(static_cast<double>(squared_on_grid(0, nearest[0])));
    if (distance > kNearestBatchFarOff * side_) return false;
    reach_ = std::min(max_reach_, std::max(kNearestBatchGuess * distance, side_ / 2) +
                                      2 * kNearestBatchGridError);
    return true;
  }

  // Steps 1 and 2; false when there are too many candidates, or none.
  bool try_reach(uint32_t pending, double& needed) {
    GridBox wide;
    const auto reach = static_cast<int64_t>(reach_);
    for (int axis = 0; axis < 3; ++axis) {
      const int64_t from = anchor_[axis] - reach - frame_.reference.offset[axis];
      const int64_t to = top_[axis] + reach + 1 - frame_.reference.offset[axis];
      wide.lo[axis] = on_grid(from);
      wide.hi[axis] = on_grid(to);
    }
    if (!kernels_.gather(reference_.view, frame_.reference, wide, anchor_, candidates_))
      return false;
    if (candidates_.count == 0 && reach_ < max_reach_) return false;
    kernels_.of_group(candidates_, group_);
    // Offsets from the anchor are rounded to 24 bits.
    const double rounding = (side_ + reach_) * 0x1p-22;
    error_ = static_cast<float>(2 * (kNearestBatchGridError + rounding));
    // A point outside the box is farther than the reach.
    const double sure = std::max(0.0, std::floor(reach_) - kNearestBatchGridError - rounding);
    largest_ = 0;
    complete_ = 0;
    for (uint32_t q = 0; q < group_.count; ++q) {
      if (!(pending >> q & 1)) continue;
      const double distance = std::sqrt(static_cast<double>(group_.best[q])) * (1 + 0x1p-20);
      if (distance < sure || reach_ >= max_reach_) {
        complete_ |= 1u << q;
        if (group_.best[q] < kInfinity) largest_ = std::max(largest_, distance);
      } else {
        needed = std::max(needed, distance);
      }
    }
    return true;
  }

  // A coordinate of the frame, relative to the reference's offset, on the reference's own grid.
  int32_t on_grid(int64_t v) const {
    const int64_t limit = (kWholeFrame >> frame_.reference.shift) + 1;
    const int64_t scaled =
        std::clamp<int64_t>(v, -1, limit) * (int64_t{1} << frame_.reference.shift);
    return static_cast<int32_t>(std::clamp<int64_t>(scaled, 0, kWholeFrame - 1));
  }

  // Writes what is complete; returns what is not.
  uint32_t write(uint32_t pending, uint32_t* nearest) {
    const NearLimit limit{error_};
    for (uint32_t q = 0; q < group_.count; ++q) {
      if (!(pending >> q & 1)) continue;
      const bool there = group_.best[q] < kInfinity;
      uint32_t position = there ? candidates_.position[group_.candidate[q]] : kNoPoint;
      if (!(complete_ >> q & 1)) {
        known_[q] = position;
        continue;
      }
      if (there && group_.second[q] <= limit(group_.best[q]))
        position = settle(q, limit(group_.best[q]));
      nearest[q] = position;
      if (there) last_ = position;
    }
    return pending & ~complete_;
  }

  struct NearLimit {
    float error;
    float operator()(float best) const {
      return (best + 2 * error * std::sqrt(best) + error * error) * (1 + 0x1p-19f);
    }
  };

  // Step 5 among the candidates.
  uint32_t settle(uint32_t q, float limit) const {
    const Vec3 query = compared_.exact_point(first_ + q);
    double best = std::numeric_limits<double>::infinity();
    uint32_t position = kNoPoint;
    for (uint32_t c = 0; c < candidates_.count; ++c) {
      const float dx = group_.x[q] - candidates_.x[c], dy = group_.y[q] - candidates_.y[c],
                  dz = group_.z[q] - candidates_.z[c];
      if (dx * dx + dy * dy + dz * dz > limit) continue;
      const uint32_t at = candidates_.position[c];
      const double squared = squared_norm(reference_.exact_point(at) - query);
      if (squared < best ||
          (squared == best && reference_.order[at] < reference_.order[position])) {
        best = squared;
        position = at;
      }
    }
    return position;
  }

  float squared_on_grid(uint32_t q, uint32_t position) const {
    const int32_t* axes[3] = {reference_.x.data(), reference_.y.data(), reference_.z.data()};
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto d = static_cast<float>((axes[axis][position] >> frame_.reference.shift) +
                                        frame_.reference.offset[axis] - query_[axis][q]);
      sum += d * d;
    }
    return sum;
  }

  // Step 4 for one query. start: a point to begin with, or kNoPoint.
  uint32_t search_one(uint32_t q, uint32_t start) const {
    if (frame_is_coarse_) return search_exactly(q, start);
    const auto error = static_cast<float>(2 * kNearestBatchGridError);
    const auto limit = static_cast<float>(max_reach_ * max_reach_ * (1 + 0x1p-20));
    NearestOne one{max_reach_ < static_cast<double>(kWholeFrame) * 2 ? limit : kInfinity, kInfinity,
                   kNoPoint};
    if (start != kNoPoint) {
      const float squared = squared_on_grid(q, start);
      if (squared < one.best) one = {squared, kInfinity, start};
    }
    const int32_t query[3] = {query_[0][q], query_[1][q], query_[2][q]};
    kernels_.of_one(reference_.view, frame_.reference, query, error, one);
    if (one.position == kNoPoint || !(one.second <= NearLimit{error}(one.best)))
      return one.position;
    return reference_.nearest_position(compared_.exact_point(first_ + q),
                                       std::numeric_limits<double>::infinity());
  }

  // The same for a reference whose points the frame does not tell apart.
  uint32_t search_exactly(uint32_t q, uint32_t start) const {
    const Vec3 query = compared_.exact_point(first_ + q);
    const double reach =
        start == kNoPoint ? most_m2_
                          : std::min(most_m2_, squared_norm(reference_.exact_point(start) - query));
    return reference_.nearest_position(query, reach);
  }

  void one_by_one(uint32_t pending, uint32_t* nearest) {
    for (; pending != 0; pending &= pending - 1) {
      const auto q = static_cast<uint32_t>(std::countr_zero(pending));
      nearest[q] = search_one(q, known_[q] != kNoPoint ? known_[q] : last_);
      if (nearest[q] != kNoPoint) last_ = nearest[q];
    }
    reach_ = 0;
  }

  const Octree::Impl& reference_;
  const Octree::Impl& compared_;
  const SearchFrame& frame_;
  const double most_m2_;
  const bool frame_is_coarse_;
  const double max_reach_;  // steps
  const NearestBatchKernels kernels_;
  double reach_ = 0;          // steps; 0 = no guess
  double side_ = 0;           // of the leaf's box
  double largest_ = 0;        // distance of the complete queries of the last attempt
  float error_ = 0;           // of the difference of two distances
  uint32_t complete_ = 0;     // bit q: the answer of query q is certain
  uint32_t last_ = kNoPoint;  // the answer before
  size_t first_ = 0;
  int32_t anchor_[3] = {}, top_[3] = {};
  int32_t query_[3][kMostQueries];
  uint32_t known_[kMostQueries];
  NearestGroup group_;
  NearCandidates candidates_;
};

// Does the frame fail to tell many points of the reference apart?
bool is_coarse(const Octree::Impl& reference, const SearchFrame& frame, Task& task) {
  const int shift = frame.reference.shift;
  return reference.has_exact_boxes() || (shift > 0 && reference.is_crowded_at(shift, task));
}

// Exact distances of a chunk; what is beyond the greatest one is taken back.
void measure(const Octree::Impl& reference, const Octree::Impl& compared, size_t first,
             size_t count, double max_distance_m, uint32_t* nearest, double* squared) {
  constexpr size_t kAhead =
      16;  // queries: their coordinates lie in the caller's order, anywhere in memory
  const double most = max_distance_m * max_distance_m;
  for (size_t i = 0; i < count; ++i) {
    if (i + kAhead < count) {
      if (!compared.on_grid)
        __builtin_prefetch(compared.xyz.data() + 3 * size_t{compared.order[first + i + kAhead]});
      const uint32_t next = nearest[i + kAhead];
      if (!reference.on_grid && next != kNoPoint)
        __builtin_prefetch(reference.xyz.data() + 3 * size_t{reference.order[next]});
    }
    squared[i] = std::numeric_limits<double>::infinity();
    if (nearest[i] == kNoPoint) continue;
    const double d =
        squared_norm(reference.exact_point(nearest[i]) - compared.exact_point(first + i));
    if (d <= most) squared[i] = d;
    else nearest[i] = kNoPoint;
  }
}

}  // namespace

void nearest_batches(const Octree& reference, const Octree& compared, double max_distance_m,
                     Task& task, void (*visit)(void*, const NearestBatch&), void* context) {
  if (!(max_distance_m >= 0)) fail(Status::kInvalidArgument, "the greatest distance is negative");
  if (compared.size() == 0) return;
  if (reference.size() == 0) fail(Status::kInvalidArgument, "the reference has no points");
  const NearestBatchKernels kernels =
      use_avx2() ? NearestBatchKernels{gather_near_avx2, nearest_of_group_avx2, nearest_of_one_avx2}
                 : NearestBatchKernels{gather_near_baseline, nearest_of_group_baseline,
                                       nearest_of_one_baseline};
  const DistinctPoints distinct(reference, task);
  const SearchFrame frame(reference.cube(), compared.cube());
  const bool coarse = is_coarse(distinct.tree().impl(), frame, task);
  const Octree::Impl& queries = compared.impl();
  constexpr size_t kLeavesAtOnce = 256;
  parallel_for(task, queries.leaves, kLeavesAtOnce, [&](size_t begin, size_t end) {
    const size_t first = queries.leaf_first[begin], count = queries.leaf_first[end] - first;
    const auto search = std::make_unique<LeafSearch>(distinct.tree(), compared, frame,
                                                     max_distance_m, coarse, kernels);
    Buffer<uint32_t> nearest(count);
    Buffer<double> squared(count);
    for (size_t leaf = begin; leaf < end; ++leaf) {
      if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      search->leaf(leaf, nearest.data() + queries.leaf_first[leaf] - first);
    }
    for (uint32_t& position : std::span(nearest.data(), count))
      if (position != kNoPoint) position = distinct.position(position);
    measure(reference.impl(), queries, first, count, max_distance_m, nearest.data(),
            squared.data());
    visit(context, {first, count, nearest.data(), squared.data()});
  });
}

}  // namespace jalon
