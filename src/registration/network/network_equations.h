// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>

#include "registration/network/sight_equations.h"

namespace jalon {

/// What an observation is of; the first three are SightKind.
enum class ObservationKind : uint8_t {
  kDirection = 1,
  kZenith = 2,
  kDistance = 3,
  kX = 4,  ///< coordinates of weak points
  kY = 5,
  kZ = 6,
  kCentring = 7,  ///< of an instrument: expected 0, in x and y
  kHeight = 8     ///< of an instrument: error of its height, expected 0
};

struct NetworkObservation {
  ObservationKind kind{};
  uint32_t sighting = 0;  ///< of directions, zenith angles and distances
  uint32_t subject = 0;   ///< point of coordinates, setup of centrings
  int axis = 0;           ///< of coordinates and centrings
  bool is_used = true;
};

/// Observations whose errors have to do with each other: the sights of one setup to one target, which stands once. All
/// others stand alone.
struct ObservationGroup {
  std::vector<uint32_t> members;
};

constexpr int kNoUnknown = -1;

/// The unknowns: coordinates that are not fixed, an orientation a setup with directions, what an instrument stands off
/// its point by.
struct NetworkUnknowns {
  std::vector<std::array<int, 3>> points, centrings;  ///< by point and by setup; kNoUnknown: fixed
  std::vector<int> orientations;
  int count = 0;
};

/// A row of the design matrix: at most three coordinates of either end, three of the centring, one orientation.
struct SparseRow {
  std::array<std::pair<int, double>, 10> entries;
  size_t count = 0;
  void add(int unknown, double value) {
    if (unknown != kNoUnknown) entries[count++] = {unknown, value};
  }
  Eigen::VectorXd dense(Eigen::Index unknowns) const {
    Eigen::VectorXd made = Eigen::VectorXd::Zero(unknowns);
    for (size_t k = 0; k < count; ++k) made[entries[k].first] += entries[k].second;
    return made;
  }
  double times(const Eigen::VectorXd& x) const {
    double sum = 0;
    for (size_t k = 0; k < count; ++k) sum += entries[k].second * x[entries[k].first];
    return sum;
  }
};

struct NetworkProblem {
  NetworkProblem(const Survey& survey, const NetworkSettings& settings);

  /// Observed less computed at the values x of the unknowns, and how x changes it.
  double residual(const NetworkObservation& o, const Eigen::VectorXd& x, SparseRow& row) const;
  /// The covariance of a group's observations: instrument and target's standing together.
  Eigen::MatrixXd covariance(const ObservationGroup& group, const Eigen::VectorXd& x) const;
  Eigen::VectorXd start() const;
  Vec3 place(uint32_t point, const Eigen::VectorXd& x) const;

  const Survey& survey;
  const NetworkSettings& settings;
  NetworkUnknowns unknowns;
  std::vector<NetworkObservation> observations;
  std::vector<ObservationGroup> groups;
  bool is_free = false;

 private:
  void number_unknowns();
  void list_sights();
  void list_single(ObservationKind kind, uint32_t subject, int axis);
  SightEquation equation(const NetworkObservation& o, const Eigen::VectorXd& x) const;
  double own_sigma(const NetworkObservation& o) const;
};

}  // namespace jalon
