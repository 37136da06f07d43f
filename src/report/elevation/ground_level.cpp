// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/ground_level.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

// A plane that meets the walls is lowest at one of their ends.
double slope_at_walls(const DrawnFace& ground, const Vec3& normal, const ElevationFaces& walls) {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY}, mean;
  const std::vector<Vec2>& corners = ground.rings.front().corners;
  for (const Vec2& p : corners) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
    mean = mean + p * (1 / static_cast<double>(corners.size()));
  }
  if (normal.z == 0) return low.v;
  const auto height_at = [&](double u) {
    const double along = std::clamp(u, low.u, high.u) - mean.u;
    const double rise = (normal.y * ground.depth_m - normal.x * along) / normal.z;
    return std::clamp(mean.v + rise, low.v, high.v);
  };
  return std::min(height_at(walls.wall_low.u), height_at(walls.wall_high.u));
}

}  // namespace

double ground_level(const ElevationFaces& faces, const Model& model, const ElevationView& view) {
  double lowest = INFINITY;
  for (const DrawnFace& face : faces.faces) {
    if (face.role != DrawnFace::Role::kGround) continue;
    const Vec3 normal = view.T_view_world.direction(model.faces[face.face].plane.normal);
    lowest = std::min(lowest, face.kind == DrawnFace::Kind::kEdgeOn
                                  ? std::min(face.edge[0].v, face.edge[1].v)
                                  : slope_at_walls(face, normal, faces));
  }
  // Ground far below is another level (a river, a basement area), and no foot of this facade.
  const double foot = faces.low.v, height = faces.high.v - foot;
  return std::fabs(lowest - foot) < height / 2 ? lowest : foot;
}

}  // namespace jalon
