// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The k nearest neighbours of every point, leaf by leaf:
//   1. gather the points in the leaf's box widened by a reach, guessed from the leaf before;
//   2. select the k + 1 nearest candidates of all queries of the leaf at once, in the vector lanes (knn_kernel.inc);
//   3. a query whose k-th neighbour is not inside the reach: widen it and repeat; far-off queries are answered one by
//   one;
//   4. a query with distances too close to call in single precision on the grid is settled from the caller's doubles.
// Leaves whose points the grid does not tell apart are answered in doubles (exact_knn.cpp).

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "base/simd.h"
#include "spatial/neighbours/exact_knn.h"
#include "spatial/neighbours/knn_kernel.h"
#include "spatial/neighbours/nearest_by_grid.h"
#include "spatial/octree/impl.h"

namespace jalon {

namespace {

constexpr double kKnnBatchSqrt3 = 1.7320508075688773;
constexpr int64_t kKnnBatchWholeCube = int64_t{1} << 31;
// The reach guessed for a leaf: what the leaf before needed, and a fifth more for less dense ones: repeating costs
// more than a few candidates too many.
constexpr double kKnnBatchGuess = 1.2;
// A leaf that needs this much more than was guessed holds outliers: those are answered one by one.
constexpr double kKnnBatchFarOff = 2.5;

// Settling sorts what is close; of more than so many times k, the boxes in doubles find the k nearest sooner.
constexpr size_t kKnnBatchMostClose = 8;

struct KnnBatchKernels {
  bool (*gather)(const OctreeView&, const GridBox&, Candidates&);
  void (*search)(const Candidates&, KnnGroup&);
};

class BatchSearch {
 public:
  BatchSearch(const Octree& octree, uint32_t k, const KnnBatchKernels& kernels)
      : tree_(octree.impl()),
        k_(k),
        kernels_(kernels),
        exactly_(tree_, k),
        keys_((k + 1) * size_t{kMostQueries}) {}

  /// Sorted positions and squared distances for the points of one leaf.
  void leaf(size_t leaf, uint32_t* neighbours, float* squared) {
    const size_t first = tree_.leaf_first[leaf], count = tree_.leaf_first[leaf + 1] - first;
    load_queries(first, count);
    if (same_point(first, count)) {
      for (size_t q = 0; q < count; ++q)
        for (uint32_t j = 0; j < k_; ++j) {
          neighbours[q * k_ + j] = static_cast<uint32_t>(run_begin_) + j;
          squared[q * k_ + j] = 0;
        }
      return;
    }
    uint32_t pending = (1u << count) - 1;
    if (tree_.has_exact_boxes() && tree_.is_crowded(leaf, 0)) {
      exactly_.leaf(leaf, neighbours);
      for (size_t q = 0; q < count; ++q) measure(first + q, neighbours + q * k_, squared + q * k_);
      return;
    }
    if (reach_ == 0) reach_ = first_reach();
    for (int attempt = 0; pending != 0; ++attempt) {
      const int64_t needed = try_reach(pending);
      if (needed == 0) {
        one_by_one(first, pending, neighbours, squared);
        return;
      }
      const uint32_t done = pending & ~group_.incomplete;
      write(first, done, neighbours, squared);
      pending &= group_.incomplete;
      if (pending == 0) {
        reach_ = std::max<int64_t>(4, static_cast<int64_t>(kKnnBatchGuess * largest_));
        return;
      }
      const bool far_off =
          static_cast<double>(needed) > kKnnBatchFarOff * static_cast<double>(reach_);
      if ((attempt != 0 && far_off) || attempt == 8 || group_.count <= 2) {
        one_by_one(first, pending, neighbours, squared);
        return;
      }
      reach_ = needed;
    }
  }

