// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/knn_group_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/simd.h"
#include "spatial/neighbours/nearest_by_grid.h"

namespace jalon {

namespace {

constexpr double kSqrt3OfStep = 1.7320508075688773;
constexpr int64_t kWholeCube = int64_t{1} << 31;
// The reach guessed for a group: what the group before needed, and a fifth more for less dense ones: repeating costs
// more than a few candidates too many.
constexpr double kReachGuess = 1.2;
// A group that needs this much more than was guessed holds outliers: those are answered one by one.
constexpr double kFarOff = 2.5;

// Settling sorts what is close; of more than so many times k, the boxes in doubles find the k nearest sooner.
constexpr size_t kMostClose = 8;

}  // namespace

KnnGroupSearch::KnnGroupSearch(const Octree& octree, uint32_t k)
    : tree_(octree.impl()),
      k_(k),
      gather_(use_avx2() ? gather_candidates_avx2 : gather_candidates_baseline),
      search_(use_avx2() ? knn_group_avx2 : knn_group_baseline),
      exactly_(tree_, k),
      keys_((k + 1) * size_t{kMostQueries}) {}

void KnnGroupSearch::leaf(size_t leaf, uint32_t* neighbours, float* squared) {
  const size_t first = tree_.leaf_first[leaf], count = tree_.leaf_first[leaf + 1] - first;
  for (uint32_t q = 0; q < count; ++q) positions_[q] = static_cast<uint32_t>(first + q);
  load_queries(count);
  if (same_point(first, count)) {
    for (size_t q = 0; q < count; ++q)
      for (uint32_t j = 0; j < k_; ++j) {
        neighbours[q * k_ + j] = static_cast<uint32_t>(run_begin_) + j;
        squared[q * k_ + j] = 0;
      }
    return;
  }
  if (tree_.has_exact_boxes() && tree_.is_crowded(leaf, 0)) {
    exactly_.leaf(leaf, neighbours);
    for (size_t q = 0; q < count; ++q) measure(first + q, neighbours + q * k_, squared + q * k_);
    return;
  }
  one_by_one(answer(neighbours, squared), neighbours, squared);
}

void KnnGroupSearch::group(std::span<const uint32_t> positions, uint32_t* neighbours,
                           float* squared) {
  std::copy(positions.begin(), positions.end(), positions_);
  load_queries(positions.size());
  if (tree_.has_exact_boxes()) return one_by_one(all_queries(), neighbours, squared);
  const uint32_t pending = answer(neighbours, squared);
  if (pending == 0) return;
  if (positions.size() == 1) return one_by_one(pending, neighbours, squared);
  // The curve leaps between them, or the guess was for sparser points.
  const size_t half = positions.size() / 2;
  reach_ = 0;
  group(positions.first(half), neighbours, squared);
  group(positions.subspan(half), neighbours + half * k_, squared + half * k_);
}

// Steps 1 to 4 of the loaded queries; those without an answer stay.
uint32_t KnnGroupSearch::answer(uint32_t* neighbours, float* squared) {
  uint32_t pending = all_queries();
  if (reach_ == 0) reach_ = first_reach();
  for (int attempt = 0; pending != 0; ++attempt) {
    const int64_t needed = try_reach(pending);
    if (needed == 0) return pending;
    write(pending & ~group_.incomplete, neighbours, squared);
    pending &= group_.incomplete;
    if (pending == 0) break;
    const bool far_off = static_cast<double>(needed) > kFarOff * static_cast<double>(reach_);
    if ((attempt != 0 && far_off) || attempt == 8 || group_.count <= 2) return pending;
    reach_ = needed;
  }
  reach_ = std::max<int64_t>(4, static_cast<int64_t>(kReachGuess * largest_));
  return 0;
}

void KnnGroupSearch::load_queries(size_t count) {
  group_.count = static_cast<uint32_t>(count);
  group_.k = k_;
  group_.keys = keys_.data();
  int32_t* axes[3] = {group_.x, group_.y, group_.z};
  const int32_t* from[3] = {tree_.x.data(), tree_.y.data(), tree_.z.data()};
  for (int axis = 0; axis < 3; ++axis) {
    int32_t lo = from[axis][positions_[0]], hi = lo;
    for (size_t i = 0; i < count; ++i) {
      const int32_t at = axes[axis][i] = from[axis][positions_[i]];
      lo = std::min(lo, at);
      hi = std::max(hi, at);
    }
    for (size_t i = count; i < kMostQueries; ++i) axes[axis][i] = axes[axis][count - 1];
    box_.lo[axis] = lo;
    box_.hi[axis] = hi;
  }
}

// True when the leaf lies in a run of k and more points with the same coordinates: they stand by index, so the first
// k are the neighbours of all. Without this, many duplicates would cost the square of their number.
bool KnnGroupSearch::same_point(size_t first, size_t count) {
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

int64_t KnnGroupSearch::first_reach() const {
  int64_t side = 16;
  for (int axis = 0; axis < 3; ++axis)
    side = std::max<int64_t>(side, box_.hi[axis] - box_.lo[axis]);
  return side;
}

// Steps 1 and 2. The reach that the incomplete queries need; 0 when there are too many candidates.
int64_t KnnGroupSearch::try_reach(uint32_t pending) {
  GridBox wide;
  for (int axis = 0; axis < 3; ++axis) {
    wide.lo[axis] = static_cast<int32_t>(std::max<int64_t>(0, box_.lo[axis] - reach_));
    wide.hi[axis] = static_cast<int32_t>(std::min<int64_t>(kWholeCube - 1, box_.hi[axis] + reach_));
  }
  if (!gather_(tree_.view, wide, candidates_)) return 0;
  if (candidates_.count < k_ && candidates_.count < tree_.count) {
    group_.incomplete = pending;
    return 2 * reach_;
  }
  set_tolerances();
  search_(candidates_, group_);
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
      std::min(needed * (1 + 4 * kCoarsest) + 8, static_cast<double>(kWholeCube)));
}

double KnnGroupSearch::truncation() const {
  return std::ldexp(1.0, static_cast<int>(group_.index_bits) - 23) + 0x1p-20;
}

float KnnGroupSearch::squared_of(uint32_t key) const {
  return std::bit_cast<float>(key & ~((1u << group_.index_bits) - 1));
}

void KnnGroupSearch::set_tolerances() {
  group_.index_bits = std::max(1u, static_cast<uint32_t>(std::bit_width(candidates_.count - 1)));
  // A point outside the box is farther than reach_; a distance on the grid is sqrt(3) wrong at most.
  const double sure = std::max(0.0, static_cast<double>(reach_) - kSqrt3OfStep - 0.01);
  group_.covered = static_cast<float>(sure * sure * (1 - 2 * truncation()));
  group_.tie_slope = static_cast<float>(1.01 * truncation());
  // |d_j - d_i| <= 2 sqrt(3) means |d_j^2 - d_i^2| <= 2 sqrt(3) (2 d_k + 2 sqrt(3)).
  group_.tie_root = tree_.on_grid ? 0.0f : 7.0f;
  group_.tie_floor = tree_.on_grid ? 0.0f : 13.0f;
}

// The float distance that is handed out: a function of the two grid points alone.
float KnnGroupSearch::squared_metres(size_t a, size_t b) const {
  const auto dx = static_cast<float>(tree_.x[a] - tree_.x[b]),
             dy = static_cast<float>(tree_.y[a] - tree_.y[b]),
             dz = static_cast<float>(tree_.z[a] - tree_.z[b]);
  return (dx * dx + dy * dy + dz * dz) * static_cast<float>(tree_.step * tree_.step);
}

void KnnGroupSearch::write(uint32_t done, uint32_t* neighbours, float* squared) {
  for (; done != 0; done &= done - 1) {
    const auto q = static_cast<uint32_t>(std::countr_zero(done));
    uint32_t* to = neighbours + q * size_t{k_};
    float* to_squared = squared + q * size_t{k_};
    if (group_.ambiguous >> q & 1) {
      settle(q, to, to_squared);
      continue;
    }
    const uint32_t mask = (1u << group_.index_bits) - 1;
    for (uint32_t j = 0; j < k_; ++j) {
      const uint32_t key = keys_[j * size_t{kMostQueries} + q];
      const uint32_t c = key & mask;
      to[j] = key == kNoKey ? kNoPoint : candidates_.position[c];
      to_squared[j] = key == kNoKey ? std::numeric_limits<float>::infinity()
                                    : squared_metres(positions_[q], to[j]);
    }
  }
}

// Step 4: the candidates that may be among the k nearest, in doubles; runs that the grid cannot order by the caller's
// coordinates.
void KnnGroupSearch::settle(uint32_t q, uint32_t* to, float* to_squared) {
  const size_t position = positions_[q];
  const double slack = tree_.on_grid ? 0 : 2 * kSqrt3OfStep + 1e-3;
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
  if (tree_.has_exact_boxes() && close_.size() > kMostClose * k_)
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

void KnnGroupSearch::answer_one(size_t position, uint32_t* to, float* to_squared) const {
  const int32_t query[3] = {tree_.x[position], tree_.y[position], tree_.z[position]};
  if (tree_.has_exact_boxes() || !nearest_by_grid(tree_, query, tree_.on_grid, k_, to))
    tree_.nearest_of_point(position, k_, to);
  measure(position, to, to_squared);
}

void KnnGroupSearch::measure(size_t position, const uint32_t* to, float* to_squared) const {
  for (uint32_t j = 0; j < k_; ++j)
    to_squared[j] = to[j] == kNoPoint ? std::numeric_limits<float>::infinity()
                                      : squared_metres(position, to[j]);
}

void KnnGroupSearch::one_by_one(uint32_t pending, uint32_t* neighbours, float* squared) {
  if (pending == 0) return;
  for (; pending != 0; pending &= pending - 1) {
    const auto q = static_cast<size_t>(std::countr_zero(pending));
    answer_one(positions_[q], neighbours + q * k_, squared + q * k_);
  }
  reach_ = 0;
}

}  // namespace jalon
