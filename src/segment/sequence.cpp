// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/sequence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kDrawsPerBatch = 256;
constexpr size_t kDrawsPerChunk = 8;
constexpr double kCompactBelow = 0.7;   // free share of the pool at which it is built anew
// A draw that starts on a plane succeeds with probability >= 1/4: the two partners must lie on it as well, each with
// about 1/2 (Schnabel et al. 2007, 4.3, with the level of the cell chosen by the point's surroundings instead of at
// random).
constexpr double kLocalSuccess = 0.25;

class Sequence {
 public:
  Sequence(SegmentScene& scene, Task& task) : scene_(scene), task_(task), pool_(scene, task) {
    needed_ = -std::log(1 - scene.settings.probability);
  }

  std::vector<Surface> run() {
    while (pool_.free_points() >= least_points() && !enough_planes()) {
      draw_batch();
      while (!enough_planes() && extract_best()) compact();
      if (sure_of(least_points())) break;
      task_.checkpoint(progress());
    }
    task_.log(Task::kDebug, "ransac: %llu draws, %zu planes tried, %zu kept, %zu points left",
              static_cast<unsigned long long>(draws_), tried_, surfaces_.size(), pool_.free_points());
    return std::move(surfaces_);
  }

 private:
  size_t least_points() const { return std::max<size_t>(3, scene_.settings.min_points); }
  bool enough_planes() const {
    return scene_.settings.max_planes != 0 && surfaces_.size() >= scene_.settings.max_planes;
  }
  // Expected number of good draws on a plane of that many points: each draw hits it with probability points / free x
  // kLocalSuccess.
  double hits(double points) const { return points * kLocalSuccess * exposure_; }
  bool sure_of(size_t points) const { return hits(static_cast<double>(points)) >= needed_; }
  double progress() const {
    const double taken = 1 - static_cast<double>(pool_.free_points()) / static_cast<double>(scene_.size());
    return std::max(0.7 * taken, std::min(1.0, hits(static_cast<double>(least_points())) / needed_));
  }

  void draw_batch() {
    std::vector<Candidate> drawn(kDrawsPerBatch);
    std::vector<uint8_t> good(kDrawsPerBatch, 0);
    parallel_for(task_, kDrawsPerBatch, kDrawsPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        if (!draw_candidate(scene_, pool_, draws_ + i, drawn[i])) continue;
        score_roughly(scene_, pool_, drawn[i]);
        good[i] = drawn[i].upper >= static_cast<double>(least_points());
      }
    });
    for (size_t i = 0; i < kDrawsPerBatch; ++i) {
      if (!good[i]) continue;
      drawn[i].epoch = epoch_;
      candidates_.push_back(drawn[i]);
    }
    draws_ += kDrawsPerBatch;
    exposure_ += static_cast<double>(kDrawsPerBatch) / static_cast<double>(pool_.free_points());
  }

  // Scores only fall as points are taken, so an old upper bound is still one.
  void refresh(Candidate& c) {
    c.found = c.pieces = 0;
    c.epoch = epoch_;
    score_roughly(scene_, pool_, c);
  }

  // The candidate of the highest score: bounds are narrowed only while the intervals of the best ones overlap.
  size_t best_candidate() {
    for (;;) {
      size_t best = 0;
      double best_upper = -1, second_upper = -1;
      for (size_t i = 0; i < candidates_.size(); ++i) {
        const double upper = candidates_[i].upper;
        if (upper > best_upper) {
          second_upper = best_upper;
          best = i;
          best_upper = upper;
        } else {
          second_upper = std::max(second_upper, upper);
        }
      }
      Candidate& c = candidates_[best];
      if (c.epoch != epoch_) {
        refresh(c);
      } else if (c.pieces == PointPool::kPieces || c.lower >= second_upper) {
        return best;
      } else {
        score_next_piece(scene_, pool_, c);
      }
    }
  }

  bool extract_best() {
    std::erase_if(candidates_, [&](const Candidate& c) {
      return scene_.owner[c.seed] != 0 || c.upper < static_cast<double>(least_points());
    });
    while (!candidates_.empty()) {
      const size_t best = best_candidate();
      const Candidate candidate = candidates_[best];
      if (candidate.upper < static_cast<double>(least_points())) return false;
      if (hits(candidate.lower) < needed_) return false;
      candidates_.erase(candidates_.begin() + static_cast<ptrdiff_t>(best));
      Surface surface;
      ++tried_;
      const auto id = static_cast<uint32_t>(surfaces_.size() + 1);
      if (!extract_surface(scene_, pool_, candidate, id, task_, surface)) continue;
      surfaces_.push_back(std::move(surface));
      ++epoch_;
      return true;
    }
    return false;
  }

  void compact() {
    const auto built = static_cast<double>(pool_.built_points());
    if (static_cast<double>(pool_.free_points()) >= kCompactBelow * built) return;
    estimate_local_surface(scene_, task_);
    pool_ = PointPool(scene_, task_);
    for (Candidate& c : candidates_) c.epoch = epoch_ - 1;  // their pieces were those of the old pool
  }

  SegmentScene& scene_;
  Task& task_;
  PointPool pool_;
  std::vector<Candidate> candidates_;
  std::vector<Surface> surfaces_;
  double needed_ = 0, exposure_ = 0;
  uint64_t draws_ = 0;
  size_t tried_ = 0;
  uint32_t epoch_ = 1;
};

}  // namespace

std::vector<Surface> extract_sequence(SegmentScene& scene, Task& task) { return Sequence(scene, task).run(); }

}  // namespace jalon