 private:
  void load_queries(size_t first, size_t count) {
    group_.count = static_cast<uint32_t>(count);
    group_.k = k_;
    group_.keys = keys_.data();
    int32_t* axes[3] = {group_.x, group_.y, group_.z};
    const int32_t* from[3] = {tree_.x.data() + first, tree_.y.data() + first,
                              tree_.z.data() + first};
    for (int axis = 0; axis < 3; ++axis) {
      int32_t lo = from[axis][0], hi = lo;
      for (size_t i = 0; i < count; ++i) {
        axes[axis][i] = from[axis][i];
        lo = std::min(lo, from[axis][i]);
        hi = std::max(hi, from[axis][i]);
      }
      for (size_t i = count; i < kMostQueries; ++i) axes[axis][i] = axes[axis][count - 1];
      box_.lo[axis] = lo;
      box_.hi[axis] = hi;
    }
  }

  // True when the leaf lies in a run of k and more points with the same coordinates: they stand by index, so the first
  // k are the neighbours of all. Without this, many duplicates would cost the square of their number.
  bool same_point(size_t first, size_t count) {
    for (int axis = 0; axis < 3; ++axis)
      if (box_.lo[axis] != box_.hi[axis]) return false;
    if (first < run_begin_ || first + count > run_end_) {
      const auto same = [&](size_t i) {
        return tree_.x[i] == box_.lo[0] && tree_.y[i] == box_.lo[1] && tree_.z[i] == box_.lo[2] &&
               (tree_.on_grid || tree_.exact_point(i) == tree_.exact_point(first));
      };
      run_begin_ = first;
      run_end_ = first;
      while (run_begin_ > 0 && same(run_begin_ - 1)) --run_begin_;
      while (run_end_ < tree_.count && same(run_end_)) ++run_end_;
    }
    return first + count <= run_end_ && run_end_ - run_begin_ >= k_;
  }

  int64_t first_reach() const {
    int64_t side = 16;
    for (int axis = 0; axis < 3; ++axis)
      side = std::max<int64_t>(side, box_.hi[axis] - box_.lo[axis]);
    return side;
  }

  // Steps 1 and 2. The reach that the incomplete queries need; 0 when there are too many candidates.
  int64_t try_reach(uint32_t pending) {
    GridBox wide;
    for (int axis = 0; axis < 3; ++axis) {
      wide.lo[axis] = static_cast<int32_t>(std::max<int64_t>(0, box_.lo[axis] - reach_));
      wide.hi[axis] =
          static_cast<int32_t>(std::min<int64_t>(kKnnBatchWholeCube - 1, box_.hi[axis] + reach_));
    }
    if (!kernels_.gather(tree_.view, wide, candidates_)) return 0;
    if (candidates_.count < k_ && candidates_.count < tree_.count) {
      group_.incomplete = pending;
      return 2 * reach_;
    }
    set_tolerances();
    kernels_.search(candidates_, group_);
    if (candidates_.count == tree_.count) group_.incomplete = 0;
    largest_ = 0;
    double needed = 0;
    for (uint32_t q = 0; q < group_.count; ++q) {
      const double d =
          std::sqrt(static_cast<double>(squared_of(keys_[(k_ - 1) * size_t{kMostQueries} + q])));
      if (group_.incomplete >> q & 1) needed = std::max(needed, d);
      else if (candidates_.count >= k_) largest_ = std::max(largest_, d);
    }
    // More candidates may mean fewer bits next time: allow for the coarsest keys.
    constexpr double kCoarsest = 0x1p-12;
    return static_cast<int64_t>(
        std::min(needed * (1 + 4 * kCoarsest) + 8, static_cast<double>(kKnnBatchWholeCube)));
  }

  double truncation() const {
    return std::ldexp(1.0, static_cast<int>(group_.index_bits) - 23) + 0x1p-20;
  }
  float squared_of(uint32_t key) const {
    return std::bit_cast<float>(key & ~((1u << group_.index_bits) - 1));
  }

