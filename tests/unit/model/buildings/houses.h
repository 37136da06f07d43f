// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "model/model.h"

namespace jalon {

/// A house on a rectangle, its street side from corner a along "way" (unit, level), depth to the left
/// of the way; with gables over the sides where gable_m > 0. Faces, or triangles alone.
struct House {
  Vec3 corner;
  Vec3 way{1, 0, 0};
  double width_m = 10, depth_m = 8, height_m = 6, gable_m = 0;
};

inline void add_wall(Model& model, const std::vector<Vec3>& corners, uint32_t part, bool as_faces) {
  if (as_faces) {
    Face face;
    face.part = part;
    model.add_face(face, {corners});
    return;
  }
  const auto first = static_cast<uint32_t>(model.vertices.size());
  for (const Vec3& p : corners) model.vertices.push_back(p);
  for (uint32_t k = 2; k < corners.size(); ++k) {
    model.triangles.push_back({first, first + k - 1, first + k});
    model.triangle_faces.push_back(0);
  }
}

/// Outward walls, a flat roof and a floor.
inline void add_house(Model& model, const House& h, const std::string& name, bool as_faces = true) {
  Part part;
  part.name = name;
  part.part_class = as_faces ? "building" : "mesh";
  model.parts.push_back(part);
  const auto number = static_cast<uint32_t>(model.parts.size() - 1);
  const Vec3 left{-h.way.y, h.way.x, 0}, up{0, 0, h.height_m};
  const Vec3 a = h.corner, b = a + h.way * h.width_m, c = b + left * h.depth_m,
             d = a + left * h.depth_m;
  const Vec3 ridge{0, 0, h.gable_m};
  add_wall(model, {a, b, b + up, a + up}, number, as_faces);
  add_wall(model, {c, d, d + up, c + up}, number, as_faces);
  if (h.gable_m > 0) {
    add_wall(model, {b, c, c + up, (b + c) * 0.5 + up + ridge, b + up}, number, as_faces);
    add_wall(model, {d, a, a + up, (d + a) * 0.5 + up + ridge, d + up}, number, as_faces);
  } else {
    add_wall(model, {b, c, c + up, b + up}, number, as_faces);
    add_wall(model, {d, a, a + up, d + up}, number, as_faces);
    add_wall(model, {a + up, b + up, c + up, d + up}, number, as_faces);
  }
  add_wall(model, {a, d, c, b}, number, as_faces);
}

}  // namespace jalon
