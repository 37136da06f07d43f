// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Classes by feature codes on the synthetic yard, whose truth is known, by a total-station survey and by targets, with
// the thresholds of their source. JALON_YARD_SEEDS=101-110 takes these seeds; whatever was chosen by looking at results
// was chosen on seeds 1 to 10.
#include <doctest/doctest.h>

#include "coded_yard.h"
#include "recipe.h"
#include "seed_range.h"

namespace jalon::coded_yard_test {

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

// In no class worse by more than 0.002, better wherever the source's form is below 0.9.
void check_no_worse(const ClassFigures& source, const ClassFigures& improved) {
  for (size_t c = 0; c < 5; ++c) {
    CAPTURE(c);
    if (source.row(c) == 0) continue;
    CHECK(improved.f1(c) > source.f1(c) - 0.002);
    if (source.f1(c) < 0.9) CHECK(improved.f1(c) > source.f1(c));
  }
}

// A zone at a density, and the least mean F1 of the classes by survey and by targets, in the source's form and
// improved.
struct YardCase {
  YardZone zone;
  YardDensity density;
  const char* name;
  double survey, targets, improved_survey, improved_targets;
  double least(bool by_survey_codes, CodeForm form) const {
    if (form == CodeForm::kSource) return by_survey_codes ? survey : targets;
    return by_survey_codes ? improved_survey : improved_targets;
  }
};

// In the source's form and as dense as the source: what it asks for. At an even density, and in the improved forms,
// whatever holds on every seed that was tried: at an even density the source's target method reaches 0.77 to 0.82 of
// facades, as half of all doors lie 1 or 2 cm behind the even plane of their wall and a third of the gutters has no
// target, which hold fewer points in the source's cloud. With F1 0.684 of doors, all that a recall of 0.52 leaves, and
// what the source's table 10 has of the other classes, it is 0.804. Two gutters stand 3 and 4 cm before their wall, so
// that it depends on how the drawn plane of the wall leans whether it takes them.
constexpr YardCase kCases[] = {
    {YardZone::kComplete, YardDensity::kEven, "complete building", 0.93, 0.90, 0.98, 0.98},
    {YardZone::kComplete, YardDensity::kSource, "complete building as dense as the source", 0.93,
     0.90, 0.98, 0.97},
    {YardZone::kFacades, YardDensity::kEven, "facades", 0.92, 0.75, 0.98, 0.94},
    {YardZone::kFacades, YardDensity::kSource, "facades as dense as the source", 0.89, 0.82, 0.98,
     0.97}};
constexpr double kFullSpacing_m = 0.02, kShortSpacing_m = 0.04;
// Walls and gutters alike have the 10 000 points/m2 that growing asks for: denser gutters draw the planes of walls.
constexpr double kSourceSpacing_m = 0.01;

}  // namespace

TEST_CASE("coded_yard__both_methods_give_points_their_classes") {
  SeedRange seeds{1, is_full() ? 10u : 1u};
  if (const auto asked = seeds_asked_for("JALON_YARD_SEEDS")) seeds = *asked;
  for (const YardCase& yard_case : kCases)
    for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      CAPTURE(seed);
      const double spacing_m = !is_full()                                  ? kShortSpacing_m
                               : yard_case.density == YardDensity::kSource ? kSourceSpacing_m
                                                                           : kFullSpacing_m;
      const CodedYard yard(zone_of(yard_case.zone), seed, spacing_m, yard_case.density);
      const std::string name = yard_case.name;
      ClassFigures source_survey, source_targets;
      for (const CodeForm form : {CodeForm::kSource, CodeForm::kImproved}) {
        const char* form_name = form == CodeForm::kSource ? "source" : "improved";
        const ClassFigures survey = by_survey(yard, form), targets = by_targets(yard, form);
        MESSAGE("FIGURE codes, " << name << ", seed " << seed << ", survey, "
                                 << std::string(form_name) << ", " << yard.truth.size()
                                 << " points: " << survey.text() << "; " << survey.confusions());
        MESSAGE("FIGURE codes, " << name << ", seed " << seed << ", targets, "
                                 << std::string(form_name) << ": " << targets.text() << "; "
                                 << targets.confusions());
        // Planes of targets reach into the doors beside windows; by their fronts they do not.
        CHECK(survey.counts[2][3] + survey.counts[3][2] == 0);
        if (form == CodeForm::kImproved) CHECK(targets.counts[2][3] + targets.counts[3][2] == 0);
        CHECK(survey.mean_f1() > yard_case.least(true, form));
        CHECK(targets.mean_f1() > yard_case.least(false, form));
        if (form == CodeForm::kSource) {
          source_survey = survey, source_targets = targets;
          continue;
        }
        check_no_worse(source_survey, survey);
        check_no_worse(source_targets, targets);
      }
    }
}

