// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/model.h"

namespace jalon::test {

/// Part 0: a plate of 4 x 3 m in the plane z = 0 with an opening of 1 x 2 m, 10 m2; part 1: an upright
/// one of 1 x 5 m in the plane x = 6; of neither: triangle 1 of the mesh, 1.5 m2 in the plane z = 7.
/// Triangle 0 stands for face 0.
inline Model plates() {
  Model model;
  model.parts = {Part{"lying", "plate"}, Part{"upright", "plate"}};
  Face face;
  face.id = 500;
  face.part = 0;
  face.plane = {{0, 0, 1}, 0};
  model.add_face(face, {{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}},
                        {{2, 0.5, 0}, {2, 2.5, 0}, {3, 2.5, 0}, {3, 0.5, 0}}});
  face.id = 501;
  face.part = 1;
  face.plane = {{1, 0, 0}, 6};
  model.add_face(face, {{{6, 0, 0}, {6, 1, 0}, {6, 1, 5}, {6, 0, 5}}});
  const auto first = static_cast<uint32_t>(model.vertices.size());
  model.vertices.insert(model.vertices.end(), {{0, 0, 7}, {3, 0, 7}, {0, 1, 7}});
  model.triangles = {{0, 1, 2}, {first, first + 1, first + 2}};
  model.triangle_faces = {500, 77};
  return model;
}

/// Is p on the plate beside its opening, in plan?
inline bool is_on_lying_plate(const Vec3& p) {
  return p.x >= 0 && p.x <= 4 && p.y >= 0 && p.y <= 3 &&
         !(p.x > 2 && p.x < 3 && p.y > 0.5 && p.y < 2.5);
}

}  // namespace jalon::test
