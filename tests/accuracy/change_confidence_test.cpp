// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Classes of changes and their confidence on kinds of scenes: the developed ones, on which the weights of
// confidence_weights.h were fitted (fit_changes.py), and others that figures are reported on. JALON_CHANGE_SEEDS=1-20
// takes these seeds; JALON_CHANGE_ROWS=rows.txt writes what the weights are fitted from.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

#include "base/text_number.h"
#include "change_kinds_deep.h"
#include "change_kinds_developed.h"
#include "change_kinds_reported.h"
#include "change_statements.h"
#include "recipe.h"
#include "seed_range.h"

namespace jalon::change_confidence_test {

using namespace jalon::test;

namespace {

void write_rows(const std::vector<ScoredRun>& runs) {
  const char* path = std::getenv("JALON_CHANGE_ROWS");
  if (path == nullptr) return;
  std::ofstream file(path, std::ios::app);
  for (const ScoredRun& run : runs)
    for (const auto* list : {&run.statements, &run.untold, &run.weighed})
      for (const Statement& s : *list) {
        file << run.seed << " " << static_cast<int>(happened(s.change_class)) << " "
             << s.is_one_thing;
        for (const double value : s.features) file << " " << text_of(value, 5);
        file << " # " << run.kind << " " << run.threshold_m << " " << run.has_stations << " "
             << s.confidence << " " << s.is_changed << " " << s.is_right << "\n";
      }
}

void add_kind(const SceneKind& kind, uint64_t seed, std::vector<ScoredRun>& runs) {
  const auto made = scored_runs(kind.name, known_epochs(kind.make(seed), seed), seed);
  runs.insert(runs.end(), made.begin(), made.end());
}

ConfidenceFigures told(const char* name, const std::vector<ScoredRun>& runs) {
  const ConfidenceFigures all = figures_of(runs);
  MESSAGE("FIGURE changes, " << std::string(name) << ": " << text_of(all) << confusion_of(runs));
  for (const bool has_stations : {true, false}) {
    std::vector<ScoredRun> part;
    for (const ScoredRun& run : runs)
      if (run.has_stations == has_stations) part.push_back(run);
    MESSAGE("FIGURE   stations " << std::string(has_stations ? "known" : "unknown") << ": "
                                 << text_of(figures_of(part)));
  }
  return all;
}

}  // namespace

namespace {

// In short: things that were pushed, that came and went, walls that gave way and a scene that did not change; of the
// reported ones what lies in shadows.
bool is_in_short_run(const SceneKind& kind) {
  const std::string name = kind.name;
  return name == "boxes pushed" || name == "boxes come and go" || name == "walls give way" ||
         name == "unchanged yard" || name == "shadowed neighbours" || name == "heap and board" ||
         name == "deep dents";
}

// JALON_CHANGE_KIND=box takes the kinds whose names hold it, -box the others.
bool is_asked_for(const std::string& name) {
  const char* asked = std::getenv("JALON_CHANGE_KIND");
  if (asked == nullptr) return true;
  const std::string part = asked;
  return part.starts_with("-") ? name.find(part.substr(1)) == std::string::npos
                               : name.find(part) != std::string::npos;
}

template <size_t kKinds>
std::vector<ScoredRun> runs_of(const std::array<SceneKind, kKinds>& kinds, const SeedRange& full) {
  const SeedRange seeds = seeds_asked_for("JALON_CHANGE_SEEDS")
                              .value_or(is_full() ? full : SeedRange{full.first, full.first});
  std::vector<ScoredRun> runs;
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed)
    for (const SceneKind& kind : kinds)
      if (is_asked_for(kind.name) && (is_full() || is_in_short_run(kind)))
        add_kind(kind, seed, runs);
  return runs;
}

}  // namespace

TEST_CASE("change_confidence__of_developed_kinds") {
  constexpr SeedRange kSeeds{1, 20};
  std::vector<ScoredRun> runs = runs_of(kDevelopedChanges, kSeeds);
  const SeedRange seeds = seeds_asked_for("JALON_CHANGE_SEEDS").value_or(kSeeds);
  for (uint64_t seed = seeds.first; is_full() && seed <= seeds.last; ++seed)
    for (const bool is_unchanged : {false, true}) {
      if (!is_asked_for("street")) continue;
      const auto made = scored_runs(is_unchanged ? "unchanged street" : "street",
                                    known_street(seed, is_unchanged), seed);
      runs.insert(runs.end(), made.begin(), made.end());
    }
  write_rows(runs);
  if (is_full()) {
    const std::vector<ScoredRun> deep = runs_of(kDeepDeformations, kSeeds);
    write_rows(deep);
    if (!deep.empty()) told("deformation without overlap, developed seeds", deep);
  }
  const std::vector<ScoredRun> fallen = runs_of(kFallenThings, kSeeds);
  write_rows(fallen);
  if (!fallen.empty()) told("things that fell over", fallen);
  const ConfidenceFigures all = told("developed kinds", runs);
  CHECK(all.class_right() >= 0.9);
  CHECK(all.sure_share() >= 0.9);
  CHECK(all.clean() >= 0.95);
}

TEST_CASE("change_confidence__of_kinds_that_no_constant_was_set_on") {
  const std::vector<ScoredRun> runs = runs_of(kReportedChanges, {298, 337});
  write_rows(runs);
  const ConfidenceFigures all = told("reported kinds", runs);
  CHECK(all.sure_share() >= 0.9);
}

// Half of the seeds: the other half, from 1 on, was developed on.
TEST_CASE("change_confidence__of_deformation_without_overlap") {
  const std::vector<ScoredRun> runs = runs_of(kDeepDeformations, {338, 357});
  write_rows(runs);
  const ConfidenceFigures all = told("deformation without overlap", runs);
  CHECK(all.sure_share() >= 0.9);
}

// As one change, of what lay there and what lies there now, ten of these went unsaid.
TEST_CASE("change_confidence__one_thing_in_the_place_of_another_is_two_changes") {
  constexpr uint64_t kSeed = 14;
  const ConfidenceFigures all =
      figures_of(scored_runs("exchanged", known_epochs(exchanged(kSeed), kSeed), kSeed));
  CHECK(all.planted == 28);
  CHECK(all.found == all.planted);
}

}  // namespace jalon::change_confidence_test
