// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/approximate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"

namespace jalon {

namespace {

constexpr double kLeastAngle_sin = 0.02;  // between rays that intersect: a degree

// From the instrument's point to the target's, in axes whose y is the circle's zero.
Vec3 polar(const SurveySight& sight, double scale) {
  const double level = sight.distance_m * std::sin(sight.zenith_rad) * scale;
  return {level * std::sin(sight.direction_rad), level * std::cos(sight.direction_rad),
          sight.distance_m * std::cos(sight.zenith_rad) + sight.instrument_height_m -
              sight.target_height_m};
}

// Clockwise, as directions count.
Vec3 turned(const Vec3& v, double by_rad) {
  const double c = std::cos(by_rad), s = std::sin(by_rad);
  return {c * v.x + s * v.y, c * v.y - s * v.x, v.z};
}

/// q = shift + p turned clockwise about the vertical.
struct LevelPose {
  double turn_rad;
  Vec3 shift;
};

using PlacePairs = std::vector<std::pair<Vec3, Vec3>>;

// Least squares; none where all of either side are one place.
std::optional<LevelPose> level_pose(const PlacePairs& pairs) {
  Vec3 from, to;
  for (const auto& [a, b] : pairs) from += a, to += b;
  from *= 1 / static_cast<double>(pairs.size());
  to *= 1 / static_cast<double>(pairs.size());
  double cosine = 0, sine = 0;
  for (const auto& [a, b] : pairs) {
    const Vec3 p = a - from, q = b - to;
    cosine += p.x * q.x + p.y * q.y;
    sine += p.y * q.x - p.x * q.y;
  }
  if (!(std::hypot(cosine, sine) > 0)) return std::nullopt;
  const double turn_rad = std::atan2(sine, cosine);
  return LevelPose{turn_rad, to - turned(from, turn_rad)};
}

/// Setups and their sights, and what is known of them so far.
class Placing {
 public:
  Placing(Survey& survey, double scale)
      : survey_(survey),
        scale_(scale),
        sights_(survey.setups.size()),
        of_targets_(survey.points.size()),
        turns_(survey.setups.size()) {
    for (const SurveySight& sight : survey.sightings) {
      sights_[sight.setup].push_back(&sight);
      of_targets_[sight.target].push_back(&sight);
    }
  }

  /// Places what follows from what is placed.
  void run() {
    while (step()) {
    }
  }
  /// The same from nothing: this setup stands at the origin, its circle points north.
  void run_from(size_t setup) {
    station(setup).position = {};
    turns_[setup] = 0;
    run();
  }

 private:
  SurveyPoint& station(size_t setup) { return survey_.points[survey_.setups[setup].station]; }
  SurveyPoint& target(const SurveySight& sight) { return survey_.points[sight.target]; }

  // True when something new is known. Intersections last: they are the weakest.
  bool step() {
    bool is_new = false;
    for (size_t i = 0; i < sights_.size(); ++i) {
      is_new = stand_freely(i) || is_new;
      is_new = orient(i) || is_new;
      is_new = sight_polar(i) || is_new;
    }
    return is_new || intersect();
  }

  // An unknown station: its polar sights laid onto the placed targets, by rotation about the vertical and translation.
  bool stand_freely(size_t setup) {
    if (station(setup).is_placed()) return false;
    PlacePairs pairs;
    for (const SurveySight* sight : sights_[setup])
      if (sight->is_polar() && target(*sight).is_placed())
        pairs.emplace_back(polar(*sight, scale_), target(*sight).position);
    if (pairs.size() < 2) return false;
    const auto pose = level_pose(pairs);
    if (!pose) return false;  // one place sighted twice
    turns_[setup] = pose->turn_rad;
    station(setup).position = pose->shift;
    return true;
  }

  bool orient(size_t setup) {
    if (turns_[setup] || !station(setup).is_placed()) return false;
    for (const SurveySight* sight : sights_[setup]) {
      if (!std::isfinite(sight->direction_rad) || !target(*sight).is_placed()) continue;
      const Vec3 d = target(*sight).position - station(setup).position;
      if (!(std::hypot(d.x, d.y) > 0)) continue;
      turns_[setup] = std::atan2(d.x, d.y) - sight->direction_rad;
      return true;
    }
    return false;
  }

