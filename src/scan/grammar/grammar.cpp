// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/grammar/grammar.h"

#include "base/error.h"
#include "scan/builder/scene_frame.h"
#include "scan/facade_truth.h"
#include "scan/grammar/realise.h"
#include "scan/grammar/survey.h"
#include "scan/grammar/truth.h"

namespace jalon {

namespace {

constexpr uint64_t kFillingStream = 5;  // of the scene's seed: curtains

}  // namespace

const char* name_of(FacadeKind kind) {
  constexpr const char* kNames[] = {"any",     "town_house", "apartments", "shops",     "arcade",
                                    "offices", "gabled",     "wings",      "loggias",   "church",
                                    "factory", "terrace",    "mansard",    "timbered",  "villa",
                                    "school",  "sheds",      "nave",       "warehouse", "staggered",
                                    "corner",  "mill",       "inn",        "parade"};
  static_assert(std::size(kNames) == kFacadeKinds + 1);
  return kNames[static_cast<size_t>(kind)];
}

void build_grammar(const SceneSettings& settings, SceneBuilder& out) {
  const grammar::Plan plan = grammar::plan_facade(settings.grammar, settings.seed);
  grammar::Dice dice(settings.seed, kFillingStream);
  grammar::realise(plan, dice, out);
  grammar::add_rooms(plan, out);
  grammar::add_ground(
      plan, grammar::reach_m(grammar::survey_of(plan, settings.grammar, settings.seed)), out);
  if (grammar::has_occluders(settings.grammar, settings.seed))
    grammar::add_occluders(plan, settings.seed, out);
}

SceneSurvey scene_survey(const SceneSettings& settings) {
  if (settings.name != SceneName::kGrammar) return {};
  const grammar::Plan plan = grammar::plan_facade(settings.grammar, settings.seed);
  SceneSurvey out = grammar::survey_of(plan, settings.grammar, settings.seed);
  const Transform T_world_scene = scene_frame(settings);
  for (ScanStation& station : out.stations) station.pose = T_world_scene * station.pose;
  return out;
}

FacadeTruth facade_truth(const SceneSettings& settings, const SceneSurvey& survey, Task& task) {
  if (settings.name != SceneName::kGrammar)
    fail(Status::kUnsupported, "only scene \"grammar\" tells its walls and openings");
  const grammar::Plan plan = grammar::plan_facade(settings.grammar, settings.seed);
  FacadeTruth out = grammar::truth_of(plan, scene_frame(settings));
  out.seed = settings.seed;
  const Model model = build_scene(settings, task);
  const SceneSurvey own = survey.stations.empty() ? scene_survey(settings) : SceneSurvey{};
  grammar::look(model, survey.stations.empty() ? own : survey, out, task);
  return out;
}

}  // namespace jalon
