// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/surfaces.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "unit/scan/plates.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Plates one above the other, a face each of a part of these classes; parents as indices of parts.
Model plates_of(const std::vector<Part>& parts) {
  Model model;
  model.parts = parts;
  for (uint32_t p = 0; p < parts.size(); ++p) {
    const double z = p;
    add_plate(model, 0, 2, 0, 1, z);
    Face face;
    face.part = p;
    face.id = p + 1;
    face.plane = {{0, 0, 1}, z};
    face.area_m2 = 2;
    model.add_face(face, {{{0, 0, z}, {2, 0, z}, {2, 1, z}, {0, 1, z}}});
  }
  return model;
}

Part part(const char* part_class, uint64_t parent = kNoParent) {
  return {part_class, part_class, parent};
}

Surfaces surfaces_of(const Model& model, double least, double most, uint64_t seed = 1) {
  Task task;
  ScannedSurfaceSettings settings;
  settings.glass_return_min = least;
  settings.glass_return_max = most;
  return {model, settings, seed, task};
}

}  // namespace

TEST_CASE("surfaces__know_faces_segments_normals_and_cosines_of_their_triangles") {
  Model model = plates_of({part("wall"), part("wall")});
  model.vertices.push_back({9, 9, 9});
  const auto last = static_cast<uint32_t>(model.vertices.size() - 1);
  model.triangles.push_back({last, last, last});
  model.triangle_faces.push_back(1);
  const Surfaces surfaces = surfaces_of(model, 1, 1);
  CHECK(surfaces.face(0) == 1);
  CHECK(surfaces.face(3) == 2);
  CHECK(surfaces.segment(0) == surfaces.segment(1));
  CHECK(surfaces.segment(0) != surfaces.segment(2));
  CHECK(surfaces.normal(0) == Vec3{0, 0, 1});
  CHECK(surfaces.normal(4) == Vec3{});
  // 60 degrees from the normal, from either side, whatever the length.
  const Vec3 d{std::sqrt(3.0), 0, 1};
  CHECK(surfaces.cosine(0, d) == doctest::Approx(0.5));
  CHECK(surfaces.cosine(0, d * -7) == doctest::Approx(0.5));
  CHECK(surfaces.cosine(0, {0, 0, -3}) == 1);
}

TEST_CASE("surfaces__of_glass_and_panes_of_windows_return_a_share_and_all_else_everything") {
  const Model model = plates_of({part("window"), part("pane", 0), part("door"), part("pane", 2),
                                 part("glass"), part("wall")});
  const Surfaces surfaces = surfaces_of(model, 0.2, 0.4);
  for (uint32_t t = 0; t < 12; ++t) {
    const bool is_glass = t / 2 == 1 || t / 2 == 4;
    if (is_glass) {
      CHECK(surfaces.returned(t) >= 0.2);
      CHECK(surfaces.returned(t) <= 0.4);
      CHECK(surfaces.returned(t) == surfaces.returned(t ^ 1u));  // one pane, one share
    } else {
      CHECK(surfaces.returned(t) == 1);
    }
  }
  CHECK(surfaces.returned(2) != surfaces.returned(8));
  CHECK(surfaces.returned(2) != surfaces_of(model, 0.2, 0.4, 2).returned(2));
}

TEST_CASE("surfaces__without_panes_or_with_panes_that_return_all_have_no_glass") {
  const Model wall = plates_of({part("wall")}), pane = plates_of({part("glass")});
  CHECK(surfaces_of(wall, 0, 0).returned(0) == 1);
  CHECK(surfaces_of(pane, 1, 1).returned(0) == 1);
  CHECK(surfaces_of(pane, 0, 0).returned(0) == 0);
  CHECK_THROWS_AS(surfaces_of(pane, 0.5, 0.4), Error);
}

TEST_CASE("surfaces__that_are_dark_return_nothing_and_let_nothing_through") {
  const Model model = plates_of({part("wall"), part("dark"), part("glass")});
  for (const double least : {0.0, 1.0}) {
    const Surfaces surfaces = surfaces_of(model, least, least);
    CHECK(surfaces.returned(0) == 1);
    CHECK(surfaces.returned(2) == 0);
    CHECK_FALSE(surfaces.lets_through(2));
    CHECK(surfaces.returned(4) == least);
    CHECK(surfaces.lets_through(4));
  }
}
