// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/hough/peaks.h"

#include <algorithm>
#include <cmath>

#include "segment/hough/accumulator.h"

namespace jalon {

namespace {

constexpr int kMostRounds = 8;
constexpr double kNormalReach_rad = 0.175;  // 10 degrees: what noise turns the normal of a cell by
constexpr double kLeastVotes = 6;           // twice what any plane has
constexpr double kTolerancesPerRho = 2;     // of distance_step_m = 0: a plane's whole thickness
constexpr size_t kVotersPerLook = 64;       // each may have voted for all directions
constexpr double kPoolBelow = 0.5;          // share of free points at which the pool is made anew

class Hough {
 public:
  Hough(RansacScene& scene, const HoughSettings& settings, Task& task)
      : scene_(scene), settings_(settings), task_(task), pool_(scene, task) {
    const double half = scene.tree->cube().edge / 2;
    middle_ = {half, half, half};
  }

  std::vector<Surface> run() {
    for (int round = 0; round < kMostRounds; ++round) {
      ProgressSpan span(task_, static_cast<double>(round) / kMostRounds,
                        static_cast<double>(round + 1) / kMostRounds);
      const size_t before = surfaces_.size();
      if (pool_.free_points() < least_points()) break;
      run_round();
      if (surfaces_.size() == before) break;
      renew_pool();
    }
    return std::move(surfaces_);
  }

 private:
  using Voter = HoughAccumulator::Voter;

  size_t least_points() const { return std::max<size_t>(3, settings_.surface.min_points); }

  // Free points evenly along the curve, those without a normal only where all vote for all directions.
  void choose_voters() {
    voters_.clear();
    positions_.clear();
    size_t able = 0;
    const bool by_normals = settings_.votes == HoughVotes::kNormals;
    const auto may = [&](size_t i) {
      return scene_.owner[i] == 0 && (!by_normals || !std::isnan(scene_.normals[3 * i]));
    };
    for (size_t i = 0; i < scene_.size(); ++i) able += may(i);
    const size_t step = std::max<size_t>(1, (able + settings_.voters - 1) / settings_.voters);
    size_t turn = 0;
    for (size_t i = 0; i < scene_.size(); ++i) {
      if (!may(i) || turn++ % step != 0) continue;
      const float* m = &scene_.normals[3 * i];
      Voter voter{scene_.local(i) - middle_, {}};
      if (by_normals)
        voter.normal = {static_cast<double>(m[0]), static_cast<double>(m[1]),
                        static_cast<double>(m[2])};
      voters_.push_back(voter);
      positions_.push_back(static_cast<uint32_t>(i));
    }
    step_ = static_cast<double>(step);
  }

  void run_round() {
    choose_voters();
    const double rho = settings_.distance_step_m > 0
                           ? settings_.distance_step_m
                           : kTolerancesPerRho * settings_.surface.distance_tolerance_m;
    HoughAccumulator votes(settings_.angle_step_rad, rho, norm(middle_));
    votes.vote(voters_, kNormalReach_rad, task_);
    const double least = std::max(kLeastVotes, static_cast<double>(least_points()) / step_ / 4);
    const auto all = static_cast<double>(std::max<size_t>(1, voters_.size()));
    while (!voters_.empty()) {
      task_.checkpoint(1 - static_cast<double>(voters_.size()) / all);
      const HoughAccumulator::Peak peak = votes.peak();
      if (peak.votes < least) break;
      take_peak(votes, peak);
    }
  }

  // A plane, or no more votes from those that would lead to it again.
  void take_peak(HoughAccumulator& votes, const HoughAccumulator::Peak& peak) {
    std::vector<uint8_t> for_it(voters_.size(), 0);
    Moments moments;
    moments.reference = middle_;
    size_t seed = voters_.size();
    for (size_t i = 0; i < voters_.size(); ++i) {
      if (!votes.voted(voters_[i], peak, kNormalReach_rad)) continue;
      for_it[i] = 1;
      moments.add(voters_[i].point + middle_);
      if (seed == voters_.size()) seed = i;
    }
    const size_t middle = middle_voter(for_it, moments);
    if (middle < voters_.size()) seed = middle;
    const Vec3& n = votes.direction(peak.direction);
    Candidate candidate;
    candidate.plane = {n, votes.rho_m(peak.rho) + dot(n, middle_)};
    PlaneFit fit;
    if (fit_plane(moments, fit) && fit.sigma <= votes.rho_step_m()) candidate.plane = fit.plane;
    candidate.seed = positions_[seed];
    Surface surface;
    const auto id = static_cast<uint32_t>(surfaces_.size() + 1);
    const bool found = extract_surface(scene_, pool_, {}, candidate, id, task_, surface);
    if (found) surfaces_.push_back(std::move(surface));
    size_t kept = 0;
    for (size_t i = 0; i < voters_.size(); ++i) {
      const bool gone = found ? scene_.owner[positions_[i]] != 0 || i == seed : for_it[i] != 0;
      if (i % kVotersPerLook == 0) task_.checkpoint(0);
      if (gone) {
        votes.take_back(voters_[i], kNormalReach_rad);
        continue;
      }
      voters_[kept] = voters_[i];
      positions_[kept++] = positions_[i];
    }
    voters_.resize(kept);
    positions_.resize(kept);
    if (static_cast<double>(pool_.free_points()) <
        kPoolBelow * static_cast<double>(pool_.built_points()))
      renew_pool();
  }

  // The voter of the middle rank along the widest spread: a plane is followed from the thick of its votes.
  size_t middle_voter(const std::vector<uint8_t>& for_it, const Moments& moments) const {
    PlaneFit fit;
    if (!fit_plane(moments, fit)) return voters_.size();
    std::vector<std::pair<double, size_t>> along;
    for (size_t i = 0; i < voters_.size(); ++i)
      if (for_it[i] != 0) along.push_back({dot(voters_[i].point, fit.axis_u), i});
    const auto middle = along.begin() + static_cast<ptrdiff_t>(along.size() / 2);
    std::nth_element(along.begin(), middle, along.end());
    return middle->second;
  }

  void renew_pool() {
    estimate_local_surface(scene_, task_);
    pool_ = PointPool();  // its memory first
    pool_ = PointPool(scene_, task_);
  }

  RansacScene& scene_;
  const HoughSettings& settings_;
  Task& task_;
  PointPool pool_;
  Vec3 middle_;
  std::vector<Voter> voters_;
  std::vector<uint32_t> positions_;  ///< of the voters
  double step_ = 1;                  ///< free points for one voter
  std::vector<Surface> surfaces_;
};

}  // namespace

std::vector<Surface> surfaces_of_peaks(RansacScene& scene, const HoughSettings& settings,
                                       Task& task) {
  return Hough(scene, settings, task).run();
}

}  // namespace jalon