  void set_tolerances() {
    group_.index_bits = std::max(1u, static_cast<uint32_t>(std::bit_width(candidates_.count - 1)));
    // A point outside the box is farther than reach_; a distance on the grid is sqrt(3) wrong at most.
    const double sure = std::max(0.0, static_cast<double>(reach_) - kKnnBatchSqrt3 - 0.01);
    group_.covered = static_cast<float>(sure * sure * (1 - 2 * truncation()));
    group_.tie_slope = static_cast<float>(1.01 * truncation());
    // |d_j - d_i| <= 2 sqrt(3) means |d_j^2 - d_i^2| <= 2 sqrt(3) (2 d_k + 2 sqrt(3)).
    group_.tie_root = tree_.on_grid ? 0.0f : 7.0f;
    group_.tie_floor = tree_.on_grid ? 0.0f : 13.0f;
  }

  // The float distance that is handed out: a function of the two grid points alone.
  float squared_metres(size_t a, size_t b) const {
    const auto dx = static_cast<float>(tree_.x[a] - tree_.x[b]),
               dy = static_cast<float>(tree_.y[a] - tree_.y[b]),
               dz = static_cast<float>(tree_.z[a] - tree_.z[b]);
    return (dx * dx + dy * dy + dz * dz) * static_cast<float>(tree_.step * tree_.step);
  }

  void write(size_t first, uint32_t done, uint32_t* neighbours, float* squared) {
    for (; done != 0; done &= done - 1) {
      const auto q = static_cast<uint32_t>(std::countr_zero(done));
      uint32_t* to = neighbours + q * size_t{k_};
      float* to_squared = squared + q * size_t{k_};
      if (group_.ambiguous >> q & 1) {
        settle(first + q, q, to, to_squared);
        continue;
      }
      const uint32_t mask = (1u << group_.index_bits) - 1;
      for (uint32_t j = 0; j < k_; ++j) {
        const uint32_t key = keys_[j * size_t{kMostQueries} + q];
        const uint32_t c = key & mask;
        to[j] = key == kNoKey ? kNoPoint : candidates_.position[c];
        to_squared[j] = key == kNoKey ? std::numeric_limits<float>::infinity()
                                      : squared_metres(first + q, to[j]);
      }
    }
  }

  struct Close {
    double squared;  // on the grid, then exact where it matters
    uint32_t candidate;
  };

  // Step 4: the candidates that may be among the k nearest, in doubles; runs that the grid cannot order by the caller's
  // coordinates.
  void settle(size_t position, uint32_t q, uint32_t* to, float* to_squared) {
    const double slack = tree_.on_grid ? 0 : 2 * kKnnBatchSqrt3 + 1e-3;
    const float kth = squared_of(
        keys_[(k_ - 1) * size_t{kMostQueries} + q]);  // not a number: fewer than k candidates
    const double reach = std::sqrt(static_cast<double>(kth) * (1 + 2 * truncation())) + slack;
    const double limit =
        kth == kth ? reach * reach * (1 + 1e-12) : std::numeric_limits<double>::infinity();
    close_.clear();
    for (uint32_t c = 0; c < candidates_.count; ++c) {
      const double dx = group_.x[q] - candidates_.x[c], dy = group_.y[q] - candidates_.y[c],
                   dz = group_.z[q] - candidates_.z[c];
      const double squared = dx * dx + dy * dy + dz * dz;
      if (squared <= limit) close_.push_back({squared, c});
    }
    if (tree_.has_exact_boxes() && close_.size() > kKnnBatchMostClose * k_)
      return answer_one(position, to, to_squared);
    const auto by_distance = [&](const Close& a, const Close& b) {
      return a.squared < b.squared ||
             (a.squared == b.squared && tree_.order[candidates_.position[a.candidate]] <
                                            tree_.order[candidates_.position[b.candidate]]);
    };
    std::sort(close_.begin(), close_.end(), by_distance);
    if (!tree_.on_grid) {
      const Vec3 query = tree_.exact_point(position);
      for (size_t begin = 0, end; begin < close_.size(); begin = end) {
        for (end = begin + 1; end < close_.size(); ++end)
          if (std::sqrt(close_[end].squared) - std::sqrt(close_[end - 1].squared) > slack) break;
        if (begin >= k_) break;
        if (end - begin == 1) continue;
        for (size_t i = begin; i < end; ++i)
          close_[i].squared =
              squared_norm(tree_.exact_point(candidates_.position[close_[i].candidate]) - query);
        std::sort(close_.begin() + static_cast<ptrdiff_t>(begin),
                  close_.begin() + static_cast<ptrdiff_t>(end), by_distance);
      }
    }
    for (uint32_t j = 0; j < k_; ++j) {
      const bool there = j < close_.size();
      to[j] = there ? candidates_.position[close_[j].candidate] : kNoPoint;
      to_squared[j] =
          there ? squared_metres(position, to[j]) : std::numeric_limits<float>::infinity();
    }
  }

