// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/hough/accumulator.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr double kMostCells = 1 << 23;  // 32 MiB
constexpr size_t kVotersPerChunk = 256;

std::vector<Vec3> half_a_sphere(double angle_step_rad) {
  const double quarter = std::numbers::pi / 2;
  const auto rows = static_cast<uint32_t>(std::max(1.0, std::round(quarter / angle_step_rad)));
  std::vector<Vec3> directions{{0, 0, 1}};
  for (uint32_t row = 1; row <= rows; ++row) {
    const double theta = quarter * row / rows;
    // On the horizon a direction and its opposite are one plane's: half a circle.
    const double circle = row == rows ? std::numbers::pi : 2 * std::numbers::pi;
    const auto cells =
        static_cast<uint32_t>(std::max(1.0, std::round(circle * std::sin(theta) / angle_step_rad)));
    for (uint32_t c = 0; c < cells; ++c) {
      const double phi = circle * c / cells;
      directions.push_back({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                            row == rows ? 0 : std::cos(theta)});
    }
  }
  return directions;
}

}  // namespace

HoughAccumulator::HoughAccumulator(double angle_step_rad, double rho_step_m, double half_m)
    : directions_(half_a_sphere(angle_step_rad)), rho_step_m_(rho_step_m), half_m_(half_m) {
  const double most = kMostCells / static_cast<double>(directions_.size());
  rho_step_m_ = std::max(rho_step_m_, 2 * half_m_ / most);
  rhos_ = static_cast<uint32_t>(std::ceil(2 * half_m_ / rho_step_m_)) + 1;
  votes_.assign(directions_.size() * rhos_, 0);
  best_.resize(directions_.size());
  stale_.assign(directions_.size(), 1);
}

double HoughAccumulator::longest_half_m(double angle_step_rad, double rho_step_m) {
  const auto directions = static_cast<double>(half_a_sphere(angle_step_rad).size());
  return rho_step_m * (kMostCells / directions) / 2;
}

uint32_t HoughAccumulator::rho_of(const Vec3& point, size_t direction) const {
  const double at = (dot(point, directions_[direction]) + half_m_) / rho_step_m_;
  return at > 0 ? std::min(static_cast<uint32_t>(at), rhos_ - 1) : 0;
}

void HoughAccumulator::vote(std::span<const Voter> voters, double reach_rad, Task& task) {
  const double cosine = std::cos(reach_rad);
  parallel_for(task, voters.size(), kVotersPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const bool all = squared_norm(voters[i].normal) == 0;
      for (size_t d = 0; d < directions_.size(); ++d) {
        if (!all && std::fabs(dot(voters[i].normal, directions_[d])) < cosine) continue;
        std::atomic_ref<uint32_t>(votes_[d * rhos_ + rho_of(voters[i].point, d)])
            .fetch_add(1, std::memory_order_relaxed);
      }
    }
  });
  std::fill(stale_.begin(), stale_.end(), uint8_t{1});
}

void HoughAccumulator::take_back(const Voter& voter, double reach_rad) {
  const double cosine = std::cos(reach_rad);
  const bool all = squared_norm(voter.normal) == 0;
  for (size_t d = 0; d < directions_.size(); ++d) {
    if (!all && std::fabs(dot(voter.normal, directions_[d])) < cosine) continue;
    --votes_[d * rhos_ + rho_of(voter.point, d)];
    stale_[d] = 1;
  }
}

HoughAccumulator::Peak HoughAccumulator::peak() {
  Peak best;
  for (uint32_t d = 0; d < directions_.size(); ++d) {
    if (stale_[d] != 0) {
      const auto first = votes_.begin() + static_cast<ptrdiff_t>(size_t{d} * rhos_);
      const auto most = std::max_element(first, first + rhos_);
      best_[d] = {*most, d, static_cast<uint32_t>(most - first)};
      stale_[d] = 0;
    }
    if (best_[d].votes > best.votes) best = best_[d];
  }
  return best;
}

bool HoughAccumulator::voted(const Voter& voter, const Peak& peak, double reach_rad) const {
  if (rho_of(voter.point, peak.direction) != peak.rho) return false;
  return squared_norm(voter.normal) == 0 ||
         std::fabs(dot(voter.normal, directions_[peak.direction])) >= std::cos(reach_rad);
}

}  // namespace jalon
