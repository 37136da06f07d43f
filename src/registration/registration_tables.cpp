// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/registration_tables.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.h"
#include "base/table_columns.h"
#include "registration/symmetric_eigen6.h"

namespace jalon {

namespace {

constexpr size_t kTurns = 3;  // the first unknowns; the shifts follow

double length_of(size_t unknown, double extent_m) { return unknown < kTurns ? extent_m : 1; }

FieldTable directions_table(const std::array<PoseDirection, 6>& directions, double extent_m) {
  std::vector<double> units, sigmas;
  std::vector<uint8_t> observable;
  for (const PoseDirection& d : directions) {
    for (size_t k = 0; k < 6; ++k) units.push_back(d.unit[k] / length_of(k, extent_m));
    sigmas.push_back(d.sigma_m);
    observable.push_back(d.observable);
  }
  FieldTable table;
  table.set(
      make_column<double>({.name = "direction",
                           .components = 6,
                           .unit = "",
                           .meaning = "turn about the centre (rad for each metre), then shift"},
                          units));
  table.set(make_column<double>(
      {.name = "sigma", .unit = "m", .meaning = "standard deviation along it"}, sigmas));
  table.set(make_column<uint8_t>(
      {.name = "observable", .unit = "", .meaning = "1: the data fix it; 0: nothing does"},
      observable));
  return table;
}

template <size_t N>
ColumnPtr row_of(const char* name, const char* unit, const char* meaning,
                 const std::array<double, N>& values) {
  return make_column<double>({.name = name, .components = N, .unit = unit, .meaning = meaning},
                             values);
}

void add_stopped(const Registration& r, FieldTable& table) {
  add_value<uint8_t>(table, "converged", "", "1: the pose stands; 0: see stopped", r.converged);
  add_value<uint8_t>(table, "stopped", "", "why: JALON_STOPPED_...",
                     static_cast<uint8_t>(r.stopped));
}

}  // namespace

std::array<PoseDirection, 6> pose_directions(const Square<6>& covariance, double extent_m) {
  const Eigen6 eigen = symmetric_eigen(covariance, extent_m);
  std::array<PoseDirection, 6> out;
  for (size_t i = 0; i < 6; ++i) {
    const size_t weakest_first = 5 - i;
    out[i].unit = eigen.vectors[weakest_first];
    out[i].sigma_m = std::sqrt(std::max(0.0, eigen.values[weakest_first]));
  }
  return out;
}

void fill_tables(Registration& r, const std::array<PoseDirection, 6>& directions) {
  r.unobservable = 0;
  for (const PoseDirection& d : directions) r.unobservable += !d.observable;
  r.directions = directions_table(directions, r.extent_m);
  FieldTable table;
  add_stopped(r, table);
  add_value<uint64_t>(table, "iterations", "", "steps made", r.iterations);
  add_value<uint64_t>(table, "pairs", "", "pairs that the last step stood on", r.pairs);
  add_value<double>(table, "rms", "m", "root mean square residual of those pairs", r.rms_m);
  add_value<double>(table, "scale", "1", "of the pose", r.scale);
  add_value<uint64_t>(table, "unobservable", "", "directions of the six that nothing fixes",
                      r.unobservable);
  table.set(row_of<3>("centre", "m", "point that the rotations of the covariance turn about",
                      {r.centre.x, r.centre.y, r.centre.z}));
  table.set(row_of<36>("covariance", "", "of rotation (rad) about the centre and shift (m)",
                       r.covariance));
  add_value<double>(table, "extent", "m", "length that makes turns and shifts comparable",
                    r.extent_m);
  for (const ColumnPtr& column : r.summary) table.set(column);
  r.summary = std::move(table);
}

void set_stopped(Registration& r) { add_stopped(r, r.summary); }

void fill_judgement(Registration& r, PoseJudgement judgement) {
  add_value<uint8_t>(r.summary, "verdict", "", "JALON_VERDICT_...",
                     static_cast<uint8_t>(judgement.verdict));
  add_value<double>(r.summary, "confidence", "1", "probability that the pose is right",
                    judgement.confidence);
  r.judgement = std::move(judgement);
}

PoseJudgement judgement_of_search(StopReason stopped) {
  switch (stopped) {
    case StopReason::kConverged:
      return {};
    case StopReason::kAmbiguous:
      return {Verdict::kDoubtful, kNaN, "a clearly different pose fits about as well"};
    case StopReason::kIterationLimit:
      return {Verdict::kDoubtful, kNaN, "the steps have not settled"};
    case StopReason::kTooFewPairs:
      return {Verdict::kRefused, kNaN, "what both have in common does not carry a pose"};
    case StopReason::kNothingFound:
      break;
  }
  return {Verdict::kRefused, kNaN, "no pose explains both"};
}

void hide_sigmas(Registration& r) {
  r.covariance.fill(kNaN);
  r.summary.set(row_of<36>("covariance", "", "of rotation (rad) about the centre and shift (m)",
                           r.covariance));
  const size_t n = r.directions.require("sigma").count();
  r.directions.set(
      make_column<double>({.name = "sigma", .unit = "m", .meaning = "standard deviation along it"},
                          std::vector<double>(n, kNaN)));
}

}  // namespace jalon
