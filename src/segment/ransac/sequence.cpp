// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/sequence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "segment/ransac/curved_extraction.h"
#include "segment/ransac/curved_hypotheses.h"

namespace jalon {

namespace {

constexpr size_t kDrawsPerBatch = 256;
constexpr size_t kDrawsPerChunk = 8;
constexpr double kCompactBelow = 0.7;  // free share of the pool at which it is built anew
// A draw that starts on a plane succeeds with probability >= 1/4: the two partners must lie on it as well, each with
// about 1/2 (Schnabel et al. 2007, 4.3, with the level of the cell chosen by the point's surroundings instead of at
// random).
constexpr double kLocalSuccess = 0.25;
// Draws of curved surfaces for each draw of a plane: a draw that starts on one succeeds with probability >= 1/8 only,
// since it must also be of the right kind.
constexpr size_t kCurvedDraws = 2;
// Draws of any three points: fewer would trust a poor plane of three noisy points too early; more are not worth it.
constexpr double kLeastGlobalDraws = 300, kMostGlobalDraws = 1e5;

// Orientation classes come in the order asked for, and again while that finds planes: the narrow side of a post among
// points of the front and the windows is seen once those are taken.
constexpr int kMostRounds = 3;

// With criterion standard_deviation: planes with at least this share of the best one's points compete, at most so many.
constexpr double kNearlyAsMany = 0.9;
constexpr size_t kCompetitors = 8;

class Sequence {
 public:
  Sequence(RansacScene& scene, Task& task) : scene_(scene), task_(task), pool_(scene, task) {
    needed_ = -std::log(1 - scene.draw.probability);
  }

  std::vector<Surface> run() {
    const std::vector<OrientationPass> passes = orientation_passes(scene_, task_);
    for (int round = 0; round < kMostRounds; ++round) {
      const ProgressSpan span(task_, round / double{kMostRounds}, (round + 1) / double{kMostRounds},
                              nullptr);
      const size_t before = surfaces_.size();
      if (round > 0) renew_pool();
      run_passes(passes);
      if (passes.size() == 1 || surfaces_.size() == before) break;
    }
    task_.log(Task::kDebug, "ransac: %llu draws, %zu surfaces tried, %zu kept, %zu points left",
              static_cast<unsigned long long>(draws_), tried_, surfaces_.size(),
              pool_.free_points());
    return std::move(surfaces_);
  }

 private:
  void run_passes(const std::vector<OrientationPass>& passes) {
    const auto part = static_cast<double>(passes.size());
    for (size_t i = 0; i < passes.size(); ++i) {
      const ProgressSpan span(task_, static_cast<double>(i) / part,
                              static_cast<double>(i + 1) / part, nullptr);
      run_pass(passes[i]);
    }
  }

  void run_pass(const OrientationPass& pass) {
    pass_ = pass;
    scene_.forget_rejections();
    candidates_.clear();
    exposure_ = 0;
    fruitless_draws_ = 0;
    while (pool_.free_points() >= least_points() && !enough_planes()) {
      draw_batch();
      while (!enough_planes() && extract_best()) compact();
      if (sure_of(static_cast<double>(least_points()))) break;
      task_.checkpoint(progress());
    }
  }

  size_t least_points() const { return std::max<size_t>(3, scene_.settings.min_points); }
  bool enough_planes() const {
    return scene_.draw.max_planes != 0 && surfaces_.size() >= scene_.draw.max_planes;
  }
  // Expected number of good draws on a plane of that many points: each draw hits it with probability points / free x
  // kLocalSuccess.
  double hits(double points) const { return points * kLocalSuccess * exposure_; }
  // Nothing better than a plane of that many points is likely to turn up; with a fixed number of draws: they are done
  // (Boulaassal 2010, 3.4.3.2).
  bool sure_of(double points) const {
    const auto fruitless = static_cast<double>(fruitless_draws_);
    if (scene_.draw.draws != 0) return fruitless_draws_ >= scene_.draw.draws;
    if (scene_.draw.sampling == Sampling::kGlobal) return fruitless >= global_draws(points);
    return hits(points) >= needed_;
  }
  // N = log(1 - P) / log(1 - W^3) (Boulaassal 2010, 3.11), W the plane's share of the points that are left.
  double global_draws(double points) const {
    const double w = std::min(1.0, points / static_cast<double>(pool_.free_points()));
    return std::clamp(-needed_ / std::log1p(-w * w * w), kLeastGlobalDraws, kMostGlobalDraws);
  }
  double progress() const {
    const double taken =
        1 - static_cast<double>(pool_.free_points()) / static_cast<double>(scene_.size());
    return std::max(0.7 * taken,
                    std::min(1.0, hits(static_cast<double>(least_points())) / needed_));
  }

