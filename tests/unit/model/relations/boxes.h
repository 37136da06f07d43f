// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/model.h"

namespace jalon::test {

/// A flat polygon of a model under a part of its own; rings[0] is the outline, against the normal anticlockwise.
inline uint32_t add_flat(Model& model, const std::vector<std::vector<Vec3>>& rings,
                         const char* part_class = "element") {
  const auto part = static_cast<uint32_t>(model.parts.size());
  model.parts.push_back({part_class, part_class, kNoParent});
  Face face;
  face.part = part;
  const std::vector<Vec3>& p = rings[0];
  face.plane.normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
  face.plane.offset = dot(face.plane.normal, p[0]);
  face.area_m2 = norm(cross(p[1] - p[0], p[2] - p[0]));
  model.add_face(face, rings);
  return part;
}

/// An upright rectangle that looks along -Y, as a facade does.
inline std::vector<Vec3> upright(double left, double bottom, double right, double top,
                                 double y = 0) {
  return {{left, y, bottom}, {right, y, bottom}, {right, y, top}, {left, y, top}};
}

/// A closed box as a solid, moved and turned by T.
inline void add_box(Model& model, const Vec3& low, const Vec3& high, const Transform& T = {}) {
  const auto at = [&](int corner) {
    return T.point(
        {corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z});
  };
  constexpr int kSides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  const auto first = model.faces.size();
  for (const auto& side : kSides)
    add_flat(model, {{at(side[0]), at(side[1]), at(side[2]), at(side[3])}});
  model.solids.push_back({static_cast<uint32_t>(model.parts.size() - 6), first, 6});
}

}  // namespace jalon::test
