// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/hough/peaks.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "segment/hough/accumulator.h"
#include "segment/surface/near_most.h"

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
      : scene_(scene),
        settings_(settings),
        task_(task),
        pool_(scene, task),
        rho_step_m_(settings.distance_step_m > 0
                        ? settings.distance_step_m
                        : kTolerancesPerRho * settings.surface.distance_tolerance_m) {}

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
  std::vector<uint32_t> chosen_voters() {
    std::vector<uint32_t> chosen;
    size_t able = 0;
    const bool by_normals = settings_.votes == HoughVotes::kNormals;
    const auto may = [&](size_t i) {
      return scene_.owner[i] == 0 && (!by_normals || !std::isnan(scene_.normals[3 * i]));
    };
    for (size_t i = 0; i < scene_.size(); ++i) able += may(i);
    const size_t step = std::max<size_t>(1, (able + settings_.voters - 1) / settings_.voters);
    size_t turn = 0;
    for (size_t i = 0; i < scene_.size(); ++i)
      if (may(i) && turn++ % step == 0) chosen.push_back(static_cast<uint32_t>(i));
    step_ = static_cast<double>(step);
    return chosen;
  }

  // The middle that distances are from, and how far they reach: of the octree's cube, unless steps of the distance
  // would be wider for it. Then of what lies near most of those that are to vote; gives back the others.
  std::vector<uint32_t> choose_middle(const std::vector<uint32_t>& chosen) {
    const double half = scene_.tree->cube().edge / 2;
    middle_ = {half, half, half};
    half_m_ = norm(middle_);
    if (half_m_ <= HoughAccumulator::longest_half_m(settings_.angle_step_rad, rho_step_m_))
      return {};
    std::vector<Vec3> points;
    for (const uint32_t position : chosen) points.push_back(scene_.local(position));
    const Box3 near_most = box_near_most(points);
    std::vector<uint32_t> far;
    Box3 box;
    for (size_t i = 0; i < chosen.size(); ++i)
      if (near_most.contains(points[i])) box.add(points[i]);
      else far.push_back(chosen[i]);
    middle_ = 0.5 * (box.min + box.max);
    half_m_ = 0.5 * norm(box.max - box.min);
    return far;
  }

  void be_voters(const std::vector<uint32_t>& chosen, const std::vector<uint32_t>& far) {
    positions_.clear();
    std::ranges::set_difference(chosen, far, std::back_inserter(positions_));
    voters_.clear();
    for (const uint32_t position : positions_) {
      const float* m = &scene_.normals[3 * size_t{position}];
      Voter voter{scene_.local(position) - middle_, {}};
      if (settings_.votes == HoughVotes::kNormals)
        voter.normal = {static_cast<double>(m[0]), static_cast<double>(m[1]),
                        static_cast<double>(m[2])};
      voters_.push_back(voter);
    }
  }

  // Those near most of them vote first, then those of what lies far off: a stray point widens no step for all.
  void run_round() {
    std::vector<uint32_t> chosen = chosen_voters();
    for (double begin = 0; !chosen.empty(); begin = (1 + begin) / 2) {
      std::vector<uint32_t> far = choose_middle(chosen);
      ProgressSpan span(task_, begin, far.empty() ? 1 : (1 + begin) / 2);
      be_voters(chosen, far);
      take_peaks();
      chosen = std::move(far);
    }
  }

  void take_peaks() {
    HoughAccumulator votes(settings_.angle_step_rad, rho_step_m_, half_m_);
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
  double rho_step_m_;
  Vec3 middle_;  ///< that distances of planes are from
  double half_m_ = 0;
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
