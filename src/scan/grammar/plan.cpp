// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/grammar/plan.h"

#include <algorithm>

#include "base/error.h"
#include "scan/grammar/sketch.h"

namespace jalon::grammar {

namespace {

constexpr double kLeastFront_m = 4;
constexpr uint64_t kPlanStream =
    1;  // of the scene's seed; the survey and what stands about have others
constexpr double kLeastRoom_m = 2;

using Recipe = void (*)(Sketch&);
constexpr Recipe kRecipes[] = {
    plan_town_house, plan_apartments, plan_shops,  plan_arcade,  plan_offices, plan_gabled,
    plan_wings,      plan_loggias,    plan_church, plan_factory, plan_terrace, plan_mansard,
    plan_timbered,   plan_villa,      plan_school, plan_sheds,   plan_nave,    plan_warehouse,
    plan_staggered,  plan_corner,     plan_mill,   plan_inn,     plan_parade};
static_assert(std::size(kRecipes) == kFacadeKinds);

}  // namespace

double Plan::top_m() const {
  double top = 0;
  for (const PlannedWall& wall : walls) top = std::max(top, bounds_of(wall.outline).v1);
  return top;
}

Plan plan_facade(const GrammarSettings& settings, uint64_t seed) {
  if (settings.front_m > 0 && settings.front_m < kLeastFront_m)
    fail(Status::kInvalidArgument, "front_m: a facade of the grammar is at least 4 m long");
  Dice dice(seed, kPlanStream);
  Plan plan;
  const int drawn = dice.count(1, kDrawnKinds);
  plan.kind = settings.kind == FacadeKind::kAny ? static_cast<FacadeKind>(drawn) : settings.kind;
  plan.has_gaps = decided(settings.gaps, dice.chance(0.6));
  plan.rooms_to_m = dice.between(2, 5);
  Sketch sketch(settings, plan, dice);
  kRecipes[static_cast<size_t>(plan.kind) - 1](sketch);
  plan.rooms_to_m = std::max(plan.rooms_to_m, plan.rooms_from_m + kLeastRoom_m);
  return plan;
}

}  // namespace jalon::grammar
