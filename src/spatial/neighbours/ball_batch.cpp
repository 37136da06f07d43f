// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// All points within a radius of every point, leaf by leaf: the points in the leaf's box widened by the radius are
// gathered once, and each point of the leaf picks its own from them in the vector lanes (ball_kernel.inc). Points too
// close to the border of the ball to call on the grid are settled from the caller's doubles.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "base/simd.h"
#include "spatial/neighbours/ball_kernel.h"
#include "spatial/neighbours/ball_ranges.h"
#include "spatial/neighbours/many_in_ball.h"
#include "spatial/octree/exact_walk.h"
#include "spatial/octree/impl.h"

namespace jalon {

namespace {

constexpr int64_t kBallBatchWholeCube = int64_t{1} << 31;
constexpr double kBallBatchSqrt3 =
    1.7320508075688773;         // a distance on the grid is less than that wrong, in steps
constexpr size_t kVector = 16;  // room that the kernels may write beyond the end
// Neighbours that are handed on at once, at least those of one point: they stay in the cache, and no chunk takes memory
// that the system gives and takes back page by page.
constexpr size_t kMostNeighbours = size_t{1} << 17;
// Points that a leaf of a crowded tree may gather; of balls with more of them, those of a place go together.
constexpr size_t kManyInBall = size_t{1} << 12;
// Where balls of many points go by ranges: the box about a leaf holds some twice as many as a ball.
constexpr size_t kManyGathered = 2 * kManyInRanges;

struct BallBatchKernels {
  bool (*gather)(const OctreeView&, const GridBox&, BallCandidates&);
  size_t (*pick)(const BallCandidates&, const Ball&, uint32_t*, float*, size_t&);
};

class BallSearch {
 public:
  BallSearch(const Octree::Impl& tree, double radius_m, const BallBatchKernels& kernels,
             size_t most_gathered, size_t most_in_ball)
      : tree_(tree),
        radius_m_(radius_m),
        radius_(radius_m * tree.inverse_step),
        kernels_(kernels),
        most_gathered_(most_gathered),
        most_in_ball_(most_in_ball),
        few_steps_(tree.has_exact_boxes() && radius_ < kFewSteps),
        ranges_(tree, radius_m) {
    constexpr double kRounding = 1 + 0x1p-20;  // of a squared distance in floats
    const double inner = std::max(0.0, radius_ - kBallBatchSqrt3),
                 outer = radius_ + kBallBatchSqrt3;
    surely_ = static_cast<float>(std::min(inner * inner / kRounding / kRounding, 0x1p100));
    perhaps_ = static_cast<float>(std::min(outer * outer * kRounding * kRounding, 0x1p101));
    if (radius_ < kBallBatchSqrt3) surely_ = -1;
    reserve(std::min(size_t{1} << 12, most_gathered));
  }

  /// Gathers what the points of a leaf need, unless that is too much.
  void enter(size_t leaf) {
    exactly_ = few_steps_;
    if (exactly_) return;
    const size_t first = tree_.leaf_first[leaf], last = tree_.leaf_first[leaf + 1];
    const auto reach =
        static_cast<int64_t>(std::min(radius_ + 2, static_cast<double>(kBallBatchWholeCube)));
    const int32_t* axes[3] = {tree_.x.data(), tree_.y.data(), tree_.z.data()};
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
      const auto [lo, hi] = std::minmax_element(axes[axis] + first, axes[axis] + last);
      box.lo[axis] = static_cast<int32_t>(std::max<int64_t>(0, *lo - reach));
      box.hi[axis] = static_cast<int32_t>(std::min<int64_t>(kBallBatchWholeCube - 1, *hi + reach));
    }
    for (;;) {
      candidates_.count = 0;
      if (kernels_.gather(tree_.view, box, candidates_)) return;
      exactly_ = candidates_.room >= most_gathered_;
      if (exactly_) return;
      reserve(2 * candidates_.room);
    }
  }

