// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/shared_faces.h"

#include <doctest/doctest.h>

using namespace jalon;

TEST_CASE("shared_faces__equal_corners_are_one_vertex_and_holes_take_area_off") {
  const Vec3 origin{734500, 642100, 200};
  SharedFaces faces(origin);
  const uint32_t wall = faces.part("wall", "wall", kNoParent),
                 window = faces.part("window", "window", wall);
  faces.add(wall, 4, {{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}},
            {{{{1, 0, 1}, {1, 0, 2}, {3, 0, 2}, {3, 0, 1}}, window}});
  faces.add(window, 5, {{1, 0, 1}, {3, 0, 1}, {3, 0, 2}, {1, 0, 2}});
  faces.add(window, 6, {{1, 0, 1}, {3, 0, 1}});             // two corners
  faces.add(window, 6, {{1, 0, 1}, {2, 0, 1}, {3, 0, 1}});  // on one line
  CHECK(faces.size() == 2);
  faces.close(wall, 0);
  const Model model = faces.take("EPSG:3812");
  validate(model);
  CHECK(model.vertices.size() == 8);
  CHECK(model.faces[0].area_m2 == doctest::Approx(12 - 2));
  CHECK(model.rings[1].part == window);
  CHECK(model.faces[0].plane.normal == Vec3{0, -1, 0});
  CHECK(model.faces[0].plane.distance(origin + Vec3{2, -1, 0}) == doctest::Approx(1));
  CHECK(model.solids[0].face_count == 2);
  CHECK(model.crs.str() == "EPSG:3812");
}
