// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/network_tables.h"

#include <algorithm>
#include <cmath>

#include "base/table_columns.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr int kCodeDecimals = 4;

/// The ellipse of standard deviation in the map: semi-axes, azimuth of the longer one from north (y).
struct MapEllipse {
  double major_m, minor_m, azimuth_rad;
};

MapEllipse ellipse_of(const AdjustedPoint& p) {
  const double xx = p.covariance_m2[0], xy = p.covariance_m2[1], yy = p.covariance_m2[4];
  const double mean = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
  return {std::sqrt(std::max(0.0, mean + half)), std::sqrt(std::max(0.0, mean - half)),
          std::atan2(2 * xy, yy - xx) / 2};
}

/// Which line, and from which point to which.
struct Ends {
  uint64_t line;
  uint32_t from, to;
};

Ends ends_of(const Survey& survey, const NetworkObservation& o) {
  if (o.kind <= ObservationKind::kDistance) {
    const SurveySight& s = survey.sightings[o.sighting];
    return {s.line, survey.setups[s.setup].station, s.target};
  }
  if (o.kind <= ObservationKind::kZ) return {survey.points[o.subject].line, o.subject, o.subject};
  const uint32_t station = survey.setups[o.subject].station;
  return {0, station, station};
}

}  // namespace

FieldTable network_summary(const NetworkAdjustment& n) {
  FieldTable t;
  add_value<uint8_t>(t, "converged", "", "1: the coordinates stay", n.is_converged);
  add_value<uint64_t>(t, "iterations", "", "steps", n.steps_m.size());
  add_value<double>(t, "last_step", "m", "greatest change of a coordinate in the last step",
                    n.steps_m.empty() ? 0 : n.steps_m.back());
  add_value<uint64_t>(t, "points", "", "", n.points.size());
  add_value<uint64_t>(t, "setups", "", "of the instrument", n.survey.setups.size());
  add_value<uint64_t>(t, "observations", "", "centrings included", n.observations.size());
  add_value<uint64_t>(t, "unknowns", "", "coordinates, orientations, centrings",
                      static_cast<uint64_t>(n.unknowns));
  add_value<uint64_t>(t, "defect", "", "inner constraints of a free network",
                      static_cast<uint64_t>(n.defect));
  add_value<int64_t>(t, "redundancy", "", "observations to spare", n.redundancy);
  add_value<uint64_t>(t, "rejected", "", "outliers left out", n.rejected);
  add_value<uint64_t>(t, "outliers", "", "that the tests call so, rejected ones included",
                      static_cast<uint64_t>(std::count_if(
                          n.observations.begin(), n.observations.end(),
                          [](const AdjustedObservation& o) { return o.is_outlier; })));
  add_value<double>(t, "weighted_squares", "1", "v^T P v", n.weighted_squares);
  add_value<double>(t, "sigma0", "1", "factor of the standard deviations", n.sigma0);
  add_value<double>(t, "p_value", "1", "of the global test, both sides", n.p_value);
  return t;
}

FieldTable network_points(const NetworkAdjustment& n) {
  using P = AdjustedPoint;
  FieldTable t;
  add_columns<double, 3>(t, n.points, "xyz", "m", "adjusted", [](const P& p, double* out) {
    for (int axis = 0; axis < 3; ++axis) out[axis] = p.position[axis];
  });
  add_columns<double, 3>(t, n.points, "sigma", "m", "standard deviations; 0: fixed",
                         [](const P& p, double* out) {
                           for (size_t i = 0; i < 3; ++i)
                             out[i] = std::sqrt(std::max(0.0, p.covariance_m2[4 * i]));
                         });
  add_columns<double, 9>(t, n.points, "covariance", "m2", "row-major", [](const P& p, double* out) {
    std::copy(p.covariance_m2.begin(), p.covariance_m2.end(), out);
  });
  add_column<double>(t, n.points, "ellipse_major", "m", "of the standard ellipse in the map",
                     [](const P& p) { return ellipse_of(p).major_m; });
  add_column<double>(t, n.points, "ellipse_minor", "m", "of the standard ellipse in the map",
                     [](const P& p) { return ellipse_of(p).minor_m; });
  add_column<double>(t, n.points, "ellipse_azimuth", "rad", "of its longer axis, from north",
                     [](const P& p) { return ellipse_of(p).azimuth_rad; });
  return t;
}

FieldTable network_observations(const NetworkAdjustment& n) {
  using O = AdjustedObservation;
  using K = NetworkObservation;
  FieldTable t;
  add_column<uint8_t>(t, n.kinds, "kind", "", "JALON_OBSERVATION_...",
                      [](const K& k) { return static_cast<uint8_t>(k.kind); });
  add_column<uint64_t>(t, n.kinds, "line", "", "of its list; 0: of none",
                       [&](const K& k) { return ends_of(n.survey, k).line; });
  add_column<uint64_t>(t, n.kinds, "from", "", "point",
                       [&](const K& k) { return ends_of(n.survey, k).from; });
  add_column<uint64_t>(t, n.kinds, "to", "", "point",
                       [&](const K& k) { return ends_of(n.survey, k).to; });
  const auto number = [&](const char* name, const char* unit, const char* meaning,
                          double O::*member) {
    add_column<double>(t, n.observations, name, unit, meaning,
                       [&](const O& o) { return o.*member; });
  };
  number("measured", "", "rad or m, in the first face", &O::measured);
  number("residual", "", "adjusted less measured", &O::residual);
  number("sigma", "", "of what was measured, the target's centring included", &O::sigma);
  number("redundancy", "1", "share of an error that shows in the residual", &O::redundancy);
  number("normalised", "1", "residual over its standard deviation (Baarda's w)", &O::normalised);
  number("p_value", "1", "chance of as much by noise alone", &O::p_value);
  number("detectable", "", "least error that the test finds", &O::detectable);
  add_column<uint8_t>(t, n.observations, "outlier", "", "1: the test rejects it",
                      [](const O& o) { return o.is_outlier; });
  add_column<uint8_t>(t, n.kinds, "rejected", "", "1: it was left out",
                      [](const K& k) { return !k.is_used; });
  return t;
}

std::string network_codes(const NetworkAdjustment& n) {
  std::string out;
  for (size_t i = 0; i < n.points.size(); ++i) {
    const SurveyPoint& point = n.survey.points[i];
    if (point.code.empty()) continue;
    out += point.id;
    for (int axis = 0; axis < 3; ++axis)
      out += ";" + text_of(n.points[i].position[axis], kCodeDecimals);
    out += ";" + point.code + "\n";
  }
  return out;
}

}  // namespace jalon
