// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/adjustment_tables.h"

#include <algorithm>

#include "base/error.h"
#include "base/table_columns.h"

namespace jalon {

namespace {

void put(const Vec2& v, double* out) { out[0] = v.u, out[1] = v.v; }

struct Unknown {
  uint8_t group = 0, axis = 0;
  uint32_t number = 0;
};

// Of the covariance's n rows, in their order.
std::vector<Unknown> unknowns_of(const JointAdjustment& a, size_t n) {
  enum : uint8_t { kControl, kBlock, kTurn, kFacade, kStrip };
  const auto controls = static_cast<uint32_t>(a.trajectory.by_m.size()),
             blocks = static_cast<uint32_t>(a.model.blocks.size()),
             facades = static_cast<uint32_t>(a.model.facades.size());
  std::vector<Unknown> made;
  const auto list = [&](uint8_t group, uint8_t axis, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) made.push_back({group, axis, i});
  };
  list(kControl, 0, controls), list(kControl, 1, controls);
  list(kBlock, 0, blocks), list(kBlock, 1, blocks);
  const bool has_turns = squared_norm(a.attitude_bias_sigmas_rad) > 0;
  for (uint8_t axis = 0; has_turns && axis < 3; ++axis) made.push_back({kTurn, axis, 0});
  if (made.size() == n) return made;
  list(kFacade, 0, facades);
  for (uint32_t s = 0; s < a.strip_points.size(); ++s)
    if (a.strip_points[s] > 0) made.push_back({kStrip, 0, s});
  return made;
}

}  // namespace

FieldTable summary_table(const JointAdjustment& a) {
  const JointPass& last = a.passes.back();
  FieldTable t;
  add_value<uint8_t>(t, "converged", "", "1: nothing moved any more", a.converged ? 1 : 0);
  add_value<uint64_t>(t, "passes", "", "made", a.passes.size());
  add_value<uint64_t>(t, "points", "", "whose rays were cast", a.points.size());
  add_value<uint64_t>(t, "outside", "", "points of the cloud outside of the trajectory's time",
                      a.points.outside);
  add_value<uint64_t>(t, "matched", "", "of the points, accepted", last.matched);
  add_value<uint64_t>(t, "strips", "", "that were adjusted", a.strips);
  add_value<double>(t, "rms", "m", "of the accepted points off their strips", last.rms_m);
  add_value<double>(t, "chi_square", "1", "weighted square sum of the corrections", a.chi_square);
  add_value<double>(t, "p_value", "1", "of as much and more, were the sigmas right", a.p_value);
  const Vec2 weak[] = {a.weak_direction};
  add_columns<double, 2>(t, weak, "weak_direction", "1", "that the walls hold least", put);
  add_value<double>(t, "weak_share", "1", "of what the best direction is held by", a.weak_share);
  add_value<uint8_t>(t, "weak_is_held", "", "0: nothing is known along the weak direction",
                     a.weak_share < kHeldShare ? 0 : 1);
  const Vec3 turns[] = {a.attitude_bias_rad, a.attitude_bias_sigmas_rad};
  const auto put_three = [](const Vec3& v, double* out) {
    out[0] = v.x, out[1] = v.y, out[2] = v.z;
  };
  add_columns<double, 3>(t, std::span(turns, 1), "attitude_bias", "rad",
                         "constant turns about the vehicle's axes; 0: not adjusted", put_three);
  add_columns<double, 3>(t, std::span(turns + 1, 1), "attitude_bias_sigma", "rad",
                         "standard deviations", put_three);
  uint64_t ground_points = 0;
  for (const GroundRise& r : a.ground) ground_points += r.points;
  add_value<uint64_t>(t, "ground_points", "", "under the vehicle, that told heights",
                      ground_points);
  add_value<uint64_t>(t, "ground_intervals", "", "between control times, that have such points",
                      a.ground.size());
  add_value<double>(t, "ground_chi_square", "1", "weighted square sum of heights' corrections",
                    a.ground_chi_square);
  add_value<double>(t, "wrong_strips", "1", "share of matches that the field strip contradicts",
                    a.wrong_share);
  add_value<double>(t, "wrong_facades", "1", "share of matches to another facade",
                    a.wrong_facade_share);
  add_value<uint64_t>(t, "doubtful_strips", "", "whose walls may be those of others: not adjusted",
                      static_cast<uint64_t>(std::ranges::count(a.strip_is_doubtful, true)));
  return t;
}

FieldTable pass_table(const JointAdjustment& a) {
  using P = JointPass;
  FieldTable t;
  const auto count = [&](const char* name, const char* meaning, uint64_t P::*member) {
    add_column<uint64_t>(t, a.passes, name, "", meaning, [&](const P& p) { return p.*member; });
  };
  count("matched", "accepted", &P::matched);
  count("nothing", "rays that met no strip", &P::nothing);
  count("behind", "rays that met a strip from inside", &P::behind);
  count("far", "too far from the strip", &P::far);
  count("turned", "of a wall that stands otherwise", &P::turned);
  count("unsteady", "left out because their match changed late", &P::unsteady);
  count("strips", "that were adjusted", &P::strips);
  count("changed", "points whose match is another than in the pass before", &P::changed);
  add_column<double>(t, a.passes, "rms", "m", "of the accepted points before the step",
                     [](const P& p) { return p.rms_m; });
  add_column<double>(t, a.passes, "step", "m", "the greatest change",
                     [](const P& p) { return p.step_m; });
  add_column<double>(t, a.passes, "chi_square", "1", "after the step",
                     [](const P& p) { return p.chi_square; });
  return t;
}

