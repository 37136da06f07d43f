// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// All points within a radius of every point, leaf by leaf: the points in the leaf's box widened by the radius are
// gathered once, and each point of the leaf picks its own from them in the vector lanes (ball_kernel.inc). Points too
// close to the border of the ball to call on the grid are settled from the caller's doubles.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "base/simd.h"
#include "spatial/neighbours/ball_kernel.h"
#include "spatial/octree/exact_walk.h"
#include "spatial/octree/impl.h"

namespace jalon {

namespace {

constexpr int64_t kBallBatchWholeCube = int64_t{1} << 31;
constexpr double kBallBatchSqrt3 =
    1.7320508075688773;         // a distance on the grid is less than that wrong, in steps
constexpr size_t kVector = 16;  // room that the kernels may write beyond the end
// Neighbours that are handed on at once, at least those of one point.
constexpr size_t kMostNeighbours = size_t{1} << 21;

struct BallBatchKernels {
  bool (*gather)(const OctreeView&, const GridBox&, BallCandidates&);
  size_t (*pick)(const BallCandidates&, const Ball&, uint32_t*, float*, size_t&);
};

class BallSearch {
 public:
  BallSearch(const Octree::Impl& tree, double radius_m, const BallBatchKernels& kernels)
      : tree_(tree),
        radius_m_(radius_m),
        radius_(radius_m * tree.inverse_step),
        kernels_(kernels),
        exactly_(tree.has_exact_boxes() && radius_ < kFewSteps) {
    constexpr double kRounding = 1 + 0x1p-20;  // of a squared distance in floats
    const double inner = std::max(0.0, radius_ - kBallBatchSqrt3),
                 outer = radius_ + kBallBatchSqrt3;
    surely_ = static_cast<float>(std::min(inner * inner / kRounding / kRounding, 0x1p100));
    perhaps_ = static_cast<float>(std::min(outer * outer * kRounding * kRounding, 0x1p101));
    if (radius_ < kBallBatchSqrt3) surely_ = -1;
    reserve(size_t{1} << 12);
  }

  /// Gathers what the points of a leaf need.
  void enter(size_t leaf) {
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
      reserve(2 * candidates_.room);
    }
  }

  /// The most points that pick() will give for a point of that leaf.
  size_t candidates(size_t point) {
    if (!exactly_) return candidates_.count;
    find_exactly(point);
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
  void find_exactly(size_t point) {
    const Vec3 centre = tree_.exact_point(point);
    const double most = radius_m_ * radius_m_;
    close_.clear();
    exact_runs(
        tree_,
        [&](const ExactBlock& block, size_t slot) {
          return squared_distance(block, slot, centre) <= most;
        },
        [&](size_t first, size_t last) {
          for (size_t i = first; i < last; ++i)
            if (squared_norm(tree_.exact_point(i) - centre) <= most)
              close_.push_back(static_cast<uint32_t>(i));
        });
  }

  // What was found exactly, with the distances that the vector loop gives.
  size_t write(size_t point, uint32_t* neighbours, float* squared) const {
    const auto square_step = static_cast<float>(tree_.step * tree_.step);
    for (size_t j = 0; j < close_.size(); ++j) {
      const uint32_t i = close_[j];
      const auto dx = static_cast<float>(tree_.x[i] - tree_.x[point]),
                 dy = static_cast<float>(tree_.y[i] - tree_.y[point]),
                 dz = static_cast<float>(tree_.z[i] - tree_.z[point]);
      neighbours[j] = i;
      squared[j] = (dx * dx + dy * dy + dz * dz) * square_step;
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
  const bool exactly_;
  std::vector<uint32_t> close_;
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

void Octree::ball_batches(double radius_m, Task& task, void (*visit)(void*, const BallBatch&),
                          void* context) const {
  if (!(radius_m >= 0)) fail(Status::kInvalidArgument, "the radius is negative");
  const BallBatchKernels kernels =
      use_avx2() ? BallBatchKernels{gather_ball_candidates_avx2, points_in_ball_avx2}
                 : BallBatchKernels{gather_ball_candidates_baseline, points_in_ball_baseline};
  constexpr size_t kLeavesAtOnce = 32;
  parallel_for(task, impl_->leaves, kLeavesAtOnce, [&](size_t begin, size_t end) {
    BallSearch search(*impl_, radius_m, kernels);
    Found found;
    size_t first = impl_->leaf_first[begin];
    const auto hand_on = [&] {
      visit(context, {first, found.offsets.size() - 1, found.offsets.data(),
                      found.neighbours.data(), found.squared.data()});
      first += found.offsets.size() - 1;
      found.offsets.assign(1, 0);
    };
    for (size_t leaf = begin; leaf < end; ++leaf) {
      if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      search.enter(leaf);
      for (size_t point = impl_->leaf_first[leaf]; point < impl_->leaf_first[leaf + 1]; ++point) {
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
    if (found.offsets.size() > 1) hand_on();
  });
}

}  // namespace jalon