  void answer_one(size_t position, uint32_t* to, float* to_squared) const {
    const int32_t query[3] = {tree_.x[position], tree_.y[position], tree_.z[position]};
    if (tree_.has_exact_boxes() || !nearest_by_grid(tree_, query, tree_.on_grid, k_, to))
      tree_.nearest_of_point(position, k_, to);
    measure(position, to, to_squared);
  }

  void measure(size_t position, const uint32_t* to, float* to_squared) const {
    for (uint32_t j = 0; j < k_; ++j)
      to_squared[j] = to[j] == kNoPoint ? std::numeric_limits<float>::infinity()
                                        : squared_metres(position, to[j]);
  }

  void one_by_one(size_t first, uint32_t pending, uint32_t* neighbours, float* squared) {
    for (; pending != 0; pending &= pending - 1) {
      const auto q = static_cast<size_t>(std::countr_zero(pending));
      answer_one(first + q, neighbours + q * k_, squared + q * k_);
    }
    reach_ = 0;
  }

  const Octree::Impl& tree_;
  const uint32_t k_;
  const KnnBatchKernels kernels_;
  ExactKnn exactly_;
  GridBox box_{};
  int64_t reach_ = 0;                   // grid units; 0 = no guess
  size_t run_begin_ = 0, run_end_ = 0;  // a run of points with the same coordinates
  double largest_ = 0;  // k-th distance of the completed queries of the last attempt
  KnnGroup group_;
  Candidates candidates_;
  Buffer<uint32_t> keys_;
  std::vector<Close> close_;
};

}  // namespace

void Octree::knn_batches(uint32_t k, Task& task, void (*visit)(void*, const Batch&),
                         void* context) const {
  if (k < 1 || k > 256) fail(Status::kInvalidArgument, "k is %u; 1 ... 256 are possible", k);
  const KnnBatchKernels kernels =
      use_avx2() ? KnnBatchKernels{gather_candidates_avx2, knn_group_avx2}
                 : KnnBatchKernels{gather_candidates_baseline, knn_group_baseline};
  constexpr size_t kLeavesAtOnce = 128;
  parallel_for(task, impl_->leaves, kLeavesAtOnce, [&](size_t begin, size_t end) {
    const size_t first = impl_->leaf_first[begin], count = impl_->leaf_first[end] - first;
    const auto search = std::make_unique<BatchSearch>(*this, k, kernels);
    Buffer<uint32_t> neighbours(count * k);
    Buffer<float> squared(count * k);
    for (size_t leaf = begin; leaf < end; ++leaf) {
      if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      const size_t at = (impl_->leaf_first[leaf] - first) * k;
      search->leaf(leaf, neighbours.data() + at, squared.data() + at);
    }
    visit(context, {first, count, neighbours.data(), squared.data(), k});
  });
}

}  // namespace jalon
