// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Cell decomposition, the baseline, beside method "facade" on facades of the grammar: one table, figures alone.
// JALON_CELL_NOTES=1 tells what the baseline missed and invented.
#include <doctest/doctest.h>

#include <cstdlib>

#include "facade_truth.h"
#include "modelling/facade/facade.h"
#include "recipe.h"

namespace jalon::cell_facades_test {

using namespace jalon::test;

namespace {

constexpr uint64_t kSeeds = 24, kSeedsOfShortRun = 2;
constexpr double kCellFacadeSpacing_m = 0.04;

struct BothMethods {
  FacadeFigures evidence, cells;
};

void add_facade(uint64_t seed, BothMethods& sums) {
  Task task;
  SceneSettings settings{.name = SceneName::kGrammar, .seed = seed};
  settings.grammar.spacing_m = kCellFacadeSpacing_m;
  const SceneSurvey survey = scene_survey(settings);
  const FacadeTruth truth = facade_truth(settings, survey, task);
  const auto cloud = std::make_shared<const Cloud>(
      scan_static(build_scene(settings, task), survey.stations, survey.scanner, task));
  const Segmentation planes = segment_ransac(cloud, RansacSettings{}, task);
  const auto figures = [&](const Model& model) {
    return compare_facade(found_facade(model, truth), truth);
  };
  sums.evidence += figures(model_facade(planes, FacadeSettings{}, task));
  sums.cells += figures(model_cell_decomposition(planes, FacadeSettings{}, task));
}

BothMethods compared(const char* name, uint64_t first) {
  BothMethods sums;
  const uint64_t count = is_full() ? kSeeds : kSeedsOfShortRun;
  for (uint64_t i = 0; i < count; ++i) add_facade(first + i, sums);
  if (std::getenv("JALON_CELL_NOTES") != nullptr) MESSAGE(sums.cells.notes);
  MESSAGE("FIGURE openings of grammar facades, "
          << std::string(name) << ": " << count << " facades\n  " << heads_of_rows() << "\n  "
          << row_of("facade", sums.evidence) << "\n  " << row_of("cell_decomposition", sums.cells));
  return sums;
}

}  // namespace

TEST_CASE("cell_facades__seeds_to_develop_with_have_a_table_of_both_methods" *
          doctest::skip(std::getenv("JALON_FULL") == nullptr)) {
  const BothMethods both = compared("seeds 1-24, developed", 1);
  CHECK(both.cells.found > 0);
  CHECK(both.cells.wanted == both.evidence.wanted);
}

TEST_CASE("cell_facades__seeds_kept_for_the_report_have_a_table_of_both_methods") {
  const BothMethods both = compared("seeds 2001-2024, reported", 2001);
  CHECK(both.cells.found > 0);
  CHECK(both.cells.wanted == both.evidence.wanted);
}

}  // namespace jalon::cell_facades_test
