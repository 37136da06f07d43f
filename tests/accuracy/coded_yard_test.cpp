// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Classes by feature codes on the synthetic yard, whose truth is known, by a total-station survey and by targets, with
// the thresholds of their source. JALON_YARD_SEEDS=101-110 takes these seeds; whatever was chosen by looking at results
// was chosen on seeds 1 to 10.
#include <doctest/doctest.h>

#include "coded_yard.h"
#include "recipe.h"
#include "seed_range.h"

using namespace jalon;
using namespace jalon::test;

namespace {

YardSettings zone_of(YardZone zone) {
  YardSettings settings;
  settings.zone = zone;
  return settings;
}

ClassFigures by_survey(const CodedYard& yard, CodeForm form) {
  SurveyCodeSettings settings;
  settings.input.form = form;
  settings.input.codes = yard.survey;
  Task task;
  return yard.of(segment_by_survey_codes(yard.cloud, settings, task));
}

ClassFigures by_targets(const CodedYard& yard, CodeForm form) {
  TargetCodeSettings settings;
  settings.input.form = form;
  settings.input.codes = yard.targets;
  Task task;
  return yard.of(segment_by_target_codes(yard.cloud, settings, task));
}

constexpr double kFullSpacing_m = 0.02, kShortSpacing_m = 0.04;

}  // namespace

TEST_CASE("coded_yard__both_methods_give_points_their_classes") {
  SeedRange seeds{1, is_full() ? 10u : 1u};
  if (const auto asked = seeds_asked_for("JALON_YARD_SEEDS")) seeds = *asked;
  const struct {
    YardZone zone;
    const char* name;
  } zones[] = {{YardZone::kComplete, "complete building"}, {YardZone::kFacades, "facades"}};
  for (const auto& [zone, name] : zones)
    for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      CAPTURE(seed);
      const CodedYard yard(zone_of(zone), seed, is_full() ? kFullSpacing_m : kShortSpacing_m);
      for (const CodeForm form : {CodeForm::kSource, CodeForm::kImproved}) {
        const char* form_name = form == CodeForm::kSource ? "source" : "improved";
        const ClassFigures survey = by_survey(yard, form), targets = by_targets(yard, form);
        MESSAGE("FIGURE codes, " << name << ", seed " << seed << ", survey, " << form_name << ", "
                                 << yard.truth.size() << " points: " << survey.text());
        MESSAGE("FIGURE codes, " << name << ", seed " << seed << ", targets, " << form_name << ": "
                                 << targets.text());
        for (const ClassFigures* figures : {&survey, &targets})
          CHECK(figures->counts[2][3] + figures->counts[3][2] == 0);
      }
    }
}