TEST_CASE("coded_yard__flush_doors_are_lost_to_targets_and_told_and_found_by_the_survey") {
  YardSettings settings = zone_of(YardZone::kFacades);
  settings.flush_doors = true;
  const CodedYard yard(settings, 1, kShortSpacing_m);
  CHECK(by_survey(yard, CodeForm::kSource).recall(2) > 0.95);
  CHECK(by_targets(yard, CodeForm::kSource).recall(2) < 0.7);
  TargetCodeSettings targets;
  targets.input.codes = yard.targets;
  Task task;
  const Segmentation coded = segment_by_target_codes(yard.cloud, targets, task);
  const auto is_told = [&](const char* door) {
    return coded.notes_json.find("\"object\":\"" + std::string(door) + "\",\"text\"") !=
           std::string::npos;
  };
  for (const char* door : {"door 132", "door 144"}) CHECK(is_told(door));
  CHECK(!is_told("door 145"));
  // Even leaves among waves are found.
  const ClassFigures improved = by_targets(yard, CodeForm::kImproved);
  CHECK(improved.recall(2) > 0.95);
  CHECK(improved.precision(2) > 0.9);
}

TEST_CASE("coded_yard__targets_at_the_outer_corners_find_more_of_the_windows") {
  YardSettings settings = zone_of(YardZone::kFacades);
  const CodedYard panes(settings, 1, kShortSpacing_m);
  settings.corner_targets = true;
  const CodedYard corners(settings, 1, kShortSpacing_m);
  TargetCodeSettings targets;
  targets.window_margin_m = 0.1;
  targets.input.codes = corners.targets;
  Task task;
  const ClassFigures by_corners = corners.of(segment_by_target_codes(corners.cloud, targets, task)),
                     by_panes = by_targets(panes, CodeForm::kSource);
  MESSAGE("FIGURE codes, windows by targets on panes: " << by_panes.f1(3)
                                                        << ", at corners: " << by_corners.f1(3));
  CHECK(by_corners.recall(3) > by_panes.recall(3));
}

TEST_CASE("coded_yard__panes_that_return_are_improved_windows_and_doors_too") {
  // Dusty, tinted, with a curtain behind: more points than the frames have.
  for (const double glass_return : {0.3, 1.0}) {
    const CodedYard yard(zone_of(YardZone::kFacades), 1,
                         is_full() ? kFullSpacing_m : kShortSpacing_m, YardDensity::kEven,
                         glass_return);
    for (const bool is_survey : {true, false}) {
      const ClassFigures figures =
          is_survey ? by_survey(yard, CodeForm::kImproved) : by_targets(yard, CodeForm::kImproved);
      CAPTURE(glass_return);
      CAPTURE(is_survey);
      MESSAGE("FIGURE codes, facades, panes that return " << glass_return << ": "
                                                          << figures.text());
      CHECK(figures.f1(2) > 0.95);
      CHECK(figures.f1(3) > 0.93);
      CHECK(figures.counts[2][3] + figures.counts[3][2] == 0);
    }
  }
}

TEST_CASE("coded_yard__a_shifted_gutter_point_is_warned_of_by_name") {
  YardSettings settings = zone_of(YardZone::kFacades);
  for (const double shift_m : {0.0, 0.03}) {
    settings.gutter_shift_m = shift_m;
    const CodedYard yard(settings, 1, kShortSpacing_m);
    SurveyCodeSettings survey;
    survey.input.codes = yard.survey;
    Task task;
    const Segmentation coded = segment_by_survey_codes(yard.cloud, survey, task);
    const size_t first = coded.notes_json.find("from the surveyed one");
    CHECK((first != std::string::npos) == (shift_m > 0));
    if (shift_m == 0) continue;
    CHECK(coded.notes_json.find("\"object\":\"gutter ") != std::string::npos);
    CHECK(coded.notes_json.find("from the surveyed one", first + 1) == std::string::npos);
  }
}

TEST_CASE("coded_yard__a_door_without_a_target_is_left_to_the_rest") {
  YardSettings settings = zone_of(YardZone::kComplete);
  settings.missing_target = true;
  const CodedYard yard(settings, 1, kShortSpacing_m);
  const ClassFigures figures = by_targets(yard, CodeForm::kSource);
  CHECK(figures.recall(2) < 0.9);  // a door of five sizes, one of them double
  CHECK(figures.counts[2][0] > figures.counts[2][1] + figures.counts[2][3]);
}

}  // namespace jalon::coded_yard_test
