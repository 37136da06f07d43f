// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Classes of changes and their confidence on kinds of scenes: the developed ones, on which the weights of
// confidence_weights.h were fitted (fit_changes.py), and others that figures are reported on. JALON_CHANGE_SEEDS=1-20
// takes these seeds; JALON_CHANGE_ROWS=rows.txt writes what the weights are fitted from.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

#include "base/text_number.h"
#include "change_kinds_developed.h"
#include "change_kinds_reported.h"
#include "change_statements.h"
#include "recipe.h"
#include "seed_range.h"

using namespace jalon;
using namespace jalon::test;

namespace {

void write_rows(const std::vector<ScoredRun>& runs) {
  const char* path = std::getenv("JALON_CHANGE_ROWS");
  if (path == nullptr) return;
  std::ofstream file(path, std::ios::app);
  for (const ScoredRun& run : runs)
    for (const auto* list : {&run.statements, &run.untold})
      for (const Statement& s : *list) {
        file << run.seed << " " << static_cast<int>(happened(s.change_class)) << " " << s.is_right;
        for (const double value : s.features) file << " " << text_of(value, 5);
        file << " # " << run.kind << " " << run.threshold_m << " " << run.has_stations << " "
             << s.confidence << "\n";
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

TEST_CASE("change_confidence__of_developed_kinds") {
  const SeedRange seeds = seeds_asked_for("JALON_CHANGE_SEEDS")
                              .value_or(is_full() ? SeedRange{1, 20} : SeedRange{1, 1});
  std::vector<ScoredRun> runs;
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    for (const SceneKind& kind : kDevelopedKinds) if (getenv("KIND") == nullptr || std::string(kind.name) == getenv("KIND")) add_kind(kind, seed, runs);
    if (!is_full()) continue;
    for (const bool is_unchanged : {false, true}) {
      const auto made = scored_runs(is_unchanged ? "unchanged street" : "street",
                                    known_street(seed, is_unchanged), seed);
      runs.insert(runs.end(), made.begin(), made.end());
    }
  }
  write_rows(runs);
  told("developed kinds", runs);
}

TEST_CASE("change_confidence__of_kinds_that_no_constant_was_set_on") {
  const SeedRange seeds = seeds_asked_for("JALON_CHANGE_SEEDS")
                              .value_or(is_full() ? SeedRange{201, 240} : SeedRange{201, 201});
  std::vector<ScoredRun> runs;
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed)
    for (const SceneKind& kind : kReportedKinds) add_kind(kind, seed, runs);
  write_rows(runs);
  told("reported kinds", runs);
}
