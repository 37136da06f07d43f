// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace jalon {

/// How the distances of a plane's points are distributed: its own points normally about 0, points of surfaces that meet
/// it from the front or from behind evenly from 0 to the tolerance, blurred by the same noise. All lie within the
/// tolerance.
struct Contamination {
  double sigma_m = 0;
  double tolerance_m = 0;
  double front = 0, behind = 0;  ///< shares of the points
  double core() const { return 1 - front - behind; }
};

/// 2 k phi(k) / (2 Phi(k) - 1), k = tolerance / sigma: what cutting a normal distribution at k takes from its variance.
double lost_by_truncation(double tolerance_m, double sigma_m);

/// The density f of a distance r, and ln f with its derivatives, at evenly spaced r, between them linearly: 12 to a
/// sigma. Distances beyond the tolerance count as at it.
class ContaminationTable {
 public:
  struct Weights {
    double core = 0, front = 0, behind = 0;  ///< probabilities that a point here is of each kind
    double slope = 0;                        ///< derivative of ln f by r
  };
  /// Derivatives of ln f by r, by ln sigma, by the shares front and behind.
  enum Derivative {
    kR,
    kS,
    kF,
    kB,
    kRR,
    kRS,
    kRF,
    kRB,
    kSS,
    kSF,
    kSB,
    kFF,
    kFB,
    kBB,
    kDerivatives
  };
  using Derivatives = std::array<double, kDerivatives>;

  /// What there is besides the weights, each with those before it: they take their time.
  enum class With { kWeightsAlone, kLogDensity, kDerivatives };
  explicit ContaminationTable(const Contamination& c, With with = With::kWeightsAlone);
  /// Of zones with the same noise and tolerance, which differ by their shares alone: what these mix is found once.
  static std::vector<ContaminationTable> of_zones(std::span<const Contamination> zones,
                                                  With with = With::kWeightsAlone);

  /// Two weights that follow one another in memory, and how far it is from the first to the second.
  struct Between {
    const Weights* first;
    double after;
  };
  /// Asked for each point in each step.
  Between between(double r) const {
    const auto [node, t] = place(r);
    return {&weights_[node], t};
  }
  Weights weights(double r) const {
    const auto [first, t] = between(r);
    const Weights &a = first[0], &b = first[1];
    return {a.core + t * (b.core - a.core), a.front + t * (b.front - a.front),
            a.behind + t * (b.behind - a.behind), a.slope + t * (b.slope - a.slope)};
  }
  /// ln f.
  double log_density(double r) const {
    const auto [node, t] = place(r);
    return log_densities_[node] + t * (log_densities_[node + 1] - log_densities_[node]);
  }
  Derivatives derivatives(double r) const;

 private:
  struct Place {
    size_t node;
    double after;  ///< share of the way to the next
  };
  Place place(double r) const {
    const double x = std::min(std::max(0.0, (r + tolerance_m_) * per_m_), intervals_);
    const int32_t node = std::min(static_cast<int32_t>(x), last_interval_);
    return {static_cast<size_t>(node), x - node};
  }
  /// Empty, with room for the nodes.
  ContaminationTable(double tolerance_m, double sigma_m);
  double tolerance_m_, per_m_, intervals_;
  int32_t last_interval_;  ///< signed and short: numbers that processors turn into doubles at once
  std::vector<Weights> weights_;
  std::vector<double> log_densities_;
  std::vector<Derivatives> derivatives_;
};

}  // namespace jalon
