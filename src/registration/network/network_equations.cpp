// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/network_equations.h"

#include <map>

namespace jalon {

namespace {

bool is_sight(ObservationKind kind) { return kind <= ObservationKind::kDistance; }
bool is_coordinate(ObservationKind kind) {
  return kind >= ObservationKind::kX && kind <= ObservationKind::kZ;
}

double measured(const SurveySight& sight, ObservationKind kind) {
  return kind == ObservationKind::kDirection ? sight.direction_rad
         : kind == ObservationKind::kZenith  ? sight.zenith_rad
                                             : sight.distance_m;
}

}  // namespace

NetworkProblem::NetworkProblem(const Survey& s, const NetworkSettings& chosen)
    : survey(s), settings(chosen), is_free(chosen.datum == NetworkDatum::kFree) {
  number_unknowns();
  list_sights();
  for (uint32_t p = 0; p < survey.points.size() && !is_free; ++p)
    for (int axis = 0; axis < 3; ++axis)
      if (survey.points[p].sigma_m[axis] > 0)
        list_single(static_cast<ObservationKind>(4 + axis), p, axis);
  for (uint32_t i = 0; i < survey.setups.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (unknowns.centrings[i][static_cast<size_t>(axis)] != kNoUnknown)
        list_single(axis < 2 ? ObservationKind::kCentring : ObservationKind::kHeight, i, axis);
}

void NetworkProblem::number_unknowns() {
  unknowns.points.assign(survey.points.size(), {kNoUnknown, kNoUnknown, kNoUnknown});
  unknowns.centrings.assign(survey.setups.size(), {kNoUnknown, kNoUnknown, kNoUnknown});
  unknowns.orientations.assign(survey.setups.size(), kNoUnknown);
  for (size_t p = 0; p < survey.points.size(); ++p)
    for (int axis = 0; axis < 3; ++axis)
      if (is_free || survey.points[p].sigma_m[axis] != 0)
        unknowns.points[p][static_cast<size_t>(axis)] = unknowns.count++;
  for (const SurveySight& sight : survey.sightings)
    if (std::isfinite(sight.direction_rad) && unknowns.orientations[sight.setup] == kNoUnknown)
      unknowns.orientations[sight.setup] = unknowns.count++;
  for (auto& centring : unknowns.centrings) {
    if (settings.sigma_centring_m > 0)
      centring[0] = unknowns.count, centring[1] = unknowns.count + 1, unknowns.count += 2;
    if (settings.sigma_height_m > 0) centring[2] = unknowns.count++;
  }
}

void NetworkProblem::list_single(ObservationKind kind, uint32_t subject, int axis) {
  groups.push_back({{static_cast<uint32_t>(observations.size())}});
  observations.push_back({kind, 0, subject, axis});
}

void NetworkProblem::list_sights() {
  std::map<std::pair<uint32_t, uint32_t>, size_t> known;  // setup and target: one standing
  for (uint32_t i = 0; i < survey.sightings.size(); ++i) {
    const SurveySight& sight = survey.sightings[i];
    for (const auto kind :
         {ObservationKind::kDirection, ObservationKind::kZenith, ObservationKind::kDistance}) {
      if (!std::isfinite(measured(sight, kind))) continue;
      const auto [at, is_new] = known.emplace(std::pair{sight.setup, sight.target}, groups.size());
      if (is_new) groups.emplace_back();
      groups[at->second].members.push_back(static_cast<uint32_t>(observations.size()));
      observations.push_back({kind, i, sight.setup, 0});
    }
  }
}

Vec3 NetworkProblem::place(uint32_t point, const Eigen::VectorXd& x) const {
  Vec3 out = survey.points[point].position;
  for (int axis = 0; axis < 3; ++axis)
    if (const int u = unknowns.points[point][static_cast<size_t>(axis)]; u != kNoUnknown)
      out[axis] += x[u];
  return out;
}

// Coordinates are unknown as their difference from the given or approximate ones. A circle's zero points where the
// first direction of its setup has it.
Eigen::VectorXd NetworkProblem::start() const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns.count);
  std::vector<uint8_t> is_set(survey.setups.size(), 0);
  for (const NetworkObservation& o : observations) {
    if (o.kind != ObservationKind::kDirection || is_set[o.subject]++ > 0) continue;
    x[unknowns.orientations[o.subject]] =
        within_half_turn(equation(o, x).value - survey.sightings[o.sighting].direction_rad);
  }
  return x;
}

