// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/grammar/survey.h"

#include <algorithm>
#include <cmath>

#include "scan/grammar/dice.h"

namespace jalon::grammar {

namespace {

constexpr uint64_t kSurveyStream = 3, kWishesStream = 4;  // of the scene's seed
constexpr double kMostPoints = 2.5e6;                     // of a spacing by the seed
constexpr double kBesideFront_m = 1.5, kDown_rad = 0.6, kUp_rad = 0.03;
constexpr double kPi = std::numbers::pi;

struct Wishes {
  bool has_glass, has_occluders;
};
Wishes wishes_of(const GrammarSettings& settings, uint64_t seed) {
  Dice dice(seed, kWishesStream);
  const bool glass = dice.chance(0.85), occluders = dice.chance(0.75);
  return {decided(settings.glass, glass), decided(settings.occluders, occluders)};
}

/// Evenly along the front and a little beyond, at distances that show all of it.
std::vector<Vec3> places_of(const Plan& plan, int count, Dice& dice) {
  const double nearest = std::max(5.0, 0.45 * std::max(plan.width_m, plan.top_m()));
  std::vector<Vec3> out;
  for (int i = 0; i < count; ++i)
    out.push_back({plan.width_m * ((i + 0.5) / count + dice.between(-0.15, 0.15)),
                   -nearest * dice.between(1, 1.6), dice.between(1.4, 1.8)});
  return out;
}

/// The field of view that covers the front from everywhere.
void set_view(const Plan& plan, const std::vector<Vec3>& places, StaticSettings& s) {
  double left = 0, right = 0, up = 0;
  for (const Vec3& p : places) {
    left = std::min(left, std::atan2(-kBesideFront_m - p.x, -p.y));
    right = std::max(right, std::atan2(plan.width_m + kBesideFront_m - p.x, -p.y));
    up = std::max(up, std::atan2(plan.top_m() - p.z, -p.y));
  }
  s.horizontal_from_rad = left;
  s.horizontal_to_rad = right;
  s.vertical_from_rad = -kDown_rad;
  s.vertical_to_rad = std::min(kPi / 2, up + kUp_rad);
}

}  // namespace

bool has_glass(const GrammarSettings& settings, uint64_t seed) {
  return wishes_of(settings, seed).has_glass;
}
bool has_occluders(const GrammarSettings& settings, uint64_t seed) {
  return wishes_of(settings, seed).has_occluders;
}

double reach_m(const SceneSurvey& survey) {
  constexpr double kBehind_m = 2;
  double reach = 0;
  for (const ScanStation& station : survey.stations)
    reach = std::max(reach, -station.pose.translation().y);
  return reach + kBehind_m;
}

SceneSurvey survey_of(const Plan& plan, const GrammarSettings& settings, uint64_t seed) {
  Dice dice(seed, kSurveyStream);
  SceneSurvey out;
  StaticSettings& s = out.scanner;
  // 1. Stations. Every draw is made whether or not it is asked for: one choice changes no other.
  const int drawn = dice.count(1, 4);
  const int count = settings.stations > 0 ? static_cast<int>(settings.stations) : drawn;
  const double scale = dice.scale(0.003, 0.04), noise = dice.between(0.002, 0.008),
               misfit = dice.between(0, 0.003), dropout = dice.between(0, 0.02),
               least = dice.between(0.02, 0.1), most = dice.between(0.2, 0.5);
  const bool has_beam = dice.chance(0.4);
  const double diameter = dice.between(0.003, 0.006);
  const std::vector<Vec3> places = places_of(plan, count, dice);
  for (const Vec3& p : places) {
    ScanStation station;
    station.name = "station " + std::to_string(out.stations.size() + 1);
    station.pose.m[3] = p.x;
    station.pose.m[7] = p.y;
    station.pose.m[11] = p.z;
    out.stations.push_back(station);
  }
  // 2. Steps: the spacing at the mean distance.
  double distance = 0;
  for (const Vec3& p : places) distance -= p.y / static_cast<double>(places.size());
  const double finest = std::sqrt(plan.width_m * plan.top_m() * count / kMostPoints);
  const double spacing = settings.spacing_m > 0 ? settings.spacing_m : std::max(scale, finest);
  s.horizontal_step_rad = s.vertical_step_rad = spacing / distance;
  set_view(plan, places, s);
  // 3. Errors and the beam.
  s.range_noise_m = settings.noise_m >= 0 ? settings.noise_m : noise;
  s.misfit_shift_m = settings.misfit_m >= 0 ? settings.misfit_m : misfit;
  s.dropout = dropout;
  if (has_beam) s.beam_diameter_m = diameter, s.beam_divergence_rad = 2e-4;
  if (has_glass(settings, seed))
    s.surfaces.glass_return_min = least, s.surfaces.glass_return_max = most;
  s.seed = seed;
  return out;
}

}  // namespace jalon::grammar