FieldTable control_table(const JointAdjustment& a) {
  FieldTable t;
  add_column<double>(t, a.trajectory.times_s, "time", "s", "of the control position",
                     [](double s) { return s; });
  add_columns<double, 2>(t, a.trajectory.by_m, "correction", "m", "east and north", put);
  add_columns<double, 2>(t, a.trajectory_sigmas, "sigma", "m", "standard deviations", put);
  add_columns<double, 2>(t, a.trajectory_priors, "prior_sigma", "m", "before", put);
  const auto height = [&](const char* name, const char* meaning, const std::vector<double>& list) {
    add_column<double>(t, list, name, "m", meaning, [](double v) { return v; });
  };
  height("height_correction", "by the ground", a.heights_m);
  height("height_sigma", "standard deviation", a.height_sigmas_m);
  height("height_prior_sigma", "before", a.height_priors_m);
  return t;
}

FieldTable block_table(const JointAdjustment& a) {
  FieldTable t;
  add_columns<double, 2>(t, a.model.blocks, "offset", "m", "east and north", put);
  add_columns<double, 2>(t, a.block_sigmas, "sigma", "m", "standard deviations", put);
  return t;
}

FieldTable facade_table(const JointAdjustment& a) {
  FieldTable t;
  const auto same = [](double v) { return v; };
  add_column<double>(t, a.model.facades, "offset", "m", "along its normal", same);
  add_column<double>(t, a.facade_sigmas, "sigma", "m", "standard deviation", same);
  return t;
}

FieldTable strip_table(const JointAdjustment& a) {
  FieldTable t;
  const auto same = [](auto v) { return v; };
  add_column<double>(t, a.model.strips, "offset", "m", "along its facade's normal", same);
  add_column<double>(t, a.strip_sigmas, "sigma", "m", "standard deviation", same);
  add_column<uint64_t>(t, a.strip_points, "points", "", "that hold it; 0: not adjusted", same);
  add_column<double>(t, a.strip_distances_m, "distance", "m",
                     "of the strip as given before its points as given", same);
  add_column<uint8_t>(t, a.strip_is_doubtful, "doubtful", "",
                      "1: its wall may be another's: not adjusted",
                      [](bool is) { return static_cast<uint8_t>(is); });
  return t;
}

FieldTable match_table(const JointAdjustment& a) {
  FieldTable t;
  add_column<uint32_t>(t, a.points.index, "point", "", "of the cloud",
                       [](uint32_t i) { return i; });
  add_column<uint32_t>(t, a.matches, "strip", "", "that its ray meets",
                       [](const PointMatch& m) { return m.strip; });
  add_column<uint8_t>(t, a.matches, "state", "", "1: accepted",
                      [](const PointMatch& m) { return static_cast<uint8_t>(m.state); });
  add_column<double>(t, a.matches, "distance", "m", "before the strip, both where they then stood",
                     [](const PointMatch& m) { return m.distance_m; });
  add_column<double>(t, a.weights, "weight", "1", "in the strip's mean",
                     [](double w) { return w; });
  return t;
}

FieldTable covariance_table(const JointAdjustment& a) {
  const auto n = static_cast<size_t>(a.covariance.rows());
  if (n == 0)
    fail(Status::kInvalidArgument, "the covariance was not asked for: the parameter covariance");
  if (n > kMostComponents)
    fail(Status::kLimit, "a covariance of %zu rows is too wide for a table of %u", n,
         kMostComponents);
  auto column = std::make_shared<Column>(
      FieldInfo{"covariance", ElementType::kFloat64, static_cast<uint32_t>(n), "m2", "with each"},
      n);
  const auto out = column->values<double>();
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j)
      out[n * i + j] = a.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  FieldTable t;
  const std::vector<Unknown> rows = unknowns_of(a, n);
  add_column<uint8_t>(t, rows, "group", "",
                      "0: control position, 1: block, 2: turn of the vehicle, 3: facade, 4: strip",
                      [](const Unknown& u) { return u.group; });
  add_column<uint8_t>(t, rows, "axis", "",
                      "0: east, 1: north; of turns 0: roll, 1: pitch, 2: heading; of facades and "
                      "strips 0: along the normal",
                      [](const Unknown& u) { return u.axis; });
  add_column<uint32_t>(t, rows, "number", "", "of the control position, block, facade or strip",
                       [](const Unknown& u) { return u.number; });
  t.set(std::move(column));
  return t;
}

}  // namespace jalon
