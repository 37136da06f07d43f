// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/section_cut.h"

#include <algorithm>

namespace jalon {

std::vector<std::array<Vec2, 2>> section_cut(const PartTriangles& surface, const Transform& section,
                                             double back_m) {
  std::vector<Vec3> placed;
  placed.reserve(surface.vertices.size());
  for (const Vec3& v : surface.vertices) placed.push_back(section.point(v) - Vec3{0, 0, back_m});
  std::vector<std::array<Vec2, 2>> lines;
  for (const auto& triangle : surface.triangles) {
    std::array<Vec2, 2> line;
    size_t ends = 0;
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 &p = placed[triangle[k]], &q = placed[triangle[(k + 1) % 3]];
      // A corner in the plane counts as behind it, so that two sides are crossed or none.
      if ((p.z < 0) == (q.z < 0) || ends == 2) continue;
      const double share = p.z / (p.z - q.z);
      line[ends++] = {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
    }
    if (ends == 2) lines.push_back(line);
  }
  return lines;
}

std::optional<std::array<Vec2, 2>> clipped_to(const Vec2& low, const Vec2& high,
                                              const std::array<Vec2, 2>& line) {
  const Vec2 from = line[0], along = line[1] - line[0];
  double enter = 0, leave = 1;
  const auto keep = [&](double speed, double room) {  // speed * t <= room
    if (speed == 0) return room >= 0;
    if (speed < 0) enter = std::max(enter, room / speed);
    else leave = std::min(leave, room / speed);
    return enter <= leave;
  };
  if (!keep(-along.u, from.u - low.u) || !keep(along.u, high.u - from.u) ||
      !keep(-along.v, from.v - low.v) || !keep(along.v, high.v - from.v))
    return std::nullopt;
  return std::array<Vec2, 2>{from + along * enter, from + along * leave};
}

}  // namespace jalon
