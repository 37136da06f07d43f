// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Volumes between models, of forms whose volumes are known.
#include <doctest/doctest.h>

#include <cmath>

#include "compare/volumes/volume.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// One face over [0, 8] x [0, 2] at these heights of its left and right end.
Model slab(double left, double right) {
  Model model;
  Face face;
  face.plane.normal = normalized({left - right, 0, 8});
  face.plane.offset = dot(face.plane.normal, Vec3{0, 0, left});
  model.add_face(face, {{{0, 0, left}, {8, 0, right}, {8, 2, right}, {0, 2, left}}});
  return model;
}

/// A closed box over [0, 2] x [0, 2] from the ground up.
Model block(double height) {
  Model model;
  for (int i = 0; i < 8; ++i)
    model.vertices.push_back({i & 1 ? 2.0 : 0, i & 2 ? 2.0 : 0, i & 4 ? height : 0});
  model.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {6, 5, 7}, {0, 1, 4}, {4, 1, 5},
                     {1, 3, 5}, {5, 3, 7}, {3, 2, 7}, {7, 2, 6}, {2, 0, 6}, {6, 0, 4}};
  model.triangle_faces.resize(12, 0);
  return model;
}

double volume_of(const Volume& volume, const char* name) {
  return volume.summary.require(name).number(0);
}

Volume between(const Model& reference, const Model& compared, const VolumeSettings& settings) {
  Task task;
  return volume_between(reference, compared, settings, task);
}

}  // namespace

TEST_CASE("model_volume__of_prisms_between_crossing_slopes_is_that_of_two_wedges") {
  VolumeSettings settings;
  settings.cell_m = 0.25;  // whole cells: their middles give a slope's volume exactly
  // The compared slope crosses the level one in its middle: two wedges of 4 x 2 m, up to 0.5 m high.
  const Volume found = between(slab(1, 1), slab(0.5, 1.5), settings);
  CHECK(volume_of(found, "cut") == doctest::Approx(2).epsilon(1e-9));
  CHECK(volume_of(found, "fill") == doctest::Approx(2).epsilon(1e-9));
  CHECK(std::fabs(volume_of(found, "net")) < 1e-9);
  CHECK(volume_of(found, "sigma") == 0);
  CHECK(std::isnan(volume_of(found, "compared_volume")));
  // Told along -z the wedges change their names.
  settings.direction = {0, 0, -3};
  const Volume turned = between(slab(1, 1), slab(0.5, 1.25), settings);
  CHECK(volume_of(turned, "net") == doctest::Approx(8 * 2 * 0.125).epsilon(1e-9));
  CHECK(volume_of(turned, "cells") >= 8 * 4 * 2 * 4);
}

TEST_CASE("model_volume__prisms_stand_on_the_topmost_surface_and_by_default_are_a_500th_wide") {
  VolumeSettings settings;
  settings.surfaces = VolumeSettings::Surfaces::kPrisms;
  settings.cell_m = 0.5;
  const Volume tops = between(block(1), block(1.75), settings);
  CHECK(volume_of(tops, "fill") == doctest::Approx(2 * 2 * 0.75).epsilon(1e-9));
  CHECK(volume_of(tops, "reference_volume") == doctest::Approx(4).epsilon(1e-12));
  settings.cell_m = 0;
  CHECK(volume_of(between(slab(0, 0), slab(1, 1), settings), "cell") ==
        doctest::Approx(8.0 / 500).epsilon(1e-12).scale(0));
  // Cells that only one of them covers are told and have no volume.
  settings.cell_m = 0.5;
  const Volume part = between(slab(0, 0), block(1), settings);
  CHECK(volume_of(part, "fill") == doctest::Approx(2 * 2 * 1).epsilon(1e-9));
  CHECK(volume_of(part, "without_compared") >= 12 * 4);
}

TEST_CASE("model_volume__closed_models_differ_by_what_they_enclose_and_open_ones_are_named") {
  VolumeSettings settings;
  settings.surfaces = VolumeSettings::Surfaces::kClosed;
  CHECK(volume_of(between(block(3), block(1), settings), "net") ==
        doctest::Approx(-8).epsilon(1e-12));
  Model open = block(1), turned = block(1);
  open.triangles.resize(11);
  open.triangle_faces.resize(11);
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  CHECK(status_of([&] { between(open, block(1), settings); }) == Status::kDegenerate);
  CHECK_THROWS_WITH_AS(between(open, block(1), settings),
                       doctest::Contains("the reference model is not closed: 3 sides"), Error);
  CHECK_THROWS_WITH_AS(
      between(block(1), turned, settings),
      doctest::Contains("the compared model is not closed: 0 sides at a border, 3"), Error);
  // Left to itself it takes prisms then.
  settings.surfaces = VolumeSettings::Surfaces::kAutomatic;
  settings.cell_m = 0.1;
  CHECK(volume_of(between(open, block(2), settings), "fill") == doctest::Approx(4).epsilon(1e-9));
}