  void draw_batch() {
    const uint64_t left =
        scene_.draw.draws != 0 ? scene_.draw.draws - fruitless_draws_ : kDrawsPerBatch;
    const size_t draws = std::min<size_t>(kDrawsPerBatch, left);
    add_drawn(draws, [&](size_t i, Candidate& c) {
      return draw_candidate(scene_, pool_, pass_, draws_ + i, c);
    });
    if (scene_.settings.curved())
      add_drawn(kCurvedDraws * draws, [&](size_t i, Candidate& c) {
        return draw_curved(scene_, pool_, kCurvedDraws * draws_ + i, task_, c);
      });
    draws_ += draws;
    fruitless_draws_ += draws;
    exposure_ += static_cast<double>(draws) / static_cast<double>(pool_.free_points());
  }

  template <class Draw>
  void add_drawn(size_t draws, Draw&& draw) {
    std::vector<Candidate> drawn(draws);
    std::vector<uint8_t> good(draws, 0);
    parallel_for(task_, draws, kDrawsPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        if (!draw(i, drawn[i])) continue;
        score_roughly(scene_, pool_, drawn[i], task_);
        good[i] = drawn[i].upper >= static_cast<double>(least_points());
      }
    });
    for (size_t i = 0; i < draws; ++i) {
      if (!good[i]) continue;
      drawn[i].epoch = epoch_;
      candidates_.push_back(drawn[i]);
    }
  }

  bool may_seed(const Candidate& c) const {
    return c.curved.exists() ? scene_.may_seed_curved(c.seed) : scene_.may_seed(c.seed);
  }

  // Scores only fall as points are taken, so an old upper bound is still one.
  void refresh(Candidate& c) {
    c.found = c.pieces = 0;
    c.epoch = epoch_;
    score_roughly(scene_, pool_, c, task_);
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
        score_next_piece(scene_, pool_, c, task_);
      }
    }
  }

  // Of the candidates with nearly as many points as the best, the one whose plane has the least standard deviation
  // (Boulaassal 2010, 3.4.5.3; Tarsha-Kurdi et al. 2008).
  size_t least_spread(size_t best) {
    const double enough = kNearlyAsMany * candidates_[best].estimate;
    std::vector<size_t> competitors{best};
    for (size_t i = 0; i < candidates_.size() && competitors.size() < kCompetitors; ++i) {
      if (i == best || candidates_[i].curved.exists() || candidates_[i].upper < enough) continue;
      if (candidates_[i].epoch != epoch_) refresh(candidates_[i]);
      if (candidates_[i].estimate >= enough) competitors.push_back(i);
    }
    double least = INFINITY;
    for (const size_t i : competitors) {
      const double sigma = settled_sigma(scene_, pool_, candidates_[i], task_);
      if (sigma < least) {
        least = sigma;
        best = i;
      }
    }
    return best;
  }

  bool extract(const Candidate& candidate, uint32_t id, Surface& surface) {
    if (candidate.curved.exists())
      return extract_curved(scene_, pool_, candidate, id, task_, surface);
    return extract_surface(scene_, pool_, pass_, candidate, id, task_, surface);
  }

  bool extract_best() {
    std::erase_if(candidates_, [&](const Candidate& c) {
      return !may_seed(c) || c.upper < static_cast<double>(least_points());
    });
    while (!candidates_.empty()) {
      size_t best = best_candidate();
      if (candidates_[best].upper < static_cast<double>(least_points())) return false;
      if (!sure_of(candidates_[best].lower)) return false;
      if (scene_.draw.criterion == Criterion::kStandardDeviation &&
          !candidates_[best].curved.exists())
        best = least_spread(best);
      const Candidate candidate = candidates_[best];
      candidates_.erase(candidates_.begin() + static_cast<ptrdiff_t>(best));
      Surface surface;
      ++tried_;
      const auto id = static_cast<uint32_t>(surfaces_.size() + 1);
      if (!extract(candidate, id, surface)) continue;
      surfaces_.push_back(std::move(surface));
      ++epoch_;
      scene_.forget_rejections();
      fruitless_draws_ = 0;
      return true;
    }
    return false;
  }

  // The surroundings of the points that are left, without those that are taken.
  void renew_pool() {
    estimate_local_surface(scene_, task_);
    pool_ = PointPool();  // its memory first
    pool_ = PointPool(scene_, task_);
  }

  void compact() {
    const auto built = static_cast<double>(pool_.built_points());
    if (static_cast<double>(pool_.free_points()) >= kCompactBelow * built) return;
    renew_pool();
    for (Candidate& c : candidates_)
      c.epoch = epoch_ - 1;  // their pieces were those of the old pool
  }

  RansacScene& scene_;
  Task& task_;
  PointPool pool_;
  OrientationPass pass_;
  std::vector<Candidate> candidates_;
  std::vector<Surface> surfaces_;
  double needed_ = 0, exposure_ = 0;
  uint64_t draws_ = 0, fruitless_draws_ = 0;
  size_t tried_ = 0;
  uint32_t epoch_ = 1;
};

}  // namespace

std::vector<Surface> extract_sequence(RansacScene& scene, Task& task) {
  return Sequence(scene, task).run();
}

}  // namespace jalon
