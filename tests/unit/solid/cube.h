// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "solid/surface.h"

namespace jalon::test {

/// The sides of cubes along the axes as triangles, outward.
struct Cubes {
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;

  Cubes& add(const Vec3& low, double edge) {
    const auto first = static_cast<uint32_t>(vertices.size());
    for (int i = 0; i < 8; ++i)
      vertices.push_back(low + Vec3{i & 1 ? edge : 0, i & 2 ? edge : 0, i & 4 ? edge : 0});
    constexpr std::array<std::array<uint32_t, 3>, 12> kSides{{{0, 2, 3},
                                                              {0, 3, 1},
                                                              {4, 5, 7},
                                                              {4, 7, 6},
                                                              {0, 1, 5},
                                                              {0, 5, 4},
                                                              {2, 6, 7},
                                                              {2, 7, 3},
                                                              {0, 4, 6},
                                                              {0, 6, 2},
                                                              {1, 3, 7},
                                                              {1, 7, 5}}};
    for (const auto& t : kSides) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return *this;
  }
  PartSurface surface(Task& task) const { return {vertices, triangles, task}; }
};

inline PartSurface cube_surface(const Vec3& low, double edge, Task& task) {
  return Cubes().add(low, edge).surface(task);
}

}  // namespace jalon::test
