// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/pulse.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/scan/plates.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// A pulse from the origin upward (or aslant) through plates above it.
struct Bench {
  explicit Bench(Model plates, const StaticSettings& s) : model(std::move(plates)), settings(s) {
    tree = TriangleTree::build(model.vertices, model.triangles, task);
  }
  bool send(const Vec3& direction, Echo& echo, uint64_t stream = 0, const Vec3& eye = {}) {
    const Surfaces surfaces(model, settings.surfaces, settings.seed, task);
    return PulseCaster(settings, *tree, surfaces)
        .send(eye - tree->origin() + tree->origin(), direction, RandomStream(1, stream), echo);
  }
  Model model;
  StaticSettings settings;
  Task task;
  std::shared_ptr<const TriangleTree> tree;
};

/// The plane z = 10 for x < 0 and z = 10 + step for x > 0, ids 1 and 2.
Model stair(double step) {
  Model model;
  add_plate(model, -5, 0, -5, 5, 10);
  add_plate(model, 0, 5, -5, 5, 10 + step);
  return model;
}

StaticSettings beam(double diameter_m, double resolution_m = 0.3) {
  StaticSettings s;
  s.beam_diameter_m = diameter_m;
  s.range_resolution_m = resolution_m;
  return s;
}

}  // namespace

TEST_CASE("pulse__as_a_line_returns_the_range_to_the_first_surface") {
  Model model;
  add_plate(model, -5, 5, -5, 5, 10);
  add_plate(model, -5, 5, -5, 5, 20);
  Bench bench(model, {});
  Echo echo;
  REQUIRE(bench.send({0.1, 0.2, 0.97467943448089633}, echo));
  CHECK(echo.range == doctest::Approx(10 / 0.97467943448089633).epsilon(1e-12));
  CHECK(bench.model.triangle_faces[echo.triangle] == 1);
  CHECK_FALSE(echo.is_mixed);
  CHECK_FALSE(bench.send({0, 0, -1}, echo));
}

TEST_CASE("pulse__as_a_beam_on_one_plane_is_its_axis") {
  Bench bench(stair(0.1), beam(0.02));
  Echo echo;
  REQUIRE(bench.send({0, 0, 1}, echo, 0, {-1, 0, 0}));
  CHECK(echo.range == 10);
  CHECK_FALSE(echo.is_mixed);
}

TEST_CASE("pulse__at_the_middle_of_a_step_is_mixed_halfway_between") {
  Bench bench(stair(0.1), beam(0.02));
  Echo echo;
  // The edge goes through the axis; all sub-rays but the axis lie evenly on either side of it.
  REQUIRE(bench.send({0, 0, 1}, echo, 0, {0, 0, 0}));
  CHECK(echo.is_mixed);
  CHECK(echo.range > 10);
  CHECK(echo.range < 10.1);
  CHECK(std::abs(echo.range - 10.05) <=
        0.1 / 19 / 2 + 1e-9);  // half the weight of one of 19 sub-rays
}

TEST_CASE("pulse__on_surfaces_further_apart_than_the_resolution_returns_one_of_them") {
  StaticSettings settings = beam(0.02, 0.05);
  Echo echo;
  for (const auto& [which, range] :
       {std::pair{StaticSettings::Echo::kFirst, 10.0}, {StaticSettings::Echo::kLast, 10.1}}) {
    settings.echo = which;
    Bench bench(stair(0.1), settings);
    REQUIRE(bench.send({0, 0, 1}, echo, 0, {0.001, 0, 0}));
    CHECK(echo.range == doctest::Approx(range).epsilon(1e-12));
    CHECK_FALSE(echo.is_mixed);
  }
  // Three quarters of the beam's width lie on the farther one: it is the strongest.
  settings.echo = StaticSettings::Echo::kStrongest;
  Bench bench(stair(0.1), settings);
  REQUIRE(bench.send({0, 0, 1}, echo, 0, {0.005, 0, 0}));
  CHECK(echo.range == doctest::Approx(10.1).epsilon(1e-12));
}

TEST_CASE("pulse__goes_on_behind_glass_that_returns_nothing") {
  Model model = stair(0);
  add_plate(model, -5, 5, -5, 5, 4);
  model.parts = {{"w", "window"}, {"p", "pane", 0}, {"wall", "wall"}};
  for (const uint32_t id : {1u, 2u, 3u}) {
    Face face;
    face.id = id;
    face.part = id == 3 ? 1 : 2;
    face.plane = {{0, 0, 1}, id == 3 ? 4.0 : 10.0};
    face.area_m2 = 50;
    model.add_face(face, {{{-5, -5, id == 3 ? 4.0 : 10.0}, {5, -5, 4}, {5, 5, 4}}});
  }
  StaticSettings settings;
  settings.surfaces.glass_return_min = settings.surfaces.glass_return_max = 0;
  Bench through(model, settings);
  Echo echo;
  REQUIRE(through.send({0, 0, 1}, echo, 5, {-1, 0.3, 0}));
  CHECK(echo.range == 10);
  Bench solid(model, {});
  REQUIRE(solid.send({0, 0, 1}, echo, 5, {-1, 0.3, 0}));
  CHECK(echo.range == 4);
}
