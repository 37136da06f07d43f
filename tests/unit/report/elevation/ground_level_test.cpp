// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The level that heights count from, under a wall of 6 m whose foot is known.
#include "report/elevation/ground_level.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

// A square wall of 6 m from this height on, and the part of a ground.
Model wall_from(double z) {
  Model m;
  m.parts = {named_facade::part("", part_class::kWall, kNoParent),
             named_facade::part("", part_class::kGround, kNoParent)};
  named_facade::add(m, 0, {{0, -1, 0}, 0}, {{{0, 0, z}, {6, 0, z}, {6, 0, z + 6}, {0, 0, z + 6}}},
                    {}, 36, 1);
  return m;
}

double level_of(const Model& m) {
  Task task;
  const ElevationView view;
  const ElevationFaces faces = elevation_faces(m, view, {}, task);
  CHECK(faces.ground_m == ground_level(faces, m, view));
  return faces.ground_m;
}

}  // namespace

TEST_CASE("ground_level__of_a_slope_is_where_it_meets_the_wall") {
  for (const double up : {0.0, 100.0, -100.0})
    for (const double down : {-1.0, 0.5, 2.0}) {
      CAPTURE(up);
      CAPTURE(down);
      const double z = up + 2;
      Model m = wall_from(z);
      // Down over 8 m to the street; the same, and down by 0.6 m along the wall's 6 m.
      const Vec3 across = normalized({0, -down / 8, 1});
      named_facade::add(m, 1, {across, dot(across, {0, 0, z})},
                        {{{0, 0, z}, {0, -8, z - down}, {6, -8, z - down}, {6, 0, z}}}, {}, 48, 2);
      CHECK(level_of(m) == doctest::Approx(z).epsilon(1e-12));
      Model along = m;
      const Vec3 both = normalized({0.1, -down / 8, 1});
      along.faces[1].plane = {both, dot(both, {0, 0, z})};
      for (uint64_t i = 0; i < 4; ++i) {
        Vec3& p = along.vertices[along.corners[along.rings[1].first + i]];
        p.z -= 0.1 * p.x;
      }
      CHECK(level_of(along) == doctest::Approx(z - 0.6).epsilon(1e-12));
      // Seen as a line: its mean height.
      m.faces[1].face_class = static_cast<uint8_t>(Orientation::kHorizontal);
      CHECK(level_of(m) == doctest::Approx(z - down / 2).epsilon(1e-12));
    }
}

TEST_CASE("ground_level__of_a_slope_that_ends_before_the_wall_is_no_higher_than_it_is_itself") {
  Model m = wall_from(0);
  const Vec3 steep = normalized({0, -0.5, 1});
  named_facade::add(m, 1, {steep, dot(steep, {0, -4, 0.2})},
                    {{{0, -4, 0.2}, {0, -6, -0.8}, {6, -6, -0.8}, {6, -4, 0.2}}}, {}, 12, 2);
  CHECK(level_of(m) == doctest::Approx(0.2));
}
