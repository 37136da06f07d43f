// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Points on the surfaces of a model: where they lie, how many, how even.
#include "compare/distance/model_sample.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/cloud/clouds.h"
#include "unit/compare/distance/plates.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Cloud sampled(const Model& model, uint64_t points, uint64_t seed = 1, unsigned thread_count = 2) {
  ModelSampleSettings settings;
  settings.points = points;
  settings.seed = seed;
  Task task(threads(thread_count));
  return sample_model(model, settings, task);
}

// All surfaces of plates(): 10, 5 and 1.5 m2.
constexpr double kArea_m2 = 16.5;

}  // namespace

TEST_CASE("sample_model__lies_on_the_surfaces_not_in_openings_and_names_them") {
  Model model = plates();
  model.crs = "EPSG:2154";
  const Cloud cloud = sampled(model, 5000);
  REQUIRE(cloud.size() == 5000);
  CHECK(cloud.crs == "EPSG:2154");
  const auto number = [&](const char* name, size_t i, uint32_t component = 0) {
    return cloud.fields.require(name).number(i, component);
  };
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = cloud.point(i);
    if (p.z == 7) {
      REQUIRE(number("face", i) == kNoFace);
      REQUIRE(number("triangle", i) == 1);
      REQUIRE(number("part", i) == kNoPart);
      REQUIRE(p.x / 3 + p.y <= 1 + 1e-15);
      continue;
    }
    const bool is_upright = p.x == 6;
    REQUIRE((is_upright || (p.z == 0 && is_on_lying_plate(p))));
    REQUIRE(number("face", i) == (is_upright ? 1 : 0));
    REQUIRE(number("part", i) == (is_upright ? 1 : 0));
    REQUIRE(number("triangle", i) == kNoFace);
    REQUIRE(number("normal", i, 0) == (is_upright ? 1 : 0));
    REQUIRE(number("normal", i, 2) == (is_upright ? 0 : 1));
  }
}

TEST_CASE("sample_model__is_uniform_by_area_over_faces_and_within_them") {
  constexpr size_t kPoints = 6600;  // 400 a m2
  const Cloud cloud = sampled(plates(), kPoints, 3);
  double upright = 0, loose = 0, low = 0, near = 0;
  for (size_t i = 0; i < kPoints; ++i) {
    const Vec3 p = cloud.point(i);
    loose += p.z == 7 ? 1 : 0;
    near += p.z == 7 && p.x <= 1.5 && p.y <= 0.5 ? 1 : 0;  // half of that triangle
    upright += p.x == 6 ? 1 : 0;
    low += p.x == 6 && p.z < 2 ? 1 : 0;
  }
  // One of each equal part of the area: every surface has its share to within a point at either end.
  CHECK(std::abs(upright - 5 * 400) <= 2);
  CHECK(std::abs(loose - 1.5 * 400) <= 2);
  // Within a face the scatter is at most that of 2000 and 600 free draws: 22 and 12; four times.
  CHECK(std::abs(low - 2 * 400) < 88);
  CHECK(std::abs(near - 300) < 49);
}

TEST_CASE("sample_model__by_spacing_gives_a_point_a_square_and_a_seed_the_same_bits") {
  ModelSampleSettings settings;
  settings.spacing_m = 0.25;
  Task task;
  CHECK(sample_model(plates(), settings, task).size() ==
        static_cast<size_t>(std::ceil(kArea_m2 * 16)));
  const Cloud one = sampled(plates(), 1000, 8, 1);
  CHECK(same_bits(one, sampled(plates(), 1000, 8, 3)));
  CHECK_FALSE(same_bits(one, sampled(plates(), 1000, 9)));
  ParamSet given("model_sample", model_sample_rows());
  given.set_number("spacing_m", 0.25);
  CHECK(same_bits(sample_model(plates(), settings_from<ModelSampleSettings>(given), task),
                  sample_model(plates(), settings, task)));
}

TEST_CASE("sample_model__refuses_what_has_no_surface_no_area_or_too_many_points") {
  CHECK(refuses([] { sampled(Model{}, 10); }, Status::kInsufficientData, "no faces"));
  Model thin;
  thin.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  thin.triangles = {{0, 1, 2}};
  thin.triangle_faces = {0};
  CHECK(refuses([&] { sampled(thin, 10); }, Status::kDegenerate, "no area"));
  ModelSampleSettings fine;
  fine.spacing_m = 1e-5;  // 1.65e11 points
  Task task;
  CHECK(refuses([&] { sample_model(plates(), fine, task); }, Status::kLimit, "the spacing"));
}