  /// The ball of a point of that leaf by ranges, where it holds too many points for a list.
  std::optional<std::span<const Octree::PointRange>> many(size_t point) {
    if (!exactly_) return std::nullopt;
    const auto ranges = find(point);
    if (ranges_.points() <= most_in_ball_) return std::nullopt;
    return ranges;
  }
  /// Points of the ranges that were asked for last.
  size_t points() const { return ranges_.points(); }

  /// The same by places.
  std::optional<std::span<const Octree::PlaceGroup>> crowd(size_t point) {
    const auto ranges = many(point);
    if (!ranges) return std::nullopt;
    groups_.clear();
    for (const BallRanges::Range& range : *ranges)
      for (size_t first = range.first; first < range.last;) {
        const size_t last = tree_.end_of_place(first, range.last);
        groups_.push_back({static_cast<uint32_t>(first), static_cast<uint32_t>(last),
                           squared_on_grid(point, first)});
        first = last;
      }
    return groups_;
  }

  /// The most points that pick() will give for a point of that leaf.
  size_t candidates(size_t point) {
    if (!exactly_) return candidates_.count;
    close_.clear();
    for (const BallRanges::Range& range : find(point))
      for (uint32_t i = range.first; i < range.last; ++i) close_.push_back(i);
    return close_.size();
  }

  /// Appends the points in the ball of the point that candidates() was asked for last, ascending.
  size_t pick(size_t point, uint32_t* neighbours, float* squared) const {
    if (exactly_) return write(point, neighbours, squared);
    size_t unsure = 0;
    const Ball ball{tree_.x[point], tree_.y[point], tree_.z[point], surely_, perhaps_};
    size_t count = kernels_.pick(candidates_, ball, neighbours, squared, unsure);
    if (unsure != 0) count = settle(point, count, neighbours, squared);
    const auto square_step = static_cast<float>(tree_.step * tree_.step);
    for (size_t j = 0; j < count; ++j) squared[j] *= square_step;
    return count;
  }

 private:
  std::span<const BallRanges::Range> find(size_t point) {
    if (found_of_ != point) found_ = ranges_.find(tree_.exact_point(point));
    found_of_ = point;
    return found_;
  }

  // As the vector loop gives it.
  float squared_on_grid(size_t a, size_t b) const {
    const auto square_step = static_cast<float>(tree_.step * tree_.step);
    const auto dx = static_cast<float>(tree_.x[b] - tree_.x[a]),
               dy = static_cast<float>(tree_.y[b] - tree_.y[a]),
               dz = static_cast<float>(tree_.z[b] - tree_.z[a]);
    return (dx * dx + dy * dy + dz * dz) * square_step;
  }

  size_t write(size_t point, uint32_t* neighbours, float* squared) const {
    for (size_t j = 0; j < close_.size(); ++j) {
      neighbours[j] = close_[j];
      squared[j] = squared_on_grid(point, close_[j]);
    }
    return close_.size();
  }

  void reserve(size_t room) {
    values_ = Buffer<int32_t>(3 * (room + kVector));
    positions_ = Buffer<uint32_t>(room + kVector);
    int32_t* v = values_.data();
    candidates_ = {v, v + room + kVector, v + 2 * (room + kVector), positions_.data(), 0, room};
  }

  size_t settle(size_t point, size_t count, uint32_t* neighbours, float* squared) const {
    const Vec3 centre = tree_.exact_point(point);
    size_t kept = 0;
    for (size_t j = 0; j < count; ++j) {
      if (squared[j] > surely_ &&
          !(squared_norm(tree_.exact_point(neighbours[j]) - centre) <= radius_m_ * radius_m_))
        continue;
      neighbours[kept] = neighbours[j];
      squared[kept++] = squared[j];
    }
    return kept;
  }