SightEquation NetworkProblem::equation(const NetworkObservation& o,
                                       const Eigen::VectorXd& x) const {
  const SurveySight& sight = survey.sightings[o.sighting];
  Vec3 instrument = place(survey.setups[sight.setup].station, x);
  for (int axis = 0; axis < 3; ++axis)
    if (const int u = unknowns.centrings[sight.setup][static_cast<size_t>(axis)]; u != kNoUnknown)
      instrument[axis] += x[u];
  instrument.z += sight.instrument_height_m;
  const Vec3 target = place(sight.target, x) + Vec3{0, 0, sight.target_height_m};
  return sight_equation(static_cast<SightKind>(o.kind), instrument, target, settings);
}

double NetworkProblem::residual(const NetworkObservation& o, const Eigen::VectorXd& x,
                                SparseRow& row) const {
  row.count = 0;
  if (!is_sight(o.kind)) {
    const auto axis = static_cast<size_t>(o.axis);
    const int unknown = is_coordinate(o.kind) ? unknowns.points[o.subject][axis]
                                              : unknowns.centrings[o.subject][axis];
    row.add(unknown, 1);
    return -x[unknown];  // a weak coordinate is observed as it was given, a centring as 0
  }
  const SurveySight& sight = survey.sightings[o.sighting];
  const SightEquation made = equation(o, x);
  const uint32_t station = survey.setups[sight.setup].station;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<size_t>(axis);
    row.add(unknowns.points[sight.target][a], made.by_target[axis]);
    row.add(unknowns.points[station][a], -made.by_target[axis]);
    row.add(unknowns.centrings[sight.setup][a], -made.by_target[axis]);
  }
  if (o.kind != ObservationKind::kDirection) return measured(sight, o.kind) - made.value;
  const int orientation = unknowns.orientations[sight.setup];
  row.add(orientation, -1);
  return within_half_turn(sight.direction_rad - made.value + x[orientation]);
}

double NetworkProblem::own_sigma(const NetworkObservation& o) const {
  const SurveySight& sight = survey.sightings[o.sighting];
  const auto or_else = [](double own, double other) { return std::isfinite(own) ? own : other; };
  switch (o.kind) {
    case ObservationKind::kDirection:
      return or_else(sight.sigma_direction_rad, settings.sigma_direction_rad);
    case ObservationKind::kZenith:
      return or_else(sight.sigma_zenith_rad, settings.sigma_zenith_rad);
    case ObservationKind::kDistance:
      return or_else(
          sight.sigma_distance_m,
          settings.sigma_distance_m + 1e-6 * settings.sigma_distance_ppm * sight.distance_m);
    case ObservationKind::kCentring:
      return settings.sigma_centring_m;
    case ObservationKind::kHeight:
      return settings.sigma_height_m;
    default:
      return survey.points[o.subject].sigma_m[o.axis];
  }
}

// C = D + J S J^T: each observation's own variance, and what the target's standing does to all of them.
Eigen::MatrixXd NetworkProblem::covariance(const ObservationGroup& group,
                                           const Eigen::VectorXd& x) const {
  const auto n = static_cast<Eigen::Index>(group.members.size());
  Eigen::MatrixXd made = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixX3d by_standing = Eigen::MatrixX3d::Zero(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const NetworkObservation& o = observations[group.members[static_cast<size_t>(i)]];
    made(i, i) = own_sigma(o) * own_sigma(o);
    if (!is_sight(o.kind)) continue;
    const Vec3 by = equation(o, x).by_target;
    by_standing.row(i) << by.x * settings.sigma_target_centring_m,
        by.y * settings.sigma_target_centring_m, by.z * settings.sigma_target_height_m;
  }
  return made + by_standing.lazyProduct(by_standing.transpose());
}

}  // namespace jalon
