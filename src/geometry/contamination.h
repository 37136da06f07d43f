// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
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
    double log_density = 0, slope = 0;       ///< ln f and its derivative by r
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

  /// The derivatives take as much time again: only on demand.
  explicit ContaminationTable(const Contamination& c, bool with_derivatives = false);
  /// Of zones with the same noise and tolerance, which differ by their shares alone: what these mix is found once.
  static std::vector<ContaminationTable> of_zones(std::span<const Contamination> zones,
                                                  bool with_derivatives = false);

  /// Asked for each point in each step.
  Weights weights(double r) const {
    const auto [node, t] = place(r);
    const Weights &a = weights_[node], &b = weights_[node + 1];
    return {a.core + t * (b.core - a.core), a.front + t * (b.front - a.front),
            a.behind + t * (b.behind - a.behind),
            a.log_density + t * (b.log_density - a.log_density), a.slope + t * (b.slope - a.slope)};
  }
  Derivatives derivatives(double r) const;

 private:
  struct Place {
    size_t node;
    double after;  ///< share of the way to the next
  };
  Place place(double r) const {
    const double last = static_cast<double>(weights_.size() - 1);
    const double x = std::clamp((r + tolerance_m_) * per_m_, 0.0, last);
    const size_t node = std::min(static_cast<size_t>(x), weights_.size() - 2);
    return {node, x - static_cast<double>(node)};
  }
  /// Empty, with room for the nodes.
  ContaminationTable(double tolerance_m, double sigma_m);
  double tolerance_m_, per_m_;
  std::vector<Weights> weights_;
  std::vector<Derivatives> derivatives_;
};

}  // namespace jalon