  const Octree::Impl& tree_;
  const double radius_m_, radius_;  // radius_: grid steps
  const BallBatchKernels kernels_;
  const size_t most_gathered_, most_in_ball_;
  const bool few_steps_;  // the grid tells too little of such balls
  BallRanges ranges_;
  size_t found_of_ = std::numeric_limits<size_t>::max();  // the point that was asked for last
  std::span<const BallRanges::Range> found_;
  bool exactly_ = false;  // point by point: few steps, or too much for a leaf
  std::vector<uint32_t> close_;
  std::vector<Octree::PlaceGroup> groups_;
  float surely_ = 0, perhaps_ = 0;
  Buffer<int32_t> values_;
  Buffer<uint32_t> positions_;
  BallCandidates candidates_{};
};

// Neighbours of consecutive points, in memory that grows.
struct Found {
  std::vector<uint32_t> offsets{0};
  Buffer<uint32_t> neighbours;
  Buffer<float> squared;

  size_t count() const { return offsets.back(); }
  void reserve(size_t more) {
    const size_t needed = count() + more + kVector;
    if (needed <= neighbours.size()) return;
    Buffer<uint32_t> n(2 * needed);
    Buffer<float> s(2 * needed);
    std::copy_n(neighbours.data(), count(), n.data());
    std::copy_n(squared.data(), count(), s.data());
    neighbours = std::move(n);
    squared = std::move(s);
  }
};

}  // namespace

void Octree::ball_batches(double radius_m, Task& task, const BallVisitors& to) const {
  if (!(radius_m >= 0)) fail(Status::kInvalidArgument, "the radius is negative");
  const BallBatchKernels kernels =
      use_avx2() ? BallBatchKernels{gather_ball_candidates_avx2, points_in_ball_avx2}
                 : BallBatchKernels{gather_ball_candidates_baseline, points_in_ball_baseline};
  constexpr size_t kLeavesAtOnce = 32;
  constexpr size_t kAny = std::numeric_limits<size_t>::max();
  const size_t most_gathered = to.crowded != nullptr  ? kManyInBall
                               : to.ranged != nullptr ? kManyGathered
                                                      : kAny;
  const size_t most_in_ball = to.ranged != nullptr ? kManyInRanges : most_gathered;
  parallel_for(task, impl_->leaves, kLeavesAtOnce, [&](size_t begin, size_t end) {
    BallSearch search(*impl_, radius_m, kernels, most_gathered, most_in_ball);
    Found found;
    size_t first = impl_->leaf_first[begin];
    const auto hand_on = [&] {
      if (found.offsets.size() > 1)
        to.visit(to.context, {first, found.offsets.size() - 1, found.offsets.data(),
                              found.neighbours.data(), found.squared.data()});
      first += found.offsets.size() - 1;
      found.offsets.assign(1, 0);
    };
    // Is the ball of a point, too large for a list, handed on by itself?
    const auto hand_on_alone = [&](size_t point) {
      if (to.crowded != nullptr) {
        const auto groups = search.crowd(point);
        if (!groups) return false;
        hand_on();
        to.crowded(to.crowded_context, {point, *groups});
      } else {
        const auto ranges = to.ranged != nullptr ? search.many(point) : std::nullopt;
        if (!ranges) return false;
        hand_on();
        to.ranged(to.ranged_context, {point, *ranges, search.points()});
      }
      first = point + 1;
      return true;
    };
    for (size_t leaf = begin; leaf < end; ++leaf) {
      if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      search.enter(leaf);
      for (size_t point = impl_->leaf_first[leaf]; point < impl_->leaf_first[leaf + 1]; ++point) {
        if (hand_on_alone(point)) {
          if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
          continue;
        }
        found.reserve(search.candidates(point));
        const size_t at = found.count();
        const size_t more =
            search.pick(point, found.neighbours.data() + at, found.squared.data() + at);
        found.offsets.push_back(static_cast<uint32_t>(at + more));
        if (found.count() < kMostNeighbours) continue;
        hand_on();
        // Where balls hold much of the cloud, a chunk takes long.
        if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      }
    }
    hand_on();
  });
}

}  // namespace jalon
