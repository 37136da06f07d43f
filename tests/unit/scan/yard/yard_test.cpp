// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/yard/yard.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "unit/scan/yard/yards.h"

using namespace jalon;
using namespace jalon::test;

namespace {

SceneSettings yard_settings(YardZone zone, uint64_t seed = 1) {
  SceneSettings settings;
  settings.name = SceneName::kYard;
  settings.yard.zone = zone;
  settings.seed = seed;
  return settings;
}

}  // namespace

TEST_CASE("yard__every_face_has_its_class_and_stands_where_the_survey_says") {
  const SceneSettings settings = yard_settings(YardZone::kFacades);
  Task task;
  const Model model = build_scene(settings, task);
  validate(model);
  const YardTruth truth = yard_truth(settings);
  std::array<double, 5> area{};
  for (const Face& face : model.faces) {
    REQUIRE(face.id <= truth.face_classes.size());
    area[truth.face_classes[face.id - 1]] += face.area_m2;
    const Vec3& p = model.vertices[model.corners[model.rings[face.first_ring].first]];
    REQUIRE(std::fabs(p.x - 734575) < 80);
    REQUIRE(std::fabs(p.y - 642205) < 80);
  }
  CHECK(area[1] > 250);  // three facades of 31 x 3 m and a gable, corrugated
  CHECK(area[1] < 400);
  CHECK(area[2] > 5);
  CHECK(area[3] > 50);  // with their panes
  // Half of six pipes, chords of 15 degrees.
  const double round =
      6 * std::acos(-1.0) * yard::kGutterRadius_m * (yard::kGutterTop_m - yard::kGround_m);
  CHECK(area[4] == doctest::Approx(round).epsilon(0.01).scale(0));
}

TEST_CASE("yard__above_the_walls_is_an_empty_band") {
  Task task;
  const Model model = build_scene(yard_settings(YardZone::kComplete), task);
  for (const auto& t : model.triangles)
    for (const uint32_t v : t) {
      const double z = model.vertices[v].z;
      CHECK((z < 249.744 || z > 250.042));
    }
}

TEST_CASE("yard__the_seed_decides_and_the_same_seed_gives_the_same") {
  const auto one = yard_truth(yard_settings(YardZone::kComplete)),
             again = yard_truth(yard_settings(YardZone::kComplete)),
             other = yard_truth(yard_settings(YardZone::kComplete, 2));
  CHECK(one.survey == again.survey);
  CHECK(one.survey != other.survey);
  CHECK(one.targets == other.targets);
  const auto json = nlohmann::json::parse(json_of(one, yard_settings(YardZone::kComplete)));
  CHECK(json["survey"].size() == one.survey.size());
  CHECK(json["face_classes"].size() == one.face_classes.size());
  CHECK(json["classes"][4]["name"] == "gutter");
}
