// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model grammar_model(const SceneSettings& settings) {
  Task task;
  return build_scene(settings, task);
}

FacadeTruth grammar_truth(const SceneSettings& settings, const SceneSurvey& survey = {}) {
  Task task;
  return facade_truth(settings, survey, task);
}

}  // namespace

TEST_CASE("grammar__same_seed_same_bits_and_another_seed_another_facade") {
  for (const FacadeKind kind : all_kinds()) {
    const Model one = grammar_model(grammar_scene(kind, 1)),
                again = grammar_model(grammar_scene(kind, 1)),
                other = grammar_model(grammar_scene(kind, 2));
    CHECK(one.vertices == again.vertices);
    CHECK(one.triangles == again.triangles);
    CHECK(one.vertices != other.vertices);
    CHECK(json_of(grammar_truth(grammar_scene(kind, 1))) ==
          json_of(grammar_truth(grammar_scene(kind, 1))));
  }
}

TEST_CASE("grammar__kinds_have_the_names_of_their_parameter") {
  std::string names = name_of(FacadeKind::kAny);
  for (const FacadeKind kind : all_kinds()) names += std::string("|") + name_of(kind);
  for (const ParamRow& row : scene_rows())
    if (std::string(row.name) == "kind") CHECK(names == row.choices);
}

TEST_CASE("grammar__glass_and_occluders_are_there_where_they_are_wanted") {
  using P = std::vector<uint32_t>;
  const Model with = grammar_model(
      grammar_scene(FacadeKind::kShops, 1, {.front_m = 20, .occluders = BySeed::kYes}));
  const Model without = grammar_model(
      grammar_scene(FacadeKind::kShops, 1, {.front_m = 20, .occluders = BySeed::kNo}));
  CHECK(parts_named(with, "unwanted").size() == 1);
  CHECK(parts_named(without, "unwanted") == P{});
  CHECK(parts_named(without, "dark").size() + parts_named(with, "dark").size() > 0);
  const Model whole =
      grammar_model(grammar_scene(FacadeKind::kShops, 1, {.front_m = 20, .gaps = BySeed::kNo}));
  CHECK(parts_named(whole, "dark") == P{});
}

TEST_CASE("grammar__turns_and_shifts_walls_and_stations_together") {
  SceneSettings settings = grammar_scene(FacadeKind::kWings, 4, {.spacing_m = 0.05});
  const FacadeTruth plain = grammar_truth(settings);
  const SceneSurvey before = scene_survey(settings);
  settings.rotation_rad = 0.4;
  settings.shift_m = {1000, 2000, 30};
  const FacadeTruth moved = grammar_truth(settings);
  const SceneSurvey after = scene_survey(settings);
  Transform T;
  const double c = std::cos(0.4), s = std::sin(0.4);
  T.m = {c, -s, 0, 1000, s, c, 0, 2000, 0, 0, 1, 30};
  for (size_t w = 0; w < plain.walls.size(); ++w) {
    CHECK(norm(moved.walls[w].origin - T.point(plain.walls[w].origin)) < 1e-9);
    CHECK(norm(moved.walls[w].normal - T.direction(plain.walls[w].normal)) < 1e-12);
    // Beams of another grid: of a pier of a few hundred of them, some.
    CHECK(std::fabs(moved.walls[w].seen_share - plain.walls[w].seen_share) < 0.02);
  }
  for (size_t i = 0; i < before.stations.size(); ++i)
    CHECK(norm(after.stations[i].pose.translation() -
               T.point(before.stations[i].pose.translation())) < 1e-9);
  for (size_t i = 0; i < plain.openings.size(); ++i)
    CHECK(moved.openings[i].area_seen_share ==
          doctest::Approx(plain.openings[i].area_seen_share).epsilon(0.05).scale(0));
}

TEST_CASE("grammar__other_scenes_have_the_default_scanner_and_tell_no_walls") {
  const SceneSurvey survey = scene_survey({.name = SceneName::kBox});
  CHECK(survey.stations.empty());
  CHECK(survey.scanner.horizontal_step_rad == StaticSettings{}.horizontal_step_rad);
  Task task;
  CHECK_THROWS_WITH_AS(facade_truth({.name = SceneName::kBox}, survey, task),
                       "only scene \"grammar\" tells its walls and openings", Error);
}