  bool sight_polar(size_t setup) {
    if (!turns_[setup] || !station(setup).is_placed()) return false;
    bool is_new = false;
    for (const SurveySight* sight : sights_[setup]) {
      if (!sight->is_polar() || target(*sight).is_placed()) continue;
      target(*sight).position =
          station(setup).position + turned(polar(*sight, scale_), *turns_[setup]);
      is_new = true;
    }
    return is_new;
  }

  // Targets that two oriented setups sight; the height by a zenith angle of the first.
  bool intersect() {
    bool is_new = false;
    for (const auto& sights : of_targets_)
      for (const SurveySight* a : sights)
        for (const SurveySight* b : sights)
          if (a != b && !target(*a).is_placed()) is_new = cross_at(*a, *b) || is_new;
    return is_new;
  }

  std::optional<Vec3> ray(const SurveySight& sight) {
    if (!turns_[sight.setup] || !station(sight.setup).is_placed()) return std::nullopt;
    if (!std::isfinite(sight.direction_rad)) return std::nullopt;
    return turned({std::sin(sight.direction_rad), std::cos(sight.direction_rad), 0},
                  *turns_[sight.setup]);
  }

  bool cross_at(const SurveySight& a, const SurveySight& b) {
    const auto u = ray(a), v = ray(b);
    if (!u || !v || !std::isfinite(a.zenith_rad)) return false;
    const double sine = u->x * v->y - u->y * v->x;
    if (std::abs(sine) < kLeastAngle_sin) return false;
    const Vec3 from = station(a.setup).position, d = station(b.setup).position - from;
    const double s = (d.x * v->y - d.y * v->x) / sine;
    if (!(s > 0)) return false;
    target(a).position =
        from + *u * s +
        Vec3{0, 0, s / std::tan(a.zenith_rad) + a.instrument_height_m - a.target_height_m};
    return true;
  }

  Survey& survey_;
  double scale_;
  std::vector<std::vector<const SurveySight*>> sights_, of_targets_;
  std::vector<std::optional<double>> turns_;  ///< of the circles: azimuth of their zero
};

bool is_whole(const Survey& survey) {
  return std::all_of(survey.points.begin(), survey.points.end(),
                     [](const SurveyPoint& p) { return p.is_placed(); });
}

// A chain of setups between points that do not see each other: placed in axes of its own, then laid onto them.
bool place_by_own_axes(Survey& survey, size_t setup, double scale) {
  Survey own = survey;
  for (SurveyPoint& point : own.points) point.position = {NAN, NAN, NAN};
  Placing(own, scale).run_from(setup);
  PlacePairs pairs;
  for (size_t i = 0; i < own.points.size(); ++i)
    if (own.points[i].is_placed() && survey.points[i].is_placed())
      pairs.emplace_back(own.points[i].position, survey.points[i].position);
  if (pairs.size() < 2) return false;
  const auto pose = level_pose(pairs);
  if (!pose) return false;
  bool is_new = false;
  for (size_t i = 0; i < own.points.size(); ++i) {
    if (survey.points[i].is_placed() || !own.points[i].is_placed()) continue;
    survey.points[i].position = pose->shift + turned(own.points[i].position, pose->turn_rad);
    is_new = true;
  }
  return is_new;
}

}  // namespace

void place_points(Survey& survey, const NetworkSettings& settings) {
  const bool has_places = std::any_of(survey.points.begin(), survey.points.end(),
                                      [](const SurveyPoint& p) { return p.is_placed(); });
  if (has_places) Placing(survey, settings.scale).run();
  else if (!survey.setups.empty()) Placing(survey, settings.scale).run_from(0);
  for (size_t i = 0; i < survey.setups.size() && !is_whole(survey); ++i)
    if (place_by_own_axes(survey, i, settings.scale)) Placing(survey, settings.scale).run();
  for (const SurveyPoint& point : survey.points)
    if (!point.is_placed())
      fail(Status::kInsufficientData,
           "point %.40s: its sights do not give a place; give x, y and z in the list of points",
           point.id.c_str());
}

}  // namespace jalon
