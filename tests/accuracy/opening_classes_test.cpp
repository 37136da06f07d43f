// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Classes of openings and their confidence: on facades of the grammar, with the scanner's stations and without, and on
// real ones. JALON_GRAMMAR_SEEDS=2001-2060 takes these seeds, JALON_CLASS_KINDS=named|towns other kinds than they draw;
// JALON_CLASS_ROWS=rows.txt writes what the weights of class_weights.h are fitted from (fit_classes.py).
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <string_view>

#include "base/text_number.h"
#include "facade_kinds.h"
#include "labelled_street.h"
#include "modelling/facade/facade.h"
#include "opening_classes.h"
#include "recipe.h"
#include "seed_range.h"

namespace jalon::opening_classes_test {

using namespace jalon::test;

namespace {

constexpr double kShortRunSpacing_m = 0.03;
constexpr double kLeastArea_m2 = 0.5;  // of labelled doors and windows

ExtrusionSettings by_evidence() {
  ExtrusionSettings settings;
  settings.plan.by_evidence = true;
  return settings;
}

KindOfSeed kinds_asked_for() {
  const char* kinds = std::getenv("JALON_CLASS_KINDS");
  if (kinds == nullptr) return drawn_kind;
  return std::string_view(kinds) == "towns" ? town_kind : named_kind;
}

std::vector<KnownOpening> of_grammar(uint64_t seed, bool has_stations) {
  Task task;
  SceneSettings settings{.name = SceneName::kGrammar, .seed = seed};
  settings.grammar.kind = kinds_asked_for()(seed);
  if (!is_full()) settings.grammar.spacing_m = kShortRunSpacing_m;
  const SceneSurvey survey = scene_survey(settings);
  const FacadeTruth truth = facade_truth(settings, survey, task);
  auto cloud = std::make_shared<Cloud>(
      scan_static(build_scene(settings, task), survey.stations, survey.scanner, task));
  if (!has_stations) cloud->stations.clear();
  Segmentation planes = segment_ransac(cloud, RansacSettings{}, task);
  const FacadePlan plan = plan_model(planes, by_evidence(), task);
  return known_openings(plan, truth, "grammar " + std::to_string(seed));
}

void write_rows(const std::vector<KnownOpening>& openings) {
  const char* path = std::getenv("JALON_CLASS_ROWS");
  if (path == nullptr) return;
  std::ofstream file(path, std::ios::app);
  for (const KnownOpening& o : openings) {
    for (size_t k = 0; k < o.truth.size(); ++k) file << (k > 0 ? "," : "") << class_of(o.truth[k]);
    for (const double value : o.features) file << " " << text_of(value, 4);
    file << "\n";
  }
}

void report(const std::string& what, const std::vector<KnownOpening>& openings) {
  size_t certain = 0, right = 0;
  for (const KnownOpening& o : openings) {
    certain += o.is_certain();
    right += o.is_certain() && o.is_right();
  }
  MESSAGE("FIGURE classes, " << what << ": " << openings.size() << " openings, " << certain
                             << " with a class, " << right << " of these right; Brier score "
                             << brier_score(openings) << reliability_of(openings)
                             << confusion_of(openings));
}

/// Of a real facade whose labels tell doors and windows alone: shop fronts and gateways are labelled as doors.
std::vector<KnownOpening> of_street(const std::string& file, uint64_t seed) {
  const LabelledStreet street(file);
  if (street.cloud == nullptr) return {};
  Task task;
  RansacSettings settings;
  settings.draw.seed = seed;
  Segmentation planes = segment_ransac(street.cloud, settings, task);
  const WallAxes axes(planes.segments[0].fit.plane, planes.segments[0].fit.centroid);
  const FacadePlan plan = plan_model(planes, by_evidence(), task);
  return labelled_openings(plan, street.openings(axes, kLeastArea_m2), axes, file);
}

}  // namespace

TEST_CASE("opening_classes__agree_with_the_labels_of_real_facades") {
  // The weights are fitted with the first two as well; the third is told alone.
  std::vector<KnownOpening> streets;
  for (const char* file : {"street_1.txt", "street_3.txt"})
    for (uint64_t seed = 1; seed <= (is_full() ? 5u : 1u); ++seed)
      for (const KnownOpening& o : of_street(file, seed)) streets.push_back(o);
  if (streets.empty()) {
    if (std::getenv("CI") != nullptr) FAIL("JALON_SHARED_DATA holds no facades");
    MESSAGE("skipped: no facades in " << JALON_SHARED_DATA);
    return;
  }
  write_rows(streets);
  report("street_1 and street_3", streets);
  const std::vector<KnownOpening> building = of_street("building_2.txt", 1);
  report("building_2", building);
  CHECK(share_right(streets) >= 0.85);
}

TEST_CASE("opening_classes__are_told_with_a_calibrated_confidence") {
  const auto [first, last] = seeds_asked_for().value_or(SeedRange{1, is_full() ? 100u : 2u});
  std::vector<KnownOpening> all;
  for (uint64_t seed = first; seed <= last; ++seed) {
    const std::vector<KnownOpening> one = of_grammar(seed, seed % 2 == 0);
    write_rows(one);
    all.insert(all.end(), one.begin(), one.end());
  }
  report("grammar", all);
  CHECK(!all.empty());
}

}  // namespace jalon::opening_classes_test
