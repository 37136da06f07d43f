// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/model.h"

namespace jalon::test {

/// Two triangles a rectangle of the plane z = height; its id counts from 1.
inline void add_plate(Model& model, double x0, double x1, double y0, double y1, double height = 0) {
  const auto first = static_cast<uint32_t>(model.vertices.size());
  for (const Vec3& p : {Vec3{x0, y0, height}, {x1, y0, height}, {x1, y1, height}, {x0, y1, height}})
    model.vertices.push_back(p);
  model.triangles.push_back({first, first + 1, first + 2});
  model.triangles.push_back({first, first + 2, first + 3});
  model.triangle_faces.insert(model.triangle_faces.end(), 2,
                              static_cast<uint32_t>(model.triangles.size() / 2));
}

}  // namespace jalon::test
