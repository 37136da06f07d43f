// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Cells of planes by direction and distance: half a sphere of directions (theta from the zenith, phi about it, in
/// rows of as many cells as the circle has room for) times steps of rho, the distance from the middle.
class HoughAccumulator {
 public:
  /// Distances reach to half_m; the step grows where there would be more than some million cells.
  HoughAccumulator(double angle_step_rad, double rho_step_m, double half_m);
  /// The greatest half_m that leaves the step as it is.
  static double longest_half_m(double angle_step_rad, double rho_step_m);

  struct Voter {
    Vec3 point;   ///< from the middle
    Vec3 normal;  ///< zero: votes for all directions
  };
  struct Peak {
    uint32_t votes = 0, direction = 0, rho = 0;
  };

  /// Adds, or takes back, the votes of all of them: one a direction within reach_rad of the normal, at its rho. The
  /// same counts for any number of threads.
  void vote(std::span<const Voter> voters, double reach_rad, Task& task);
  void take_back(const Voter& voter, double reach_rad);
  /// The cell of most votes, ties to the first.
  Peak peak();
  /// True when the voter has voted for the cell.
  bool voted(const Voter& voter, const Peak& peak, double reach_rad) const;

  size_t directions() const { return directions_.size(); }
  const Vec3& direction(size_t i) const { return directions_[i]; }
  double rho_step_m() const { return rho_step_m_; }
  double rho_m(uint32_t rho) const { return (rho + 0.5) * rho_step_m_ - half_m_; }

 private:
  uint32_t rho_of(const Vec3& point, size_t direction) const;

  std::vector<Vec3> directions_;
  double rho_step_m_, half_m_;
  uint32_t rhos_;
  std::vector<uint32_t> votes_;  ///< direction by direction
  std::vector<Peak> best_;       ///< of each direction
  std::vector<uint8_t> stale_;   ///< directions whose best is to be looked up anew
};

}  // namespace jalon
